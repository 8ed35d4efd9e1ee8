"""pygame, imported only where pictures are drawn, and its display."""

import os
from typing import Any

import gymnasium as gym

INVISIBLE = ("dummy", "offscreen")  # SDL's drivers without a screen


def load_pygame() -> Any:
    """Import pygame. Raises gymnasium.error.DependencyNotInstalled without it."""
    try:
        import pygame
        import pygame.gfxdraw
    except ImportError as error:
        raise gym.error.DependencyNotInstalled(
            'pygame is not installed: `pip install "heli-gym[render]"` brings it'
        ) from error
    return pygame


def has_display(pygame: Any) -> bool:
    """Initialise pygame's display, and return whether a window can be seen.

    The environment variable SDL_VIDEODRIVER may choose an invisible driver on purpose, which counts as seen.
    """
    pygame.display.init()
    return pygame.display.get_driver() not in INVISIBLE or bool(os.environ.get("SDL_VIDEODRIVER"))
