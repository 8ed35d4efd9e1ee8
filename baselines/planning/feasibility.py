"""What all searches for a plan share: a time limit, the check that plans pass, and what is said where there is none."""

import math
import time
from dataclasses import dataclass, field

import numpy as np

from heli_gym.model import virtual_input
from heli_gym.trajectory import Maneuver, Trajectory

ARRIVAL_TOLERANCE = 1e-3  # rad and rad/s, between the end of the replayed plan and the goal
LIMIT_TOLERANCE = 1e-6  # V and rad
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


def fault_of(maneuver: Maneuver, trajectory: Trajectory) -> str | None:
    """The promise of `plan` that a trajectory breaks, found by replaying it through (3); None if it keeps all."""
    from heli_gym.baselines.planning.replay import replay  # compiles, or loads what was compiled before

    limits = maneuver.limits
    v = np.stack(virtual_input(maneuver.rig.thrust(trajectory.u)))
    end, *pitch = replay(trajectory.x[:, 0], v, trajectory.duration, maneuver.parameters)
    miss = np.abs(end - trajectory.x[:, -1]).max()
    if not miss <= ARRIVAL_TOLERANCE:
        return f"the plan, replayed, misses the goal by {miss:.2g} rad or rad/s"
    for name, unit, values, (low, high) in (
        ("voltages", "V", trajectory.u, limits.u),
        ("pitch", "rad", trajectory.x[4], limits.pitch),
        ("replayed pitch", "rad", np.array(pitch), limits.pitch),
    ):
        excess = max(low - values.min(), values.max() - high)
        if excess > LIMIT_TOLERANCE:
            return f"the plan's {name} exceed their limits by {excess:.2g} {unit}"
    return None
