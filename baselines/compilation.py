"""The equations, compiled as they stand, and kept on disk for as long as they and all that they call stay the same."""

from collections.abc import Callable
from functools import cache
from hashlib import sha256
from types import FunctionType
from typing import Any


def compiled(function: Any) -> Callable:
    """A function, and all functions that it calls, compiled for other compiled functions."""
    return compiler(False).part(function)


def kept(function: Any, fast: bool = False) -> Callable:
    """The same for Python, and kept on disk; if fast, what meets a NaN need not become one."""
    return compiler(fast).entry(function, sha256(repr(code_of(function)).encode()).hexdigest())


@cache
def compiler(fast: bool) -> Any:
    """What knows the functions that are compiled already."""
    from heli_gym.compilation import FAST, Compiler  # takes half a second

    return Compiler(fast=FAST if fast else ())


def code_of(*functions: Any) -> tuple:
    """What functions, and all functions that they call, are compiled from."""
    return tuple(
        (function.__code__.co_code, repr(function.__code__.co_consts), numbers(function), code_of(*calls(function)))
        for function in functions
    )


def calls(function: Any) -> list[FunctionType]:
    """The functions among the globals that a function uses."""
    return [value for value in used(function).values() if isinstance(value, FunctionType)]


def numbers(function: Any) -> str:
    """The numbers among the globals that a function uses."""
    return repr({name: value for name, value in used(function).items() if isinstance(value, int | float | tuple)})


def used(function: Any) -> dict[str, Any]:
    """The globals that a function uses."""
    return {name: function.__globals__[name] for name in function.__code__.co_names if name in function.__globals__}
