"""How the equations are compiled: as they stand, for one kind of number, and kept on disk while they stay the same."""

from collections.abc import Callable, Collection, Mapping
from functools import cache
from hashlib import sha256
from pathlib import Path
from types import FunctionType, MappingProxyType
from typing import Any

import numba
import numpy as np

# not "reassoc", which would undo the reduction in `elementary.sine`
FAST = {"contract", "nnan", "nsz", "arcp"}


class Compiler:
    """Compiles functions together with all that they call, for numbers of one dtype.

    Args:
        dtype: of all literals, for numba takes them for double precision and would compute in that what meets one.
        names: what certain names, `sin` say, mean in all functions.
        loops: functions that are compiled on their own, so that their loops become SIMD before they meet others; all
            others are inlined.
        careful: functions that must not assume that nothing is NaN.
        fast: the liberties that all others take, by LLVM's names.
    """

    def __init__(
        self,
        dtype: type = float,
        names: Mapping[str, Callable] = MappingProxyType({}),
        loops: Collection[Callable] = (),
        careful: Collection[Callable] = (),
        fast: Collection[str] = FAST,
    ) -> None:
        self.dtype, self.names, self.loops, self.careful, self.fast = dtype, names, loops, careful, set(fast)
        self.known: dict[Callable, Callable] = {}

    def entry(self, function: Any, version: str, signature: Any = None) -> Callable:
        """A function that Python calls, kept on disk; with a signature, other arguments are a TypeError.

        The version has to tell apart what may be compiled under this name: numba itself looks only at the function and
        its file, and at the values in its closure, which the version is put into.
        """

        def key() -> str:
            return version

        code = function.__code__
        assert code.co_freevars == ()
        code = code.replace(co_freevars=("version",), co_consts=self.of_dtype(code.co_consts))
        copy = FunctionType(code, self.meanings(function), function.__name__, function.__defaults__, key.__closure__)
        copy.__module__, copy.__qualname__ = function.__module__, function.__qualname__
        return numba.njit(signature, cache=True, error_model="numpy", fastmath=self.fast)(copy)

    def part(self, function: Any) -> Callable:
        """A function that compiled functions call."""
        if function not in self.known:
            code = function.__code__.replace(co_consts=self.of_dtype(function.__code__.co_consts))
            copy = FunctionType(code, self.meanings(function), function.__name__, function.__defaults__)
            fast = set() if function in self.careful else self.fast
            self.known[function] = numba.njit(
                copy, forceinline=function not in self.loops, error_model="numpy", fastmath=fast
            )
        return self.known[function]

    def meanings(self, function: Any) -> dict[str, Any]:
        """The globals of a function: what it calls compiled, its numbers of the dtype."""
        used = {**function.__globals__, **self.names}
        used = {name: value for name, value in used.items() if name in function.__code__.co_names}
        changed = {k: self.part(v) if isinstance(v, FunctionType) else self.of_dtype(v) for k, v in used.items()}
        return {**function.__globals__, **changed}

    def of_dtype(self, constant: Any) -> Any:
        """A number, or a tuple of numbers, of the dtype; anything else as it is."""
        if isinstance(constant, tuple) and not hasattr(constant, "_fields"):
            return tuple(map(self.of_dtype, constant))
        return self.dtype(constant) if type(constant) is float else constant


@cache
def source_version() -> str:
    """A digest of all files that equations and loops are compiled from, and of the libraries that compile them."""
    digest = sha256(f"{numba.__version__} {np.__version__}".encode())
    for name in (
        "compilation",
        "elementary",
        "kernels",
        "model",
        "parameters",
        "plant",
        "rigid_body",
        "simulation",
        "task",
    ):
        digest.update(Path(__file__).with_name(f"{name}.py").read_bytes())
    return digest.hexdigest()
