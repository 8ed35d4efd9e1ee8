"""Flat method: one polynomial for both flat outputs of (3) determines the trajectory; see `heli_gym.flatness`."""

import numpy as np

from heli_gym.baselines.paper.boundary_value import sample_times
from heli_gym.flatness import RISE, invert_motion
from heli_gym.trajectory import Maneuver, Trajectory


def flat_trajectory(maneuver: Maneuver) -> Trajectory | None:
    """Trajectory with both flat outputs on one polynomial, limits ignored; None if a thrust sum is negative."""
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
    x[4:, [0, -1]] = 0.0  # exact boundary values
    return Trajectory(t, x, trajectory.u, maneuver.limits, maneuver.rig)
