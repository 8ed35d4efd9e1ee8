"""Rendering: the rig in perspective, its reference as a ghost, and gauges; imports the modules of `heli_gym` alone.

`Renderer` draws a `RenderState` of plain values, so that it shows any flight, with or without an environment.
"""

from heli_gym.rendering.display import has_display, load_pygame
from heli_gym.rendering.renderer import Renderer
from heli_gym.rendering.scene import RenderState

__all__ = ["RenderState", "Renderer", "has_display", "load_pygame"]
