"""Checks of arguments: which values count as numbers, and how messages show a refused value."""

import math
import os
from numbers import Real
from pathlib import Path
from typing import Any

import numpy as np

LONGEST_SHOWN = 200  # characters of a refused value in a message


def is_number(value: Any) -> bool:
    """Whether the value is a finite real number within the range of a float; no boolean."""
    try:
        return isinstance(value, Real) and not isinstance(value, bool) and math.isfinite(value)
    except OverflowError:
        return False


def real_array(values: Any) -> np.ndarray | None:
    """Convert values to an array of floats; None unless they are real numbers (no booleans, text or objects)."""
    try:
        array = np.asarray(values)
    except (TypeError, ValueError, OverflowError):
        return None
    return array.astype(float) if array.dtype.kind in "iuf" else None


def require(name: str, value: Any, allowed: bool, what: str) -> None:
    """Raise ValueError unless the value is a finite number and allowed."""
    if not is_number(value) or not allowed:
        raise ValueError(f"{name} = {shown(value)}: must be {what}{'' if is_number(value) else ', and finite'}")


def shown(value: Any) -> str:
    """The value for a message, shortened."""
    try:
        text = repr(value)
    except ValueError:  # an integer of more digits than Python converts
        return f"a number of more than {10**3} digits"
    return text if len(text) <= LONGEST_SHOWN else f"{text[:LONGEST_SHOWN]}..."


def as_path(name: str, value: Any) -> Path:
    """The value as a path. Raises ValueError unless it is text or a path without null characters."""
    if not isinstance(value, str | os.PathLike) or "\0" in os.fspath(value):
        raise ValueError(f"{name} = {shown(value)}: must be a path")
    return Path(value)
