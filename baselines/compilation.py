"""The equations, compiled as they stand, and kept on disk for as long as they and all that they call stay the same."""

from collections.abc import Callable
from functools import cache
from typing import Any


def jit_cached(function: Any, fast: bool = False) -> Callable:
    """A function and all that it calls, compiled for Python; if fast, what meets a NaN need not become one."""
    return compiler(fast).entry(function)


@cache
def compiler(fast: bool = False) -> Any:
    """What knows the functions that are compiled already."""
    from heli_gym.compilation import FAST, Compiler  # takes half a second

    return Compiler(fast=FAST if fast else ())
