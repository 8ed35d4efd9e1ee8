"""Differential flatness: travel and elevation are flat outputs of (3), from which all else follows without integration.

Their accelerations determine the thrust vector, and so the pitch and v1, by (3a) and (3b); the pitch's acceleration
determines v2, by (3c).
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

# From 0 to 1 with four derivatives zero at both ends, so that pitch and its rate are, and the voltages those of hover.
RISE = Polynomial([0.0, 0.0, 0.0, 0.0, 0.0, 126.0, -420.0, 540.0, -315.0, 70.0])
ROUNDING = 1e-12  # N, by which a lift of zero may be missed
AT_REST = 1e-9  # rad and rad/s, of rates and pitch
SAMPLE_PERIOD = 0.01  # s, of what `replanned` returns
STRETCH, STRETCHES = 1.1, 40  # by which a motion is slowed down until a rig can fly it, and how often at most

Motion = Callable[[np.ndarray, float], tuple[np.ndarray, np.ndarray]]


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


def replanned(reference: Trajectory, rig: Rig) -> Trajectory:
    """The same motion for another rig within its limits, slower where it must be.

    Where the reference starts and ends at rest, its legs from rest to rest become smooth polynomials of the flat
    outputs; another motion keeps its shape. For a rig whose elevation is positive upwards, elevations change sign.

    Raises ValueError if the rig cannot fly it at any of the speeds that are tried.
    """
    x = reference.x.copy()
    if rig.parameters.b2 > 0.0:
        x[2:4] *= -1.0
    resting = np.flatnonzero(np.abs(x[[1, 3, 4, 5]]).max(axis=0) <= AT_REST)
    if len(resting) == 0 or resting[0] != 0 or resting[-1] != len(reference.t) - 1:
        return slowed(shape_of(reference.t, x), reference.duration, rig)
    legs = [
        slowed(rise_between(x[0::2, a], x[0::2, b]), float(reference.t[b] - reference.t[a]), rig)
        for a, b in pairwise(resting)
    ]
    whole = legs[0]
    for leg in legs[1:]:
        whole = concatenate(whole, leg)
    return whole


def rise_between(start: np.ndarray, goal: np.ndarray) -> Motion:
    """From rest to rest between angles (3,): travel and elevation (3, K) over a duration."""

    def motion(t: np.ndarray, duration: float) -> tuple[np.ndarray, np.ndarray]:
        rise = np.stack([RISE.deriv(n)(t / duration) / duration**n for n in range(3)])
        travel, elevation = ((goal[axis] - start[axis]) * rise for axis in (0, 1))
        travel[0] += start[0]
        elevation[0] += start[1]
        return travel, elevation

    return motion


def shape_of(times: np.ndarray, x: np.ndarray) -> Motion:
    """The travel and elevation of states (6, K) at times (K,), at any speed."""
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
    """The motion in this duration in s or, where that leaves the rig's limits, in a longer one."""
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
