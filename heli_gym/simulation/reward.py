"""Reference, reward and end of the flight in loops over the helicopters of a block; see `task`."""

from typing import Any, NamedTuple

from heli_gym.model import axpy
from heli_gym.simulation.layout import (
    COMMAND,
    LAST,
    LIMITS,
    NOMINAL,
    NOT_NEGATIVE,
    PITCH_LIMITS,
    REFERENCE,
    REFERENCE_ROW,
    REWARD,
    ROW,
    STEP,
    SUCCEEDED,
    TERMINATED,
    TIME,
    Settings,
    X,
    put_six,
    put_two,
    six,
    two,
)
from heli_gym.task import TABLE_WIDTH, cost, crashed, reward, succeeded


class LimitArrays(NamedTuple):
    """Limits read by `task.cost`."""

    u_min: Any
    u_max: Any
    pitch_min: Any
    pitch_max: Any


def look_up_reference(block: Any, n: int, s: Settings, table: Any) -> None:
    """Advance to the next step, and look up the reference's state there and the nominal voltages before it."""
    for i in range(n):
        at = reference_row(block, i)
        put_two(block, NOMINAL, i, (table[at + 6], table[at + 7]))
        at += TABLE_WIDTH
        x_ref = (table[at], table[at + 1], table[at + 2], table[at + 3], table[at + 4], table[at + 5])
        put_six(block, REFERENCE, i, x_ref)
        step = block[STEP * ROW + i] + 1.0
        block[STEP * ROW + i], block[TIME * ROW + i] = step, s.period * step


def compute_reward(block: Any, n: int, s: Settings) -> None:
    """Compute reward, cost and the end of the flight."""
    for i in range(n):
        x, (u_f, u_b) = six(block, X, i), two(block, COMMAND, i)
        x_ref, (nominal_f, nominal_b) = six(block, REFERENCE, i), two(block, NOMINAL, i)
        limits = LimitArrays(*two(block, LIMITS, i), *two(block, PITCH_LIMITS, i))
        step, last = block[STEP * ROW + i], block[LAST * ROW + i]
        error = axpy(x, -1.0, x_ref)
        earned = s.period * reward(error, (u_f - nominal_f, u_b - nominal_b), s.u_high - s.u_low)
        spent = s.period * cost(x[4], (u_f, u_b), limits)
        terminated = 1.0 if crashed(x[4], s.pitch_limit) else 0.0
        truncated = 1.0 - terminated if step == last else 0.0
        put_two(block, REWARD, i, (earned, spent))
        put_two(block, TERMINATED, i, (terminated, truncated))
        block[SUCCEEDED * ROW + i] = truncated if succeeded(error) else 0.0


def reference_row(block: Any, i: int) -> int:
    """Start of the current row of the reference of the helicopter i in the flat table, at most its last row."""
    step = min(block[STEP * ROW + i], block[LAST * ROW + i])
    return TABLE_WIDTH * ((int(block[REFERENCE_ROW * ROW + i]) + int(step)) & NOT_NEGATIVE)
