"""Differential flatness: travel and elevation are flat outputs of (3), from which all else follows without integration.

(3a) and (3b) give tan(q3) and v1 from the accelerations of both, and two more derivatives of it give v2 by (3c).
"""

import numpy as np
from numpy.polynomial import Polynomial

from heli_gym.baselines.paper.boundary_value import sample_times
from heli_gym.baselines.paper.normal_form import feedforward
from heli_gym.model import fan_thrusts
from heli_gym.trajectory import Maneuver, Trajectory

# From 0 to 1 with four derivatives zero at both ends, so that pitch and its rate are, and the voltages those of hover.
RISE = Polynomial([0.0, 0.0, 0.0, 0.0, 0.0, 126.0, -420.0, 540.0, -315.0, 70.0])

# A jet is a quantity with its first two derivatives by time: (3, K).


def product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The jet of a b."""
    return np.stack((a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + 2.0 * a[1] * b[1] + a[0] * b[2]))


def composed(value: np.ndarray, slope: np.ndarray, curvature: np.ndarray, a: np.ndarray) -> np.ndarray:
    """The jet of a function of a, given that function's value, slope and curvature at a."""
    return np.stack((value, slope * a[1], curvature * a[1] ** 2 + slope * a[2]))


def flat_trajectory(maneuver: Maneuver) -> Trajectory | None:
    """Both flat outputs by one polynomial; None if it would take a negative thrust sum, whatever the limits are."""
    p, t = maneuver.parameters, sample_times(maneuver)
    derivatives = [RISE.deriv(n)(t / maneuver.duration) / maneuver.duration**n for n in range(5)]
    q1, q2 = (
        np.stack([(goal - start) * derivative for derivative in derivatives])
        for start, goal in zip(maneuver.start, maneuver.goal)
    )
    q1[0] += maneuver.start[0]
    q2[0] += maneuver.start[1]
    sin, cos = np.sin(q2[0]), np.cos(q2[0])
    sine, cosine = composed(sin, cos, -sin, q2[:3]), composed(cos, -sin, -cos, q2[:3])
    lift = q2[2:] - p.a1 * sine - p.a2 * cosine  # (3b): b2 cos(q3) v1
    if lift[0].max() >= 0.0:
        return None
    divisor = product(cosine, lift)
    inverse = composed(1.0 / divisor[0], -(divisor[0] ** -2.0), 2.0 * divisor[0] ** -3.0, divisor)
    tangent = p.b2 / p.b1 * product(q1[2:], inverse)  # (3a) by (3b)
    w = tangent[0]
    q3 = composed(np.arctan(w), 1.0 / (1.0 + w**2), -2.0 * w / (1.0 + w**2) ** 2, tangent)
    u = maneuver.rig.voltage(fan_thrusts(feedforward(q2[0], q3[0], q2[2], q3[2], p)))
    return Trajectory(t, np.stack((q1[0], q1[1], q2[0], q2[1], q3[0], q3[1])), u, maneuver.limits, maneuver.rig)
