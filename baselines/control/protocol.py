"""Protocol of all controllers, policy(t, measurement) -> voltages, and their shared array helpers.

Policies broadcast: they fly one helicopter or N helicopters, at one time or at N times.
"""

from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np


class Policy(Protocol):
    """Controller; `reset` clears its memory of a flight."""

    def reset(self, rng: np.random.Generator) -> None:
        """Prepare for a new flight; the policy draws random numbers from rng."""

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        """Voltages (2, ...) in V from the time t in s on, given measured states (6, ...) in rad and rad/s."""


class MemorylessPolicy:
    """Base of policies whose voltages depend only on the time and the measurement."""

    def reset(self, rng: np.random.Generator) -> None:
        """Do nothing: there is no memory to clear."""


@dataclass(eq=False)
class StatefulPolicy:
    """Base of policies with an explicit memory value: `step` maps a memory to the next one.

    A subclass defines `init` and `step`, both without side effects. `policy(t, measurement)` stores the memory of one
    flight or one batch of flights; a caller with several batches calls `step` directly.
    """

    memory: Any = field(default=None, init=False, repr=False)

    def init(self, t: float | np.ndarray, measurement: np.ndarray) -> Any:
        """Memory before the first step of a flight, given its start time t in s and first measurement (6, ...)."""
        raise NotImplementedError

    def step(self, memory: Any, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, Any]:
        """Voltages (2, ...) in V at the time t in s, and the next memory."""
        raise NotImplementedError

    def reset(self, rng: np.random.Generator) -> None:
        """Clear the memory of the last flight."""
        self.memory = None

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        measurement = np.asarray(measurement, dtype=float)
        memory = self.init(t, measurement) if self.memory is None else self.memory
        u, self.memory = self.step(memory, t, measurement)
        return u


def expand_batch_dims(column: np.ndarray, measurement: np.ndarray) -> np.ndarray:
    """Reshape a column (n,) to broadcast with a measurement (6, ...); columns (n, N) stay as they are."""
    return column if column.ndim > 1 else column.reshape(-1, *(1,) * (measurement.ndim - 1))


def apply_gains(gains: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Product (m, ...) of gains (m, n), or (m, n, N), and values (n, ...)."""
    return gains @ values if gains.ndim == 2 else np.einsum("ijk,jk->ik", gains, values)


def step_index(t: Any, control_period: float, last: int) -> Any:
    """Index of the control period at the time t in s, from 0 to `last`; (N,) for N times."""
    if np.ndim(t):
        return np.clip(np.round(np.asarray(t) / control_period).astype(int), 0, last)
    return min(max(round(t / control_period), 0), last)


def assign_columns(old: Any, new: Any, columns: np.ndarray) -> Any:
    """Copy of arrays (..., N), or tuples of arrays, with the given columns replaced by arrays (..., n)."""
    if isinstance(old, tuple):
        parts = [assign_columns(a, b, columns) for a, b in zip(old, new)]
        return type(old)(*parts) if hasattr(old, "_fields") else tuple(parts)
    if old is None:
        return None
    result = old.copy()
    result[..., columns] = new
    return result


def select_columns(values: Any, columns: np.ndarray) -> Any:
    """Given columns (..., n) of arrays (..., N), or of tuples of arrays."""
    if isinstance(values, tuple):
        parts = [select_columns(value, columns) for value in values]
        return type(values)(*parts) if hasattr(values, "_fields") else tuple(parts)
    return None if values is None else values[..., columns]
