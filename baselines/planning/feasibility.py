"""Common parts of all planners: time limit, validation of plans, and the error for an infeasible maneuver."""

import functools
import math
import time
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from heli_gym.baselines.paper.boundary_value import SAMPLE_PERIOD, sample_times
from heli_gym.baselines.planning.lead import JUMP, rotor_voltages
from heli_gym.baselines.planning.path import RECOVERY, path_fault, pitch_window
from heli_gym.model import fan_thrusts, hover_input, linearise
from heli_gym.parameters import HelicopterParameters
from heli_gym.trajectory import Maneuver, Trajectory
from heli_gym.validation import is_number, shown

ARRIVAL_TOLERANCE = 1e-3  # rad and rad/s, from the end of the replayed plan to the goal, per turn of travel
LONGEST_PLAN, FARTHEST_GOAL = 1e4, 1e5  # s and rad, largest accepted maneuver
LIMIT_TOLERANCE = 1e-6  # V and rad
GROWTH = 8.0  # exponent of error growth in an unstable flight at which the replay restarts from the plan
NEAR = 1e-3  # distance to a limit, as a share of the range, at which a voltage counts as on it
LENGTHENING, ATTEMPTS = 1.4, 16  # factor on the duration per attempt to find a plan, and number of attempts
SHORTEST = 2.0  # s, shortest duration to try


class InfeasibleManeuver(RuntimeError):
    """No plan was found that meets the limits of a maneuver.

    Attributes:
        shortest_duration: shortest duration in s for which this transition was planned; None if none was found.
    """

    def __init__(self, message: str, shortest_duration: float | None = None) -> None:
        super().__init__(message)
        self.shortest_duration = shortest_duration


@dataclass(frozen=True)
class TimeLimit:
    """End of the planning time, on the clock of `time.perf_counter`."""

    maneuver: Maneuver
    seconds: float
    end: float
    rejected: list[str] = field(default_factory=list)  # reasons why candidate plans failed validation

    def check(self) -> None:
        """Raise InfeasibleManeuver after the time limit."""
        if time.perf_counter() > self.end:
            raise InfeasibleManeuver(f"no plan for {self.maneuver} within the time limit of {self.seconds:g} s")

    @property
    def left(self) -> float:
        """Remaining time in s."""
        return self.end - time.perf_counter()


def arrival_tolerance(maneuver: Maneuver) -> float:
    """Tolerance of the end of a replayed plan in rad and rad/s: ARRIVAL_TOLERANCE, more for each full turn."""
    turns = abs(maneuver.goal[0] - maneuver.start[0]) / (2.0 * math.pi)
    return ARRIVAL_TOLERANCE * max(1.0, turns)


def check_scale(maneuver: Maneuver) -> None:
    """Raise ValueError for a maneuver outside the accepted durations and distances."""
    if not SAMPLE_PERIOD <= maneuver.duration <= LONGEST_PLAN:
        raise ValueError(
            f"duration = {maneuver.duration:g}: must be {SAMPLE_PERIOD:g} s, the sampling time of plans, to "
            f"{LONGEST_PLAN:g} s"
        )
    if not abs(maneuver.goal[0] - maneuver.start[0]) <= FARTHEST_GOAL:
        raise ValueError(f"goal = {maneuver.goal}: must be within {FARTHEST_GOAL:g} rad of the start {maneuver.start}")


def followed_by_hover(trajectory: Trajectory, maneuver: Maneuver) -> Trajectory:
    """Extend a shorter plan of the maneuver by hover at the goal to the maneuver's duration."""
    left = maneuver.duration - trajectory.duration
    if left <= 0.0:
        return trajectory
    rest = sample_times(replace(maneuver, duration=left))[1:]
    # the voltages jump to those of hover, since a ramp over a sample would kick an agile pitch axis
    rest = np.append(min(JUMP, 0.5 * rest[0]), rest)
    t = np.concatenate((trajectory.t, trajectory.duration + rest))
    t[-1] = maneuver.duration
    if maneuver.goal_state is not None:
        return trajectory  # the maneuver does not end in hover
    travel, _, elevation, *_ = trajectory.x[:, -1]
    hover = maneuver.rig.voltage(np.array(fan_thrusts(hover_input(elevation, maneuver.parameters))))
    x = np.repeat([[travel], [0.0], [elevation], [0.0], [0.0], [0.0]], len(rest), axis=1)
    u = np.repeat(hover[:, None], len(rest), axis=1)
    return replace(
        trajectory, t=t, x=np.concatenate((trajectory.x, x), axis=1), u=np.concatenate((trajectory.u, u), axis=1)
    )


def start_clock(maneuver: Maneuver, time_limit: float | None) -> TimeLimit:
    """Start a time limit in s now; None sets none. Raises ValueError unless it is positive."""
    if time_limit is not None and not (is_number(time_limit) and time_limit > 0.0):
        raise ValueError(f"time_limit = {shown(time_limit)}: must be a positive number of seconds, or None")
    seconds = math.inf if time_limit is None else time_limit
    return TimeLimit(maneuver, seconds, time.perf_counter() + seconds)


def infeasible(maneuver: Maneuver, shortest: Trajectory | None, clock: TimeLimit) -> InfeasibleManeuver:
    """Make the error for an infeasible maneuver from the shortest plan found for its transition, if any."""
    if shortest is None:
        reason = f": {clock.rejected[-1]}" if clock.rejected else "; the search found none in other durations either"
        return InfeasibleManeuver(f"no plan found for {maneuver}{reason}")
    (low, high), (pitch_low, pitch_high) = maneuver.limits.u, maneuver.limits.pitch
    pitch = max(shortest.x[4].max() / pitch_high, shortest.x[4].min() / pitch_low)
    shares = {
        "lower": np.mean(shortest.u < low + NEAR * (high - low)),
        "upper": np.mean(shortest.u > high - NEAR * (high - low)),
    }
    # Shares that round to 0 % are not binding.
    riding = " and ".join(f"on the {name} limit {share:.0%}" for name, share in shares.items() if round(share, 2))
    said = [f"its pitch reaches {pitch:.0%} of its limit"] if round(pitch, 2) else []
    said += [f"its voltages ride {riding} of the time"] if riding else []
    said += [fault for fault in clock.rejected if "way exceeds" in fault][:1]
    return InfeasibleManeuver(
        f"no plan for {maneuver}; the shortest found takes {shortest.duration:.2f} s"
        + (f": {', and '.join(said)}" if said else ""),
        shortest.duration,
    )


def validated(
    maneuver: Maneuver, trajectory: Trajectory | None, clock: TimeLimit | None = None, delay: float = 0.0
) -> Trajectory | None:
    """Return the trajectory if it meets the specification of `plan`; else None, with the reason stored in the clock.

    It has more samples where its thrusts would otherwise not be linear between them in flight. `delay` is the dead time
    in s, as in `fault_of`.
    """
    if trajectory is not None and not maneuver.lead:
        from heli_gym.baselines.planning.replay import with_linear_thrusts  # compiles, or loads from the cache

        trajectory = with_linear_thrusts(trajectory)
    fault = None if trajectory is None else fault_of(maneuver, trajectory, delay)
    if fault is not None and clock is not None:
        clock.rejected.append(fault)
    return trajectory if fault is None else None


def replay_ends(maneuver: Maneuver, duration: float) -> np.ndarray:
    """Restart times of a replay: both ends and, if hover is unstable, times at which errors have grown by e^GROWTH.

    An open-loop flight about an unstable hover misses the goal, however exact its plan is.
    """
    # of the start only if it is no measured state, since one rate suffices for an estimate
    points = (maneuver.goal,) if maneuver.start_state is not None else (maneuver.start, maneuver.goal)
    rates = [growth_rate(elevation, maneuver.parameters) for _, elevation in points]
    return np.linspace(0.0, duration, 1 + math.ceil(max(1.0, max(rates) * duration / GROWTH)))


@functools.lru_cache(maxsize=256)
def growth_rate(elevation: float, parameters: HelicopterParameters) -> float:
    """Largest growth rate in 1/s of errors about hover at an elevation in rad."""
    A, _ = linearise([0.0, 0.0, elevation, 0.0, 0.0, 0.0], hover_input(elevation, parameters), parameters)
    return float(np.linalg.eigvals(A).real.max())


def end_miss(maneuver: Maneuver, trajectory: Trajectory) -> float:
    """Distance of a plan's ends from the maneuver's, in rad or rad/s."""
    first, last = trajectory.x[:, 0], trajectory.x[:, -1]
    start, goal = maneuver.ends
    if maneuver.periodic:
        advance = np.array([goal[0] - start[0], 0.0, 0.0, 0.0, 0.0, 0.0])
        return float(max(np.abs(last - first - advance).max(), np.abs((first - start)[[0, 2]]).max()))
    if maneuver.elevation_free:
        goal[2] = last[2]
    return float(max(np.abs(first - start).max(), np.abs(last - goal).max()))


def fault_of(maneuver: Maneuver, trajectory: Trajectory, delay: float = 0.0) -> str | None:
    """Message about the first violated specification of `plan`, from a replay through (3); None if all are met.

    Leading voltages are those of rotors with the rig's lag, and with `delay` as their dead time in s.
    """
    from heli_gym.baselines.planning.replay import replay, rotor_inputs  # compiles, or loads from the cache

    limits, t = maneuver.limits, trajectory.t
    u = trajectory.u
    if maneuver.lead:
        before = maneuver.rig.hover_voltage(maneuver.start[1])
        u = rotor_voltages(t, u, maneuver.rig.lag, delay, before)
    times, v = rotor_inputs(t, u, maneuver.rig)
    ends = np.searchsorted(t, replay_ends(maneuver, trajectory.duration))
    miss, pitch = 0.0, [0.0]
    for start, end in pairwise(ends):
        along = slice(np.searchsorted(times, t[start]), np.searchsorted(times, t[end]) + 1)
        x, *extremes = replay(trajectory.x[:, start], v[:, along], times[along] - t[start], maneuver.parameters)
        miss += np.abs(x - trajectory.x[:, end]).max()
        pitch += extremes
    miss += end_miss(maneuver, trajectory)
    late = 0 if pitch_window(maneuver) == limits.pitch else min(np.searchsorted(t, RECOVERY), len(t) - 1)
    if not miss <= arrival_tolerance(maneuver):
        return f"the plan, replayed, misses the goal by {miss:.2g} rad or rad/s"
    for name, unit, values, (low, high) in (
        ("voltages", "V", trajectory.u, limits.u),
        ("pitch", "rad", trajectory.x[4, late:], limits.pitch),
        ("replayed pitch", "rad", np.array(pitch), pitch_window(maneuver)),
    ):
        excess = max(low - values.min(), values.max() - high)
        if excess > LIMIT_TOLERANCE:
            return f"the plan's {name} exceed their limits by {excess:.2g} {unit}"
    return path_fault(maneuver, trajectory)
