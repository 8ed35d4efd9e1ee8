"""Definition of the task: action, observation, reward, cost, termination and success.

Pure functions of floats or arrays that broadcast, components first.
"""

import itertools
import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from heli_gym.model import fan_thrusts, hover_input, voltage
from heli_gym.parameters import HelicopterParameters, Limits
from heli_gym.trajectory import Trajectory

PREVIEW = (0.0, 0.1, 0.2, 0.4, 0.8)  # s ahead, at which the observation shows the reference
FEATURES = 8 * len(PREVIEW)  # entries of an observation that depend only on the reference and the time
OBSERVED = 8 + FEATURES  # entries of an observation: tracking error, last voltages, features
TABLE_WIDTH = 8 + FEATURES  # numbers of a reference at one control step: state, nominal voltages, features

# Units of an observation, the same for every plant, reference, rig, control period and limit.
STATE_SCALE = (1.0, 1.0, 0.25, 0.5, 0.5, 2.0)  # rad and rad/s, of tracking errors and of the reference
VOLTAGE_CENTRE, VOLTAGE_SCALE = 6.0, 6.0  # V
TIME_SCALE = 10.0  # s
OBSERVATION_LIMIT = 10.0  # units, saturation of every entry: 10 rad of travel error, 5 rad of pitch, 66 V, 100 s

# Tracking error (travel, elevation, pitch, each with its rate; rad and rad/s) that counts as one in the reward, and
# bound of a successful end of the flight.
TOLERANCE = tuple(math.radians(degrees) for degrees in (3.0, 6.0, 3.0, 6.0, 6.0, 30.0))
EFFORT_SHARE = 0.5  # of the amplifier's range, from the nominal voltage, likewise: 6 V for 0 to 12 V

FARTHEST_START = (1.0, 1.0, 1.0, 1.0, 1.0, 1.0)  # rad and rad/s, between a start and the reference's
HOVER_MARGIN = 0.05  # share of the amplifier's range: closer to an end, hover is not the action zero


def to_voltage(action: Any, voltage_limits: tuple[float, float], hover: Any) -> Any:
    """Convert actions in [-1, 1] to voltages in V: 0 is `hover` in V, -1 and 1 are the amplifier's limits.

    Piecewise linear, element by element; `hover` is one number or the voltages of both fans.
    """
    low, high = voltage_limits
    up, down = 0.5 * (action + abs(action)), 0.5 * (action - abs(action))
    return hover + up * (high - hover) + down * (hover - low)


def to_action(u: Any, voltage_limits: tuple[float, float], hover: Any) -> Any:
    """Convert voltages in V to actions: the inverse of `to_voltage`."""
    low, high = voltage_limits
    off = u - hover
    return 0.5 * (off + abs(off)) / (high - hover) + 0.5 * (off - abs(off)) / (hover - low)


def hover_voltage(parameters: HelicopterParameters, voltage_limits: tuple[float, float]) -> np.ndarray:
    """Voltages (2,) in V that hold (3) at rest with the arm level: the action zero.

    Returns the middle of the amplifier's limits unless hover is within them by HOVER_MARGIN.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        u = voltage(np.array(fan_thrusts(hover_input(0.0, parameters))), parameters)
    return within_limits(u, voltage_limits)


def within_limits(u: Any, voltage_limits: tuple[float, float]) -> np.ndarray:
    """Voltages u; where one is not within the amplifier's limits by HOVER_MARGIN, the middle of these limits."""
    low, high = voltage_limits
    margin = HOVER_MARGIN * (high - low)
    return np.where((low + margin <= u) & (u <= high - margin), u, 0.5 * (low + high))


def observed_error(error: Any) -> tuple:
    """Tracking error (6, ...) in the units of an observation."""
    e1, e2, e3, e4, e5, e6 = error
    s1, s2, s3, s4, s5, s6 = STATE_SCALE
    return e1 / s1, e2 / s2, e3 / s3, e4 / s4, e5 / s5, e6 / s6


def observed_voltage(u: Any) -> Any:
    """Voltages in V in the units of an observation."""
    return (u - VOLTAGE_CENTRE) / VOLTAGE_SCALE


def reward(error: Any, du: Any, voltage_range: Any) -> Any:
    """Reward per second, in (0, 1], of a tracking error (6, ...) in rad and rad/s and voltage deviations du (2, ...).

    The deviations from the nominal voltages are in V, as is the range of the amplifier, its maximum minus its minimum.
    The reward is 1 on the reference and 1/2 where the squared errors, each in units of its tolerance, sum to 1. It is
    positive, so that ending an episode early never pays, and decays slowly, so that it has a gradient far from the
    reference.
    """
    e1, e2, e3, e4, e5, e6 = error
    t1, t2, t3, t4, t5, t6 = TOLERANCE
    squares = (e1 / t1) ** 2 + (e2 / t2) ** 2 + (e3 / t3) ** 2 + (e4 / t4) ** 2 + (e5 / t5) ** 2 + (e6 / t6) ** 2
    effort = EFFORT_SHARE * voltage_range
    return 1.0 / (1.0 + squares + (du[0] / effort) ** 2 + (du[1] / effort) ** 2)


def cost(pitch: Any, u: Any, limits: Limits | Any) -> Any:
    """Excess of pitch in rad and voltages u (2, ...) in V over the limits (9), in limit widths."""
    low, high = limits.u_min, limits.u_max
    return excess(pitch, limits.pitch_min, limits.pitch_max) + excess(u[0], low, high) + excess(u[1], low, high)


def excess(value: Any, low: Any, high: Any) -> Any:
    """Excess of a value over the interval [low, high], in interval widths."""
    outside = abs(value - 0.5 * (low + high)) - 0.5 * (high - low)
    return 0.5 * (outside + abs(outside)) / (high - low)


def crashed(pitch: Any, pitch_limit: float) -> Any:
    """Whether the pitch in rad has left the plant's limit, which ends the flight."""
    return abs(pitch) > pitch_limit


def succeeded(error: Any) -> Any:
    """Whether a tracking error (6, ...) at the end of the maneuver is within the tolerances on every axis."""
    e1, e2, e3, e4, e5, e6 = error
    t1, t2, t3, t4, t5, t6 = TOLERANCE
    first = (abs(e1) <= t1) & (abs(e2) <= t2) & (abs(e3) <= t3)
    return first & (abs(e4) <= t4) & (abs(e5) <= t5) & (abs(e6) <= t6)


def control_steps(duration: float, control_period: float) -> int:
    """Number of control periods of a maneuver; the last one may extend past its end."""
    return max(1, math.ceil(duration / control_period - 1e-9))


def control_grid(reference: Trajectory, control_period: float, ahead: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """Sample a reference on a controller's grid, period in s: states (6, K + 1) and voltages (2, K + 1).

    States are at the start of each period, voltages in its middle, which compensates the mean delay of half a period of
    a held input. `ahead`, in s, shifts both to later times of the reference.
    """
    t = ahead + control_period * np.arange(control_steps(reference.duration, control_period) + 1)
    return reference(t)[0], reference(t + 0.5 * control_period)[1]


def reference_table(reference: Trajectory, control_period: float) -> np.ndarray:
    """Reference at each control step, (TABLE_WIDTH, K + 1): state, nominal voltages, features of the observation.

    The features at each PREVIEW time are the travel relative to now (omitted at 0 s, where it is zero), the other five
    state components and the nominal voltages; the last feature is the remaining time. All are scaled and saturated.
    """
    x, u = control_grid(reference, control_period)
    table = np.empty((TABLE_WIDTH, x.shape[1]))
    table[:6], table[6:8] = x, u
    grids = itertools.chain([(x, u)], (control_grid(reference, control_period, ahead) for ahead in PREVIEW[1:]))
    features = itertools.chain.from_iterable(_seen_ahead(x[0], *grid) for grid in grids)
    for row, feature in enumerate(itertools.islice(features, 1, None), 8):  # one at a time: flights may take hours
        table[row] = feature
    table[-1] = np.maximum(reference.duration - control_period * np.arange(x.shape[1]), 0.0) / TIME_SCALE
    np.clip(table[8:], -OBSERVATION_LIMIT, OBSERVATION_LIMIT, out=table[8:])
    return table


def _seen_ahead(travel: np.ndarray, x: np.ndarray, u: np.ndarray) -> Iterator[np.ndarray]:
    """Yield the features (K,) of states (6, K) and voltages (2, K) to come, the travel relative to the present (K,)."""
    yield from observed_error((x[0] - travel, *x[1:]))
    yield from observed_voltage(u)


def observation_bounds() -> tuple[np.ndarray, np.ndarray]:
    """Lowest and highest observation, (OBSERVED,) each."""
    high = np.full(OBSERVED, OBSERVATION_LIMIT)
    return np.append(-high[:-1], 0.0), high
