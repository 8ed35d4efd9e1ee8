"""What all searches for a plan share: a time limit, the check that plans pass, and what is said where there is none."""

import math
import time
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from heli_gym.baselines.paper.boundary_value import SAMPLE_PERIOD, sample_times
from heli_gym.baselines.planning.path import path_fault
from heli_gym.model import fan_thrusts, hover_input, linearise, virtual_input
from heli_gym.trajectory import Maneuver, Trajectory

ARRIVAL_TOLERANCE = 1e-3  # rad and rad/s, between the end of the replayed plan and the goal, for each turn of travel
LONGEST_PLAN, FARTHEST_GOAL = 1e4, 1e5  # s and rad: beyond, no plan is looked for
LIMIT_TOLERANCE = 1e-6  # V and rad
GROWTH = 8.0  # exponent by which an unstable flight lets errors grow before its replay starts anew from the plan
NEAR = 1e-3  # share of its window from the end at which a voltage counts as riding on its limit
LENGTHENING, ATTEMPTS = 1.4, 16  # factor by which a duration is stretched until a plan is found, and how often
SHORTEST = 2.0  # s, of any maneuver that is worth trying


class InfeasibleManeuver(RuntimeError):
    """No plan was found that meets the limits of a maneuver.

    Attributes:
        shortest_duration: the shortest duration in s for which the same transition was planned; None if none was.
    """

    def __init__(self, message: str, shortest_duration: float | None = None) -> None:
        super().__init__(message)
        self.shortest_duration = shortest_duration


@dataclass(frozen=True)
class TimeLimit:
    """Until when, on the clock of `time.perf_counter`, a maneuver may be planned."""

    maneuver: Maneuver
    seconds: float
    end: float
    rejected: list[str] = field(default_factory=list)  # why plans that were found did not pass the check

    def check(self) -> None:
        """Raises InfeasibleManeuver when the time is over."""
        if time.perf_counter() > self.end:
            raise InfeasibleManeuver(f"no plan for {self.maneuver} within the time limit of {self.seconds:g} s")

    @property
    def left(self) -> float:
        """Seconds."""
        return self.end - time.perf_counter()


def arrival_tolerance(maneuver: Maneuver) -> float:
    """How far from the goal a replayed plan may end, in rad and rad/s: 1e-3, and as much for each full turn."""
    turns = abs(maneuver.goal[0] - maneuver.start[0]) / (2.0 * math.pi)
    return ARRIVAL_TOLERANCE * max(1.0, turns)


def check_scale(maneuver: Maneuver) -> None:
    """Raises ValueError for a maneuver that is too short, too long or too far for any plan to be looked for."""
    if not SAMPLE_PERIOD <= maneuver.duration <= LONGEST_PLAN:
        raise ValueError(
            f"duration = {maneuver.duration:g}: must be {SAMPLE_PERIOD:g} s, the sampling time of plans, to "
            f"{LONGEST_PLAN:g} s"
        )
    if not abs(maneuver.goal[0] - maneuver.start[0]) <= FARTHEST_GOAL:
        raise ValueError(f"goal = {maneuver.goal}: must be within {FARTHEST_GOAL:g} rad of the start {maneuver.start}")


def followed_by_hover(trajectory: Trajectory, maneuver: Maneuver) -> Trajectory:
    """A plan of the maneuver in a shorter time, then hover at the goal for the rest of the maneuver's duration."""
    left = maneuver.duration - trajectory.duration
    if left <= 0.0:
        return trajectory
    rest = sample_times(replace(maneuver, duration=left))[1:]
    t = np.concatenate((trajectory.t, trajectory.duration + rest))
    t[-1] = maneuver.duration
    if maneuver.goal_state is not None:
        return trajectory  # which does not end in hover
    travel, elevation = maneuver.goal
    hover = maneuver.rig.voltage(np.array(fan_thrusts(hover_input(elevation, maneuver.parameters))))
    x = np.repeat([[travel], [0.0], [elevation], [0.0], [0.0], [0.0]], len(rest), axis=1)
    u = np.repeat(hover[:, None], len(rest), axis=1)
    return replace(
        trajectory, t=t, x=np.concatenate((trajectory.x, x), axis=1), u=np.concatenate((trajectory.u, u), axis=1)
    )


def start_clock(maneuver: Maneuver, time_limit: float | None) -> TimeLimit:
    """A time limit from now on. Raises ValueError unless it is positive, or None for none."""
    if time_limit is not None and not time_limit > 0.0:
        raise ValueError(f"time_limit = {time_limit!r}: must be a positive number of seconds, or None")
    seconds = math.inf if time_limit is None else time_limit
    return TimeLimit(maneuver, seconds, time.perf_counter() + seconds)


def infeasible(maneuver: Maneuver, shortest: Trajectory | None, clock: TimeLimit) -> InfeasibleManeuver:
    """The refusal of a maneuver, given the shortest plan of the same that was found."""
    if shortest is None:
        reason = f": {clock.rejected[-1]}" if clock.rejected else "; the search found none in other durations either"
        return InfeasibleManeuver(f"no plan found for {maneuver}{reason}")
    (low, high), (pitch_low, pitch_high) = maneuver.limits.u, maneuver.limits.pitch
    pitch = max(shortest.x[4].max() / pitch_high, shortest.x[4].min() / pitch_low)
    shares = {
        "lower": np.mean(shortest.u < low + NEAR * (high - low)),
        "upper": np.mean(shortest.u > high - NEAR * (high - low)),
    }
    # What rounds to 0 % is not in the way.
    riding = " and ".join(f"on the {name} limit {share:.0%}" for name, share in shares.items() if round(share, 2))
    said = [f"its pitch reaches {pitch:.0%} of its limit"] if round(pitch, 2) else []
    said += [f"its voltages ride {riding} of the time"] if riding else []
    said += [fault for fault in clock.rejected if "way exceeds" in fault][:1]
    return InfeasibleManeuver(
        f"no plan for {maneuver}; the shortest found takes {shortest.duration:.2f} s"
        + (f": {', and '.join(said)}" if said else ""),
        shortest.duration,
    )


def validated(maneuver: Maneuver, trajectory: Trajectory | None, clock: TimeLimit | None = None) -> Trajectory | None:
    """The trajectory if it keeps what `plan` promises; else None, and the clock notes why."""
    fault = None if trajectory is None else fault_of(maneuver, trajectory)
    if fault is not None and clock is not None:
        clock.rejected.append(fault)
    return trajectory if fault is None else None


def replay_ends(maneuver: Maneuver, duration: float) -> np.ndarray:
    """Times at which a replay starts anew from the plan: but for the ends, only where errors would grow by e^GROWTH.

    Where hover is unstable by itself, no flight without feedback arrives, however exact its plan is.
    """
    rates = [
        np.linalg.eigvals(linearise(x, hover_input(x[2], maneuver.parameters), maneuver.parameters)[0]).real.max()
        for x in ([0.0, 0.0, elevation, 0.0, 0.0, 0.0] for _, elevation in (maneuver.start, maneuver.goal))
    ]
    return np.linspace(0.0, duration, 1 + math.ceil(max(1.0, max(rates) * duration / GROWTH)))


def fault_of(maneuver: Maneuver, trajectory: Trajectory) -> str | None:
    """The promise of `plan` that a trajectory breaks, found by replaying it through (3); None if it keeps all."""
    from heli_gym.baselines.planning.replay import replay  # compiles, or loads what was compiled before

    limits, t = maneuver.limits, trajectory.t
    v = np.stack(virtual_input(maneuver.rig.thrust(trajectory.u)))
    ends = np.searchsorted(t, replay_ends(maneuver, trajectory.duration))
    miss, pitch = 0.0, [0.0]
    for start, end in pairwise(ends):
        along = slice(start, end + 1)
        x, *extremes = replay(trajectory.x[:, start], v[:, along], t[along] - t[start], maneuver.parameters)
        miss += np.abs(x - trajectory.x[:, end]).max()
        pitch += extremes
    if not miss <= arrival_tolerance(maneuver):
        return f"the plan, replayed, misses the goal by {miss:.2g} rad or rad/s"
    for name, unit, values, (low, high) in (
        ("voltages", "V", trajectory.u, limits.u),
        ("pitch", "rad", trajectory.x[4], limits.pitch),
        ("replayed pitch", "rad", np.array(pitch), limits.pitch),
    ):
        excess = max(low - values.min(), values.max() - high)
        if excess > LIMIT_TOLERANCE:
            return f"the plan's {name} exceed their limits by {excess:.2g} {unit}"
    return path_fault(maneuver, trajectory)
