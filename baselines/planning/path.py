"""Path constraints of a plan: elevation, floor as a function of travel, rates, and slew rate of the voltages."""

import math
from typing import NamedTuple

import numpy as np

from heli_gym.trajectory import Maneuver, Trajectory

VIA_TOLERANCE = 1e-3  # rad, of via points
RECOVERY = 0.8  # s, in which a pitch that starts outside its limits returns within them
MARGIN = 0.02  # rad, of a pitch outside its limits
BRAKING = 2.0  # rad/s², pitch acceleration that stops a pitch rate towards a limit
PATH_TOLERANCE = 1e-6  # rad, rad/s, and share of a slew rate: tolerance of path constraints


class PathLimits(NamedTuple):
    """Path constraints of a maneuver; None for a missing one. Elevation is the model's, positive down if b2 < 0."""

    elevation_min: float | None
    elevation_max: float | None
    travel_rate: float | None
    elevation_rate: float | None
    slew: float | None
    floor: np.ndarray | None  # (2, N) travel and elevation in rad
    lead: float | None  # s, lag of the rotors that the voltages lead

    @property
    def is_empty(self) -> bool:
        """Whether there are no constraints."""
        return all(value is None for value in self)


def path_limits(maneuver: Maneuver) -> PathLimits:
    """Path constraints of a maneuver; they include the rig's table if both ends and all via points are above it.

    On a rig whose elevation is positive upwards (b2 > 0), the table is a least elevation.
    """
    limits, table = maneuver.limits, maneuver.rig.table_elevation
    lowest, highest = limits.elevation_min, limits.elevation_max
    heights = [maneuver.start[1], maneuver.goal[1], *(lift for _, _, lift in maneuver.via if lift is not None)]
    if maneuver.rig.parameters.b2 > 0.0:
        if min(heights) > -table:
            lowest = -table if lowest is None else max(lowest, -table)
    elif max(heights) < table:
        highest = table if highest is None else min(highest, table)
    return PathLimits(
        lowest,
        highest,
        limits.travel_rate,
        limits.elevation_rate,
        limits.slew,
        None if maneuver.floor is None else np.array(maneuver.floor),
        maneuver.rig.lag if maneuver.lead and maneuver.rig.lag > 0.0 else None,
    )


def excesses(maneuver: Maneuver, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> dict[str, float]:
    """Excess of a flight over each path constraint by name, in rad, rad/s, V/s or V; negative where it is satisfied."""
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
    if path.lead is not None:
        found["lead"] = float(max(u.max() - maneuver.limits.u_max, maneuver.limits.u_min - u.min()))
    if path.floor is not None:
        found["floor"] = float((x[2] - np.interp(x[0], *path.floor)).max())
    return found


def pitch_window(maneuver: Maneuver) -> tuple[float, float]:
    """Pitch limits in rad during RECOVERY: wider than the maneuver's if a measured start is, or will be, outside."""
    low, high = maneuver.limits.pitch
    if maneuver.start_state is None:
        return low, high
    pitch, rate = maneuver.start_state[4:]
    ahead = pitch + 0.5 * rate * abs(rate) / BRAKING
    lowest, highest = min(pitch, ahead), max(pitch, ahead)
    return (low if lowest >= low else lowest - MARGIN), (high if highest <= high else highest + MARGIN)


def passages(maneuver: Maneuver, t: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Misses (V, 2) of the via points by a flight, in travel and elevation, in rad; zero for a free coordinate.

    A point without a time counts at the passage of its travel that misses its elevation least.
    """
    missed = np.zeros((len(maneuver.via), 2))
    for k, (time, travel, elevation) in enumerate(maneuver.via):
        if time is not None:
            at = [float(np.interp(time, t, row)) for row in (x[0], x[2])]
            missed[k] = at[0] - travel, 0.0 if elevation is None else at[1] - elevation
            continue
        assert elevation is not None
        side = x[0] - travel
        passed = np.flatnonzero(side[:-1] * side[1:] <= 0.0)
        if not len(passed):
            missed[k, 0] = side[np.abs(side).argmin()]
            continue
        turn = side[passed + 1] - side[passed]
        share = np.where(turn == 0.0, 0.0, -side[passed] / np.where(turn == 0.0, 1.0, turn))
        lifts = (1.0 - share) * x[2, passed] + share * x[2, passed + 1] - elevation
        missed[k, 1] = lifts[np.abs(lifts).argmin()]
    return missed


def path_fault(maneuver: Maneuver, trajectory: Trajectory) -> str | None:
    """Message about the first violated path constraint, with its excess; None if all are satisfied."""
    for name, excess in excesses(maneuver, trajectory.t, trajectory.x, trajectory.u).items():
        slew = maneuver.limits.slew or 0.0
        if excess > PATH_TOLERANCE * (slew if name == "slew" else 1.0):
            units = {"slew": "V/s", "lead": "V"}
            amount = f"{excess:.2g} {units[name]}" if name in units else f"{math.degrees(excess):.2g} deg"
            amount += "/s" if name.endswith("_rate") else ""
            return f"the plan's way exceeds {name} by {amount}"
    for k, missed in enumerate(np.abs(passages(maneuver, trajectory.t, trajectory.x)).max(axis=1)):
        if missed > VIA_TOLERANCE:
            return f"the plan's way misses via[{k}] = {maneuver.via[k]} by {math.degrees(missed):.2g} deg"
    return None


def check_ends(maneuver: Maneuver) -> None:
    """Raise ValueError, which names the constraint, if an end of the maneuver violates one."""
    ends = maneuver.ends[: 1 if maneuver.elevation_free else 2]
    for name, x in zip(("start", "goal"), ends):
        hover = maneuver.rig.hover_voltage(maneuver.start[1])[:, None] * np.ones(2)
        rest = excesses(maneuver, np.arange(2.0), np.stack((x, x), axis=1), hover)
        for constraint, excess in rest.items():
            if excess > PATH_TOLERANCE:
                raise ValueError(f"{name} = {getattr(maneuver, name)!r}: must keep {constraint}, and exceeds it")
