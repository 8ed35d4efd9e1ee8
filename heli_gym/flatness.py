"""Differential flatness: travel and elevation are flat outputs of (3) and determine states and inputs algebraically.

By (3a) and (3b), their accelerations determine the thrust vector, hence pitch and v1; by (3c), the pitch acceleration
determines v2.
"""

from collections.abc import Callable
from itertools import pairwise

import numpy as np
from numpy.polynomial import Polynomial
from scipy.interpolate import make_interp_spline

from heli_gym.model import fan_thrusts, inverse_dynamics, thrust_vector
from heli_gym.parameters import Limits
from heli_gym.rig import Rig
from heli_gym.trajectory import Trajectory, concatenate

# Rises from 0 to 1 with four zero derivatives at both ends: pitch and its rate vanish there, and hover voltages hold.
RISE = Polynomial([0.0, 0.0, 0.0, 0.0, 0.0, 126.0, -420.0, 540.0, -315.0, 70.0])
ROUNDING = 1e-12  # N, tolerance of a zero lift
AT_REST = 1e-9  # rad and rad/s, of rates and pitch
SAMPLE_PERIOD = 0.01  # s, of the trajectory that `replanned` returns
STRETCH, STRETCHES = 1.1, 40  # slow-down factor per attempt, and number of attempts

Motion = Callable[[np.ndarray, float], tuple[np.ndarray, np.ndarray]]


def invert_motion(t: np.ndarray, travel: np.ndarray, elevation: np.ndarray, limits: Limits, rig: Rig) -> Trajectory:
    """Trajectory of (3) along travel and elevation, each (3, K) with two derivatives, in rad and s.

    The pitch derivatives in v2 are those of a spline through the pitch samples, so t (K,) must be a fine grid. The
    limits are stored in the trajectory, not enforced.

    Raises ValueError if the elevation accelerates downwards faster than without thrust.
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


def replanned(reference: Trajectory, rig: Rig) -> Trajectory:
    """Plan the same motion for another rig within its limits; slow it down if the rig cannot fly it otherwise.

    If the reference starts and ends at rest, each leg from rest to rest becomes a smooth polynomial of the flat
    outputs; any other motion retains its shape. For a rig whose elevation is positive upwards, elevations change sign.

    Raises ValueError if the rig cannot fly it at any of the speeds tried.
    """
    x = reference.x.copy()
    if rig.parameters.b2 > 0.0:
        x[2:4] *= -1.0
    resting = np.flatnonzero(np.abs(x[[1, 3, 4, 5]]).max(axis=0) <= AT_REST)
    if len(resting) == 0 or resting[0] != 0 or resting[-1] != len(reference.t) - 1:
        return slowed(motion_of_samples(reference.t, x), reference.duration, rig)
    legs = [
        slowed(rest_to_rest_motion(x[0::2, a], x[0::2, b]), float(reference.t[b] - reference.t[a]), rig)
        for a, b in pairwise(resting)
    ]
    whole = legs[0]
    for leg in legs[1:]:
        whole = concatenate(whole, leg)
    return whole


def rest_to_rest_motion(start: np.ndarray, goal: np.ndarray) -> Motion:
    """Rest-to-rest motion between angles (3,): travel and elevation, (3, K) each, over a duration in s."""

    def motion(t: np.ndarray, duration: float) -> tuple[np.ndarray, np.ndarray]:
        rise = np.stack([RISE.deriv(n)(t / duration) / duration**n for n in range(3)])
        travel, elevation = ((goal[axis] - start[axis]) * rise for axis in (0, 1))
        travel[0] += start[0]
        elevation[0] += start[1]
        return travel, elevation

    return motion


def motion_of_samples(times: np.ndarray, x: np.ndarray) -> Motion:
    """Motion with the travel and elevation of the states (6, K) at the times (K,), scaled to any duration."""
    splines = [make_interp_spline(times / times[-1], x[row], k=5) for row in (0, 2)]

    def motion(t: np.ndarray, duration: float) -> tuple[np.ndarray, np.ndarray]:
        share = t / duration
        travel, elevation = (
            np.stack([spline.derivative(n)(share) / duration**n if n else spline(share) for n in range(3)])
            for spline in splines
        )
        return travel, elevation

    return motion


def slowed(motion: Motion, duration: float, rig: Rig) -> Trajectory:
    """Trajectory of the motion in this duration in s or, if that exceeds the rig's limits, in a longer one."""
    (u_min, u_max), (pitch_min, pitch_max) = rig.limits.u, rig.limits.pitch
    for _ in range(STRETCHES):
        t = np.linspace(0.0, duration, 1 + max(round(duration / SAMPLE_PERIOD), 10))
        try:
            flight = invert_motion(t, *motion(t, duration), rig.limits, rig)
        except ValueError:
            pass
        else:
            u, pitch = flight.u, flight.x[4]
            if u_min <= u.min() and u.max() <= u_max and pitch_min <= pitch.min() and pitch.max() <= pitch_max:
                x = flight.x.copy()
                for end in (0, -1):
                    if np.abs(x[[1, 3], end]).max() <= AT_REST:
                        x[[1, 3, 4, 5], end] = 0.0
                return Trajectory(t, x, flight.u, rig.limits, rig)
        duration *= STRETCH
    raise ValueError(f"reference: must be one that the rig {rig.name!r} can fly within {rig.limits}, however slowly")
