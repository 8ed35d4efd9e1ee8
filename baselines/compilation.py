"""The equations, compiled as they stand by numba, and kept on disk for as long as they stay the same."""

from collections.abc import Callable
from functools import cache
from types import FunctionType
from typing import Any


@cache
def compiled(function: Any) -> Callable:
    """A function, and all functions that it calls, compiled."""
    from numba import njit

    return njit(error_model="numpy")(with_compiled_calls(function))


def kept(function: Any) -> Callable:
    """The same, and kept on disk, under a key that includes what is in the function's closure.

    That has to be a `version` of all equations that are called, by `code_of`: numba looks at the function's own file.
    Calls have to be of globals: of what is compiled, a closure would hold another identity in every process.
    """
    from numba import njit

    assert "version" in function.__code__.co_freevars
    return njit(error_model="numpy", cache=True)(with_compiled_calls(function))


def with_compiled_calls(function: Any) -> FunctionType:
    """The function, calling compiled functions."""
    called = {name: compiled(value) for name, value in calls(function).items()}
    return FunctionType(
        function.__code__,
        {**function.__globals__, **called},
        function.__name__,
        function.__defaults__,
        function.__closure__,
    )


def calls(function: Any) -> dict[str, FunctionType]:
    """The functions among the globals that a function uses."""
    names = {name: function.__globals__.get(name) for name in function.__code__.co_names}
    return {name: value for name, value in names.items() if isinstance(value, FunctionType)}


def code_of(*functions: Any) -> tuple:
    """What functions, and all functions that they call, are compiled from."""
    return tuple(
        (function.__code__.co_code, repr(function.__code__.co_consts), code_of(*calls(function).values()))
        for function in functions
    )
