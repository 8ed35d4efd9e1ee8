"""Sections III-A and III-C: Byrnes-Isidori normal form (10)-(14) and the input constraints (17)-(23).

The outputs are y1 = q2 (elevation) and y2 = q3 (pitch); eta = q1 (travel) is the internal dynamics.
(13) itself is `heli_gym.model.inverse_dynamics`, and (15), (16) are `heli_gym.rig.Rig.thrust_bounds`. All functions
broadcast; states x are (44), angles in rad, accelerations in rad/s², thrusts and virtual inputs in N.
"""

from typing import Any

import numpy as np

from heli_gym.model import dynamics, inverse_dynamics
from heli_gym.parameters import HelicopterParameters


def alpha1(x: Any, v1: Any, p: HelicopterParameters) -> Any:
    """Equation (11a): second derivative of the elevation, (3b)."""
    return dynamics(x, (v1, 0.0), p)[3]


def alpha2(x: Any, v2: Any, p: HelicopterParameters) -> Any:
    """Equation (11b): second derivative of the pitch, (3c)."""
    return dynamics(x, (0.0, v2), p)[5]


def internal_dynamics(x: Any, ddy1: Any, p: HelicopterParameters, sin: Any = np.sin, cos: Any = np.cos) -> Any:
    """Equation (14a): second derivative of the travel, v1 eliminated from (11c) by (13a)."""
    return dynamics(x, inverse_dynamics(x, ddy1, 0.0, p, sin, cos), p, sin, cos)[1]


def travel_damping(p: HelicopterParameters) -> float:
    """Viscous damping in 1/s of the travel rate in (3a) at level: zero in the paper."""
    still, moving = (dynamics((0.0, rate, 0.0, 0.0, 0.0, 0.0), (0.0, 0.0), p)[1] for rate in (0.0, 1.0))
    return float(still - moving)


def arrival_weights(left: Any, damping: Any) -> tuple[Any, Any]:
    """Share of a travel rate that remains after a time `left` in s under damping, and travel per unit of rate, in s."""
    decay = np.exp(-damping * left)
    return decay, (1.0 - decay) / damping if damping else left


def v2_bounds(f: tuple[float, float]) -> tuple[float, float]:
    """Equation (18): constant bounds of the thrust difference, for fans with the thrust bounds f."""
    f_min, f_max = f
    return f_min - f_max, f_max - f_min


def v1_bounds(v2: Any, f: tuple[float, float]) -> tuple[Any, Any]:
    """Equation (20): bounds of the thrust sum at the thrust difference v2."""
    f_min, f_max = f
    return np.maximum(2.0 * f_min - v2, 2.0 * f_min + v2), np.minimum(2.0 * f_max - v2, 2.0 * f_max + v2)


def ddy1_bounds(x: Any, v2: Any, f: tuple[float, float], p: HelicopterParameters) -> tuple[Any, Any]:
    """Equation (22): bounds of the elevation's second derivative.

    Table I's b2 is negative, so that the lower bound is at the upper bound of v1 (misprinted in the paper); for a
    positive b2, it is at the lower one.
    """
    v1_min, v1_max = v1_bounds(v2, f)
    one, other = alpha1(x, v1_max, p), alpha1(x, v1_min, p)
    return np.minimum(one, other), np.maximum(one, other)


def ddy2_bounds(x: Any, f: tuple[float, float], p: HelicopterParameters) -> tuple[Any, Any]:
    """Equation (23): bounds of the pitch's second derivative."""
    v2_min, v2_max = v2_bounds(f)
    one, other = alpha2(x, v2_min, p), alpha2(x, v2_max, p)
    return np.minimum(one, other), np.maximum(one, other)
