"""The protocol of every controller, policy(t, measurement) -> voltages, and the array helpers that controllers share.

Policies broadcast: they fly one helicopter or N of them, at one time or at N times.
"""

import math
from dataclasses import dataclass, field
from numbers import Real
from typing import Any, Protocol

import numpy as np


class Policy(Protocol):
    """Controller. `reset` clears what it remembers of a flight."""

    def reset(self, rng: np.random.Generator) -> None:
        """Prepare for a new flight; random numbers of the policy come from rng."""

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        """Voltages (2, ...) in V to hold from the time t in s on, given measured states (6, ...) in rad and rad/s."""


class MemorylessPolicy:
    """Base of policies whose voltages depend on the time and the measurement alone."""

    def reset(self, rng: np.random.Generator) -> None:
        """Do nothing: there is no memory to clear."""


@dataclass(eq=False)
class StatefulPolicy:
    """Base of policies with a memory, which is an explicit value: `step` maps a memory to the next one.

    A subclass defines `init` and `step`, both without side effects. `policy(t, measurement)` keeps the memory of one
    flight (or of one batch of flights); who flies several sets of helicopters with one policy calls `step` directly.
    """

    memory: Any = field(default=None, init=False, repr=False)

    def init(self, t: float | np.ndarray, measurement: np.ndarray) -> Any:
        """Memory before the first step of a flight that starts at the time t in s with this measurement (6, ...)."""
        raise NotImplementedError

    def step(self, memory: Any, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, Any]:
        """Voltages (2, ...) in V at the time t in s, and the next memory."""
        raise NotImplementedError

    def reset(self, rng: np.random.Generator) -> None:
        """Forget the last flight."""
        self.memory = None

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        measurement = np.asarray(measurement, dtype=float)
        memory = self.init(t, measurement) if self.memory is None else self.memory
        u, self.memory = self.step(memory, t, measurement)
        return u


def is_finite(value: Any) -> bool:
    """Whether the value is a real number that a float can hold."""
    try:
        return isinstance(value, Real) and not isinstance(value, bool) and math.isfinite(value)
    except OverflowError:
        return False


def expand_batch_dims(column: np.ndarray, measurement: np.ndarray) -> np.ndarray:
    """Reshape the column (n,), or columns (n, N), so that it broadcasts with a measurement (6, ...)."""
    return column if column.ndim > 1 else column.reshape(-1, *(1,) * (measurement.ndim - 1))


def apply_gains(gains: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Multiply gains (m, n), or (m, n, N) of N times, by values (n, ...)."""
    return gains @ values if gains.ndim == 2 else np.einsum("ijk,jk->ik", gains, values)


def step_index(t: Any, control_period: float, last: int) -> Any:
    """Index of the control period, at most `last`, of the time t in s; (N,) for N times."""
    if np.ndim(t):
        return np.minimum(np.round(np.asarray(t) / control_period).astype(int), last)
    return min(round(t / control_period), last)


def assign_columns(old: Any, new: Any, columns: np.ndarray) -> Any:
    """Replace these columns of arrays (..., N), or of tuples of arrays, by arrays (..., n)."""
    if isinstance(old, tuple):
        parts = [assign_columns(a, b, columns) for a, b in zip(old, new)]
        return type(old)(*parts) if hasattr(old, "_fields") else tuple(parts)
    if old is None:
        return None
    result = old.copy()
    result[..., columns] = new
    return result


def select_columns(values: Any, columns: np.ndarray) -> Any:
    """Select these columns of arrays (..., N), or of tuples of arrays."""
    if isinstance(values, tuple):
        parts = [select_columns(value, columns) for value in values]
        return type(values)(*parts) if hasattr(values, "_fields") else tuple(parts)
    return None if values is None else values[..., columns]
