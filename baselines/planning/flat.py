"""Differential flatness: travel and elevation are flat outputs of (3), from which all else follows without integration.

Their accelerations determine the thrust vector, and so the pitch and v1, by (3a) and (3b); the pitch's acceleration
determines v2, by (3c).
"""

import numpy as np
from numpy.polynomial import Polynomial
from scipy.interpolate import make_interp_spline

from heli_gym.baselines.paper.boundary_value import sample_times
from heli_gym.model import fan_thrusts, inverse_dynamics, thrust_vector
from heli_gym.parameters import Limits
from heli_gym.rig import Rig
from heli_gym.trajectory import Maneuver, Trajectory

# From 0 to 1 with four derivatives zero at both ends, so that pitch and its rate are, and the voltages those of hover.
RISE = Polynomial([0.0, 0.0, 0.0, 0.0, 0.0, 126.0, -420.0, 540.0, -315.0, 70.0])
ROUNDING = 1e-12  # N, by which a lift of zero may be missed


def invert_motion(t: np.ndarray, travel: np.ndarray, elevation: np.ndarray, limits: Limits, rig: Rig) -> Trajectory:
    """The flight through (3) along travel and elevation: (3, K) each, with two derivatives, in rad and s.

    The derivatives of the pitch, which v2 needs, are those of a spline through its values, so that t (K,) must be fine.
    The limits are noted in the trajectory, not enforced.

    Raises ValueError if the elevation falls faster than without thrust.
    """
    (q1, dq1, ddq1), (q2, dq2, ddq2) = travel, elevation
    zero = np.zeros_like(q1)
    across, upright = thrust_vector((q1, dq1, q2, dq2, zero, zero), ddq1, ddq2, rig.parameters)
    if upright.min() < -ROUNDING:
        raise ValueError(f"elevation: falls faster than without thrust, which would have to be {upright.min():g} N")
    upright = np.maximum(upright, 0.0)
    q3 = np.arctan2(across, upright)
    pitch = make_interp_spline(t, q3, k=5)
    x = np.stack((q1, dq1, q2, dq2, q3, pitch.derivative(1)(t)))
    _, v2 = inverse_dynamics(x, ddq2, pitch.derivative(2)(t), rig.parameters)
    return Trajectory(t, x, rig.voltage(fan_thrusts((np.hypot(across, upright), v2))), limits, rig)


def flat_trajectory(maneuver: Maneuver) -> Trajectory | None:
    """Both flat outputs by one polynomial; None if it would take a negative thrust sum, whatever the limits are."""
    t, T = sample_times(maneuver), maneuver.duration
    rise = np.stack([RISE.deriv(n)(t / T) / T**n for n in range(3)])
    travel, elevation = ((goal - start) * rise for start, goal in zip(maneuver.start, maneuver.goal))
    travel[0] += maneuver.start[0]
    elevation[0] += maneuver.start[1]
    try:
        trajectory = invert_motion(t, travel, elevation, maneuver.limits, maneuver.rig)
    except ValueError:
        return None
    x = trajectory.x.copy()
    x[4:, [0, -1]] = 0.0  # exact ends
    return Trajectory(t, x, trajectory.u, maneuver.limits, maneuver.rig)
