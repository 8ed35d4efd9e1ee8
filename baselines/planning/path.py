"""Constraints on the way of a plan: elevation, a floor as a function of travel, rates, and the slew of the voltages."""

import math
from typing import NamedTuple

import numpy as np

from heli_gym.trajectory import Maneuver, Trajectory

PATH_TOLERANCE = 1e-6  # rad, rad/s, and the share of a slew, by which a plan may exceed a constraint


class PathLimits(NamedTuple):
    """The constraints of a maneuver on its way; None where there is none. Elevation is positive down."""

    elevation_min: float | None
    elevation_max: float | None
    travel_rate: float | None
    elevation_rate: float | None
    slew: float | None
    floor: np.ndarray | None  # (2, N) travel and elevation in rad

    @property
    def is_empty(self) -> bool:
        """Whether there is no constraint."""
        return all(value is None for value in self)


def path_limits(maneuver: Maneuver) -> PathLimits:
    """The constraints of a maneuver; the table that the rig stands on is one where both ends are above it."""
    limits = maneuver.limits
    elevation_max, table = limits.elevation_max, maneuver.rig.table_elevation
    if elevation_max is None and max(maneuver.start[1], maneuver.goal[1]) < table:
        elevation_max = table
    return PathLimits(
        limits.elevation_min,
        elevation_max,
        limits.travel_rate,
        limits.elevation_rate,
        limits.slew,
        None if maneuver.floor is None else np.array(maneuver.floor),
    )


def excesses(maneuver: Maneuver, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> dict[str, float]:
    """Excess of a flight over each constraint of the maneuver, in rad, rad/s and V/s; negative where it is kept."""
    path, found = path_limits(maneuver), {}
    if path.elevation_min is not None:
        found["elevation_min"] = float(path.elevation_min - x[2].min())
    if path.elevation_max is not None:
        found["elevation_max"] = float(x[2].max() - path.elevation_max)
    if path.travel_rate is not None:
        found["travel_rate"] = float(np.abs(x[1]).max() - path.travel_rate)
    if path.elevation_rate is not None:
        found["elevation_rate"] = float(np.abs(x[3]).max() - path.elevation_rate)
    if path.slew is not None:
        found["slew"] = float((np.abs(np.diff(u)) / np.diff(t)).max() - path.slew)
    if path.floor is not None:
        found["floor"] = float((x[2] - np.interp(x[0], *path.floor)).max())
    return found


def path_fault(maneuver: Maneuver, trajectory: Trajectory) -> str | None:
    """The first constraint that a plan exceeds, and by how much; None if it keeps all."""
    for name, excess in excesses(maneuver, trajectory.t, trajectory.x, trajectory.u).items():
        slew = maneuver.limits.slew or 0.0
        if excess > PATH_TOLERANCE * (slew if name == "slew" else 1.0):
            amount = f"{excess:.2g} V/s" if name == "slew" else f"{math.degrees(excess):.2g} deg"
            amount += "/s" if name.endswith("_rate") else ""
            return f"the plan's way exceeds {name} by {amount}"
    return None


def check_ends(maneuver: Maneuver) -> None:
    """Raises ValueError where an end of the maneuver itself exceeds a constraint, by its name."""
    for name, x in zip(("start", "goal"), maneuver.ends):
        rest = excesses(maneuver, np.arange(2.0), np.stack((x, x), axis=1), np.zeros((2, 2)))
        for constraint, excess in rest.items():
            if excess > PATH_TOLERANCE:
                raise ValueError(f"{name} = {getattr(maneuver, name)!r}: must keep {constraint}, and exceeds it")
