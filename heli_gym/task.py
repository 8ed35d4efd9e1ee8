"""What the environment asks for: action, observation, reward, cost, termination and success.

Pure functions that broadcast: components first, floats or arrays alike.
"""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from heli_gym.parameters import HelicopterParameters, Limits
from heli_gym.plant import AXES, Disturbance, Gust, MovingMass, Plant, Push, magnitude
from heli_gym.trajectory import Trajectory

PREVIEW = (0.0, 0.1, 0.2, 0.4, 0.8)  # s ahead, at which the observation shows the reference
FEATURES = 8 * len(PREVIEW) + 1  # numbers that it shows: states and voltages, and the remaining time

# The tracking error (travel, elevation, pitch, each with its rate; rad and rad/s) that counts as one in the reward,
# and within which the flight has succeeded at its end.
TOLERANCE = tuple(math.radians(degrees) for degrees in (3.0, 6.0, 3.0, 6.0, 6.0, 30.0))
EFFORT_TOLERANCE = 6.0  # V, from the nominal voltage, likewise

FARTHEST_START = (1.0, 1.0, 1.0, 1.0, 1.0, 1.0)  # rad and rad/s, between a start and the reference's
FARTHEST_DRAWN = (math.tau, 1.0, 1.0, 1.0, 1.0, 1.0)  # rad and rad/s, where references that are drawn start at most
GUST_DEVIATIONS = 6.0  # standard deviations of a gust, which has no bound, that the observation's bounds allow


def to_voltage(action: Any, voltage_limits: tuple[float, float]) -> Any:
    """Voltages in V of actions: -1 and 1 are the amplifier's limits."""
    low, high = voltage_limits
    return 0.5 * (low + high) + 0.5 * (high - low) * action


def to_action(u: Any, voltage_limits: tuple[float, float]) -> Any:
    """Actions of voltages in V, the inverse of `to_voltage`."""
    low, high = voltage_limits
    return (u - 0.5 * (low + high)) / (0.5 * (high - low))


def reward(error: Any, du: Any) -> Any:
    """One second's reward, in (0, 1], at a tracking error (6, ...) in rad and rad/s and voltages du (2, ...) in V from
    the nominal ones.

    1 on the reference, 1/2 where the squares of all errors, each in units of its tolerance, add up to 1. It is never
    negative, so that ending an episode early never pays, and falls slowly, so that it tells better from worse far away.
    """
    e1, e2, e3, e4, e5, e6 = error
    t1, t2, t3, t4, t5, t6 = TOLERANCE
    squares = (e1 / t1) ** 2 + (e2 / t2) ** 2 + (e3 / t3) ** 2 + (e4 / t4) ** 2 + (e5 / t5) ** 2 + (e6 / t6) ** 2
    return 1.0 / (1.0 + squares + (du[0] / EFFORT_TOLERANCE) ** 2 + (du[1] / EFFORT_TOLERANCE) ** 2)


def cost(pitch: Any, u: Any, limits: Limits | Any) -> Any:
    """How far pitch in rad and voltages u (2, ...) in V are outside the limits (9), in widths of the limits."""
    low, high = limits.u_min, limits.u_max
    return excess(pitch, limits.pitch_min, limits.pitch_max) + excess(u[0], low, high) + excess(u[1], low, high)


def excess(value: Any, low: Any, high: Any) -> Any:
    """How far a value is outside of [low, high], in widths of that."""
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
    """How many control periods a maneuver takes; the last one may outlast it."""
    return max(1, math.ceil(duration / control_period - 1e-9))


def control_grid(reference: Trajectory, control_period: float, ahead: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """A reference on the grid of a controller with this period in s: states (6, K + 1) and voltages (2, K + 1).

    With `ahead`, that many seconds early.
    States at the start of each period, voltages in its middle: an input that is held for a period is half a period
    late on average, and this makes up for it.
    """
    t = ahead + control_period * np.arange(control_steps(reference.duration, control_period) + 1)
    return reference(t)[0], reference(t + 0.5 * control_period)[1]


def reference_features(reference: Trajectory, control_period: float) -> np.ndarray:
    """What the observation shows of the reference at each control step: (8 len(PREVIEW) + 1, K + 1).

    State and nominal voltages at each time of PREVIEW ahead, then the remaining time.
    """
    seen = [row for ahead in PREVIEW for row in control_grid(reference, control_period, ahead)]
    t = control_period * np.arange(seen[0].shape[1])
    return np.concatenate((*seen, np.maximum(reference.duration - t, 0.0)[None]))


class FeatureBounds(NamedTuple):
    """What references show at most, in absolute values."""

    start: np.ndarray  # (6,) states at the start
    features: np.ndarray  # (8 len(PREVIEW) + 1,)


def feature_bounds(features: np.ndarray) -> FeatureBounds:
    """What a reference with these features (8 len(PREVIEW) + 1, K + 1) shows."""
    features = np.abs(features)
    return FeatureBounds(features[:6, 0], features.max(axis=1))


def sampler_bounds(duration: float, voltage_limits: tuple[float, float], pitch_limit: float) -> FeatureBounds:
    """What references of at most this duration in s show that obey (3) from a start within `FARTHEST_DRAWN`."""
    start = np.array(FARTHEST_DRAWN)
    u_max = np.abs(voltage_limits).max()
    state = reachable_bound(start, greatest_acceleration(HelicopterParameters(), u_max), duration)
    state[4] = pitch_limit
    return FeatureBounds(start, np.array([*state, u_max, u_max] * len(PREVIEW) + [duration]))


def greatest_acceleration(p: HelicopterParameters, u_max: float) -> np.ndarray:
    """The accelerations (3,) in rad/s² that (3) cannot exceed with voltages up to u_max in V.

    Parameters may be ranges: each term grows with the magnitude of every parameter in it, and so is greatest in a
    corner.
    """
    k_plus, k_minus, a1, a2, a3, b1, b2, b3, *_ = map(magnitude, p)  # friction only slows down
    v_max = 2.0 * max(k_plus, k_minus) * u_max**2
    return np.array([b1 * v_max, a1 + a2 + b2 * v_max, a3 + b3 * v_max])


def greatest_disturbance(disturbances: Sequence[Disturbance]) -> np.ndarray:
    """The accelerations (3,) in rad/s² that disturbances cannot exceed, all at once: see GUST_DEVIATIONS for gusts."""
    acceleration = dict.fromkeys(AXES, 0.0)
    for value in disturbances:
        match value:
            case Push(axis, amount):
                acceleration[axis] += magnitude(amount)
            case Gust(axis, strength):
                acceleration[axis] += GUST_DEVIATIONS * magnitude(strength)
            case MovingMass(a2_change):
                acceleration["elevation"] += magnitude(a2_change)
    return np.array(list(acceleration.values()))


def reachable_bound(start: np.ndarray, acceleration: np.ndarray, duration: float) -> np.ndarray:
    """States (6,) that cannot be exceeded in a duration in s, from a start (6,) at accelerations (3,)."""
    rate = start[1::2] + acceleration * duration
    angle = start[0::2] + (start[1::2] + 0.5 * acceleration * duration) * duration
    return np.stack((angle, rate), axis=1).ravel()


def observation_bound(
    feature_bound: FeatureBounds,
    plant: Plant,
    voltage_limits: tuple[float, float],
    pitch_limit: float,
    control_period: float,
) -> np.ndarray:
    """Bounds (8 + features,) on the absolute value of the observation that no flight of the plant can exceed.

    Rates grow by the greatest acceleration that (3) and the amplifier allow, for the whole duration; pitch ends the
    flight at its limit, one control period late at most. Whatever a plant adds to (3) is allowed as much again, and
    its disturbances on top of that, all of them all the time. Gusts are normally distributed and have no bound: they
    are allowed GUST_DEVIATIONS standard deviations, for the whole duration too, which no flight comes near.
    """
    u_max = np.abs(voltage_limits).max()
    accelerations = [
        greatest_acceleration(q.parameters, u_max) * (1.0 if q.is_plain else 2.0) + greatest_disturbance(q.disturbances)
        for q in plant.alternatives
    ]
    acceleration = np.max(accelerations, axis=0)
    duration = control_period * (control_steps(feature_bound.features[-1], control_period) + 1)
    state = reachable_bound(feature_bound.start + FARTHEST_START, acceleration, duration)
    state[4] = pitch_limit + state[5] * control_period
    return np.concatenate(
        (state + feature_bound.features[:6], np.maximum(u_max, feature_bound.features[6:8]), feature_bound.features)
    )
