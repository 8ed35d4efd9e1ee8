"""Compile unmodified Python equations for one dtype; the disk cache is valid until a function or constant changes."""

import logging
import warnings
from collections.abc import Callable, Collection, Mapping
from contextlib import suppress
from functools import cache
from hashlib import sha256
from types import CodeType, FunctionType, MappingProxyType
from typing import Any

import numba
import numpy as np

# without "reassoc", which would undo the argument reduction in `fast_math.sine`
FAST = {"contract", "nnan", "nsz", "arcp"}


class Compiler:
    """Compile functions, together with the functions that they call, for numbers of one dtype.

    Args:
        dtype: type of all literals, which numba would otherwise compile in double precision.
        names: values to which global names, for example `sin`, are bound in all functions.
        loops: functions compiled separately, so that LLVM vectorises their loops first; all others are inlined.
        careful: functions compiled without fast-math, because their values may be NaN or infinite.
        fast: LLVM's fast-math flags for all other functions.
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

    def entry(self, function: Any, signature: Any = None, nogil: bool = False) -> Callable:
        """Compile a function for calls from Python, cached on disk; a signature makes other arguments a TypeError.

        With `nogil`, other Python threads run during a call. Numba's cache key is the function's file and the values in
        its closure; a digest of all called functions in that closure makes the key change with them.
        """
        version = self.version(function)

        def key() -> str:
            return version

        code = function.__code__
        assert code.co_freevars == ()
        code = code.replace(co_freevars=("version",), co_consts=self.of_dtype(code.co_consts))
        copy = FunctionType(code, self.meanings(function), function.__name__, function.__defaults__, key.__closure__)
        copy.__module__, copy.__qualname__ = function.__module__, function.__qualname__
        compiled = numba.njit(error_model="numpy", fastmath=self.fast, nogil=nogil)(copy)
        cache_on_disk(compiled)
        if signature is not None:
            compiled.compile(signature)
            compiled.disable_compile()
        return compiled

    def version(self, function: Any) -> str:
        """Digest of a function, the functions that it calls, their constants, and the compiler options."""
        found: dict[Any, tuple] = {}
        waiting = [function]
        while waiting:
            one = waiting.pop()
            if one not in found:
                used = self.used(one)
                calls = {name: value for name, value in used.items() if isinstance(value, FunctionType)}
                numbers = {name: value for name, value in used.items() if isinstance(value, int | float | tuple)}
                fields = {name: value._fields for name, value in used.items() if hasattr(value, "_fields")}
                names = {name: value.__qualname__ for name, value in calls.items()}
                how = one in self.loops, one in self.careful
                found[one] = (one.__qualname__, *contents(one.__code__), names, numbers, fields, how)
                waiting += calls.values()
        parts = sorted(map(repr, found.values()))
        whole = (numba.__version__, np.__version__, self.dtype.__name__, sorted(self.fast), parts)
        return sha256(repr(whole).encode()).hexdigest()

    def part(self, function: Any) -> Callable:
        """Compile a function for calls from compiled functions."""
        if function not in self.known:
            code = function.__code__.replace(co_consts=self.of_dtype(function.__code__.co_consts))
            copy = FunctionType(code, self.meanings(function), function.__name__, function.__defaults__)
            fast = set() if function in self.careful else self.fast
            self.known[function] = numba.njit(
                copy, forceinline=function not in self.loops, error_model="numpy", fastmath=fast
            )
        return self.known[function]

    def meanings(self, function: Any) -> dict[str, Any]:
        """Globals of a function, with called functions compiled and numbers converted to the dtype."""
        used = self.used(function)
        changed = {k: self.part(v) if isinstance(v, FunctionType) else self.of_dtype(v) for k, v in used.items()}
        return {**function.__globals__, **changed}

    def used(self, function: Any) -> dict[str, Any]:
        """Globals that a function uses, sorted by name."""
        known = {**function.__globals__, **self.names}
        return {name: known[name] for name in sorted(function.__code__.co_names) if name in known}

    def of_dtype(self, constant: Any) -> Any:
        """Convert a number or a tuple of numbers to the dtype; return anything else unchanged."""
        if isinstance(constant, tuple) and not hasattr(constant, "_fields"):
            return tuple(map(self.of_dtype, constant))
        return self.dtype(constant) if type(constant) is float else constant


class Cache:
    """Numba's cache of a function; where reading or writing fails, it warns and the function is compiled again.

    An index that cannot be read is replaced.
    """

    def __init__(self, cache: Any) -> None:
        self.cache = cache

    def __getattr__(self, name: str) -> Any:
        return getattr(self.cache, name)

    def load_overload(self, *arguments: Any) -> Any:
        """Load a compiled function; None if the cache has no readable one."""
        try:
            loaded = self.cache.load_overload(*arguments)
        except Exception as error:  # numba unpickles the file: a damaged one raises anything
            warn_uncached(f"cannot be read: {error!r}")
            loaded = None
            with suppress(Exception):
                self.cache.flush()  # an empty index: the next process finds what this one saves
        if loaded is None:
            announce_compilation()
        return loaded

    def save_overload(self, *arguments: Any) -> None:
        """Save a compiled function; warn if that fails."""
        try:
            self.cache.save_overload(*arguments)
        except Exception as error:  # a full or read-only disk, or a damaged index
            warn_uncached(f"cannot be written: {error!r}")


def cache_on_disk(compiled: Any) -> None:
    """Let numba cache a compiled function on disk; warn if it finds no writable folder."""
    try:
        compiled.enable_caching()
    except RuntimeError as error:  # numba finds no folder that it may write to
        warn_uncached(f"cannot be written: {error}")
        announce_compilation()
    else:
        compiled._cache = Cache(compiled._cache)


@cache
def announce_compilation() -> None:
    """Print once per process that compilation is running."""
    logging.getLogger("heli_gym").warning("heli_gym: compiling, about 10 s; later runs load what is compiled")


def warn_uncached(reason: str) -> None:
    """Warn once per process that compiled functions are not cached."""
    if not warned:
        warned.append(reason)
        message = f"the cache of compiled functions {reason}; they are compiled again in each process"
        warnings.warn(message, RuntimeWarning, stacklevel=2)


warned: list[str] = []


def contents(code: CodeType) -> tuple:
    """Contents of a code object, independent of its address in memory."""
    constants = [contents(value) if isinstance(value, CodeType) else repr(value) for value in code.co_consts]
    return code.co_code, constants, code.co_names


@cache
def compiler(fast: bool = False) -> Compiler:
    """Double-precision compiler shared by all modules, so that each function is compiled once."""
    return Compiler(fast=FAST if fast else ())


def jit_cached(function: Any, fast: bool = False) -> Callable:
    """Compile a function with all that it calls, cached on disk; `fast` assumes that no value is NaN."""
    return compiler(fast).entry(function)
