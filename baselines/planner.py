"""Maneuver in, Trajectory out: every method, and the check that all plans pass."""

import math
import time
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from baselines import spline
from baselines.boundary_value import FINE, ConstrainedProblem, Solution, solve_unconstrained, unconstrained_trajectory
from baselines.collocation import collocated_trajectory
from baselines.flat import flat_trajectory
from baselines.shooting import solve_by_shooting
from heli_gym.model import thrust, virtual_input
from heli_gym.parameters import Limits
from heli_gym.trajectory import Maneuver, Trajectory

ARRIVAL_TOLERANCE = 1e-3  # rad and rad/s, between the end of the replayed plan and the goal
LIMIT_TOLERANCE = 1e-6  # V and rad
LENGTHENING, ATTEMPTS = 1.4, 16  # factor by which the duration is stretched until a plan is found, and how often
FARTHEST, NEAREST = 0.1, 5e-3  # relative steps in which it is then shortened: the first, and the one that is the last
SHORTEST = 2.0  # s, of any maneuver that is worth trying
MARGINS = (1e-3, 1e-2)  # shares of the shortest duration by which it is lengthened until its smoothest plan is found
NEAR = 1e-3  # share of its window from the end at which a voltage counts as riding on its limit
FLAT_ACCURACY = 1e-3  # relative, of the shortest duration of a flat plan
WORTH_NAMING = 0.01  # share of the duration that a limit must cost, by its whole window, to be called in the way


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
        raise ValueError(f"time_limit = {time_limit!r}: a positive number of seconds, or None, is needed")
    seconds = math.inf if time_limit is None else time_limit
    return TimeLimit(maneuver, seconds, time.perf_counter() + seconds)


def plan_unconstrained(maneuver: Maneuver) -> Trajectory:
    """Section III-B: the trajectory of (14), which ignores the limits.

    Raises InfeasibleManeuver if there is none: below some duration the pitch would have to pass 90 degrees.
    """
    solution = solve_unconstrained(maneuver, FINE)
    if solution is None:
        raise InfeasibleManeuver(
            f"no unconstrained plan for {maneuver}: the pitch would pass 90 degrees; a longer duration is easier"
        )
    return unconstrained_trajectory(maneuver, solution)


def plan(maneuver: Maneuver, method: str = "auto", time_limit: float | None = None) -> Trajectory:
    """A trajectory from rest to rest that meets the maneuver's limits.

    Whatever the method, what is returned has been replayed through (3) by an adaptive integrator: it ends within
    1e-3 rad and 1e-3 rad/s of the goal, and stays within the limits to 1e-6 V and rad.

    Args:
        maneuver: what is asked for.
        method: one of
            "paper", which solves (38) with the ansatz (39), (40), the unconstrained plan being the initial guess, by
            shooting or by collocation. If that finds nothing, it starts from a longer duration, which is easier, and
            shortens it step by step;
            "spline", the smoothest plan of many more free parameters, see `baselines.spline`;
            "flat", polynomials in the flat outputs, see `baselines.flat`;
            "collocation", the plan of least effort, see `baselines.collocation`; needs the extra `ocp`;
            "auto", which takes the paper's plan if shooting finds one, and else the spline's.
        time_limit: in s, after which the search is given up; looked at every few ms. Compiling, at the first use after
            an installation, takes some 20 s of it.

    Raises:
        ValueError: if the method is unknown, or the time limit is not positive.
        InfeasibleManeuver: if the method finds no such trajectory; names the constraint in the way and the shortest
            duration that it can plan; or if the time is over.
    """
    if method not in METHODS:
        raise ValueError(f"method = {method!r}: one of {', '.join(METHODS)} is needed")
    return METHODS[method](maneuver, start_clock(maneuver, time_limit))


def plan_fastest(
    maneuver: Maneuver, method: str = "auto", reserve: float = 0.0, time_limit: float | None = None
) -> Trajectory:
    """The plan of the shortest duration that a method finds, up to the maneuver's own.

    Args:
        maneuver: what is asked for.
        method: "spline", "paper", "flat" or "collocation", as of `plan`; "auto" is "spline".
        reserve: for the feedback, the share of the voltage window and of the pitch window that the plan leaves free,
            half of it at each end.
        time_limit: in s, after which the search is given up.

    Returns:
        A plan that passes the check of `plan`, under the maneuver's own limits.

    Raises:
        ValueError: if an argument is none of these, if start and goal are the same, or if the windows that are left do
            not even permit hover at the start or at the goal.
        InfeasibleManeuver: if the shortest duration found is longer than the maneuver's; or if the time is over.
    """
    if method not in FASTEST:
        raise ValueError(f"method = {method!r}: one of {', '.join(FASTEST)} is needed")
    if not 0.0 <= reserve < 1.0:
        raise ValueError(f"reserve = {reserve!r}: at least 0 and less than 1 is needed")
    if maneuver.start == maneuver.goal:
        raise ValueError(f"goal = {maneuver.goal}: another point than the start is needed")
    asked = replace(maneuver, limits=reserved(maneuver.limits, reserve))
    return replace(FASTEST[method](asked, start_clock(maneuver, time_limit)), limits=maneuver.limits)


def reserved(limits: Limits, reserve: float) -> Limits:
    """Narrower windows of voltages and pitch, by a share, about the same centres."""
    (u_min, u_max), (pitch_min, pitch_max) = (
        (low + 0.5 * reserve * (high - low), high - 0.5 * reserve * (high - low))
        for low, high in (limits.u, limits.pitch)
    )
    return Limits(u_min, u_max, pitch_min, pitch_max)


# The methods


def plan_auto(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """The paper's plan, where shooting finds one, or else a spline."""
    trajectory = shot(maneuver, clock)
    return plan_spline(maneuver, clock) if trajectory is None else trajectory


def shot(maneuver: Maneuver, clock: TimeLimit) -> Trajectory | None:
    """Section III-D by shooting, if that leads to a solution and this passes the check."""
    solution = solve_by_shooting(maneuver, check=clock.check)
    return checked(maneuver, solution and ConstrainedProblem(maneuver).trajectory(solution))


def plan_spline(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """The smoothest spline from a plain guess, or else from the fastest one, if that is fast enough."""
    trajectory = checked(maneuver, spline.plan_smoothest(maneuver))
    if trajectory is not None:
        return trajectory
    fastest, _ = fastest_spline(maneuver, clock)
    if fastest.duration <= maneuver.duration:
        trajectory = checked(maneuver, spline.plan_lengthened(maneuver, fastest, clock.check))
        if trajectory is not None:
            return trajectory
    for margin in MARGINS:
        longer = replace(maneuver, duration=(1.0 + margin) * max(fastest.duration, maneuver.duration))
        if checked(longer, spline.plan_lengthened(longer, fastest, clock.check)) is not None:
            raise InfeasibleManeuver(
                f"no plan for {maneuver}; the shortest found takes {longer.duration:.2f} s: "
                f"{obstacles(longer, fastest)}",
                longer.duration,
            )
    raise InfeasibleManeuver(f"no plan for {maneuver}: {obstacles(maneuver, fastest)}")


def plan_fastest_spline(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """The spline of the shortest duration."""
    fastest, trajectory = fastest_spline(maneuver, clock)
    if fastest.duration > maneuver.duration:
        raise InfeasibleManeuver(
            f"no plan for {maneuver}; the shortest found takes {fastest.duration:.2f} s: "
            f"{obstacles(maneuver, fastest)}",
            fastest.duration,
        )
    return trajectory


def fastest_spline(maneuver: Maneuver, clock: TimeLimit) -> tuple[spline.Spline, Trajectory]:
    """The fastest spline, checked; raises InfeasibleManeuver if there is none."""
    found = spline.plan_fastest(maneuver, clock.check)
    if found is None or checked(replace(maneuver, duration=found[0].duration), found[1]) is None:
        raise InfeasibleManeuver(f"no plan for {maneuver}, nor for the same in any other time")
    return found


def obstacles(maneuver: Maneuver, fastest: spline.Spline) -> str:
    """What is in the way of a faster plan: the limits, and by their multipliers what a little more would save."""
    limits, p = maneuver.limits, maneuver.parameters
    low, high, pitch_low, pitch_high = fastest.duration * fastest.multipliers
    (slope_low, slope_high), degree = 2.0 * p.k_plus * np.abs(limits.u), math.pi / 180.0
    savings = {
        f"the lower voltage limit (1 V less would save {low * slope_low:.2g} s)": low * slope_low,
        f"the upper voltage limit (1 V more would save {high * slope_high:.2g} s)": high * slope_high,
        f"the pitch limits (1 degree more would save {(pitch_low + pitch_high) * degree:.2g} s)": (
            (pitch_low + pitch_high) * max(limits.pitch)
        ),
    }
    named = [name for name, saving in savings.items() if saving > WORTH_NAMING * fastest.duration]
    return f"in the way are {' and '.join(named)}" if named else "none of its limits stands out as the cause"


def plan_paper(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Section III-D, by shooting, or else by collocation, from (14) or by shortening."""
    trajectory = shot(maneuver, clock) or checked_solution(maneuver, solve_from_unconstrained(maneuver, clock), clock)
    if trajectory is None:
        trajectory, found = shortened(maneuver, clock)
        if trajectory is None:
            raise no_plan(maneuver, shortest_checked(maneuver, found, clock))
    return trajectory


def plan_fastest_paper(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Section III-D, shortened as far as it goes."""
    _, found = shortened(replace(maneuver, duration=SHORTEST), clock)
    fastest = shortest_checked(maneuver, found, clock)
    if fastest is None or fastest.duration > maneuver.duration:
        raise no_plan(maneuver, fastest)
    return fastest


def solve_from_unconstrained(maneuver: Maneuver, clock: TimeLimit | None = None) -> Solution | None:
    """The paper's way: (14) first, then (38) from there."""
    clock = clock or start_clock(maneuver, None)
    unconstrained = solve_unconstrained(maneuver)
    if unconstrained is None:
        return None
    problem = ConstrainedProblem(maneuver, clock.check)
    return problem.solve(problem.guess(unconstrained.stretched(maneuver.duration)))


def shortened(maneuver: Maneuver, clock: TimeLimit) -> tuple[Trajectory | None, list[Solution]]:
    """Homotopy in the duration, from one that works down to the maneuver's, in steps that halve when one fails.

    The durations do not depend on the one that is asked for until they come near it: what is found for one is found for
    every longer one. Where a step leads past it only, to another branch of solutions, the way back up is tried.
    Returns the plan, if there is one, and solutions of the same in longer and then ever shorter times.
    """
    found = [first_solution(maneuver, clock)]
    step = FARTHEST

    def reach(duration: float, start: Solution) -> Solution | None:
        problem = ConstrainedProblem(replace(maneuver, duration=duration), clock.check)
        return problem.solve(start.stretched(duration))

    while step > NEAREST:
        shorter = float(found[-1].t[-1]) * (1.0 - step)
        if shorter > maneuver.duration:
            ahead = reach(shorter, found[-1])
            if ahead is not None:
                found.append(ahead)
                continue
        else:
            trajectory = checked_solution(maneuver, reach(maneuver.duration, found[-1]), clock)
            if trajectory is None and (below := reach(shorter, found[-1])):
                trajectory = checked_solution(maneuver, reach(maneuver.duration, below), clock)
            if trajectory is not None:
                return trajectory, found
        step /= 2.0
    return None, found


def first_solution(maneuver: Maneuver, clock: TimeLimit) -> Solution:
    """A solution of (38) in a longer time, found from the unconstrained plan; raises InfeasibleManeuver if none is."""
    # Level flight at the pitch limit accelerates the travel by b1/b2 a2 tan(q3), see (14a), half of the way.
    p, pitch = maneuver.parameters, min(np.abs(maneuver.limits.pitch))
    acceleration = abs(p.b1 / p.b2 * p.a2) * np.tan(pitch)
    duration = SHORTEST + 2.0 * np.sqrt(abs(maneuver.goal[0] - maneuver.start[0]) / acceleration)
    for _ in range(ATTEMPTS):
        duration *= LENGTHENING
        if duration > maneuver.duration:
            solution = solve_from_unconstrained(replace(maneuver, duration=duration), clock)
            if solution is not None:
                return solution
    raise no_plan(maneuver, None)


def shortest_checked(maneuver: Maneuver, found: list[Solution], clock: TimeLimit) -> Trajectory | None:
    """The last of the solutions that passes the check, as a trajectory."""
    for solution in reversed(found):
        trajectory = checked_solution(replace(maneuver, duration=float(solution.t[-1])), solution, clock)
        if trajectory is not None:
            return trajectory
    return None


def checked_solution(maneuver: Maneuver, solution: Solution | None, clock: TimeLimit) -> Trajectory | None:
    """The trajectory of a solution of (38), refined, if it passes the check."""
    problem = ConstrainedProblem(maneuver, clock.check)
    fine = solution and problem.solve(solution, FINE)
    return checked(maneuver, fine and problem.trajectory(fine))


def plan_flat(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Polynomials in the flat outputs."""
    trajectory = checked(maneuver, flat_trajectory(maneuver))
    if trajectory is None:
        raise no_plan(maneuver, flat_above(maneuver, maneuver.duration, clock))
    return trajectory


def plan_fastest_flat(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Polynomials in the flat outputs, as fast as the limits permit."""
    fastest = flat_above(maneuver, 0.0, clock)
    if fastest is None or fastest.duration > maneuver.duration:
        raise no_plan(maneuver, fastest)
    return fastest


def flat_above(maneuver: Maneuver, shortest: float, clock: TimeLimit) -> Trajectory | None:
    """By bisection, the shortest flat plan that takes longer than the shortest duration given."""

    def attempt(duration: float) -> Trajectory | None:
        clock.check()
        longer = replace(maneuver, duration=duration)
        return checked(longer, flat_trajectory(longer))

    slow, best = max(shortest, SHORTEST), None
    for _ in range(ATTEMPTS):
        best = attempt(slow)
        if best is not None:
            break
        shortest, slow = slow, LENGTHENING * slow
    while best is not None and best.duration - shortest > FLAT_ACCURACY * best.duration:
        middle = 0.5 * (shortest + best.duration)
        faster = attempt(middle)
        best, shortest = (best, middle) if faster is None else (faster, shortest)
    return best


def plan_collocation(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Least effort, by direct collocation."""
    trajectory = checked(maneuver, collocated_trajectory(maneuver, "effort", clock.left))
    if trajectory is None:
        clock.check()
        raise no_plan(maneuver, collocated_above(maneuver, clock))
    return trajectory


def plan_fastest_collocation(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Least time, by direct collocation."""
    fastest = collocated_above(maneuver, clock)
    if fastest is None or fastest.duration > maneuver.duration:
        raise no_plan(maneuver, fastest)
    return fastest


def collocated_above(maneuver: Maneuver, clock: TimeLimit) -> Trajectory | None:
    """Least time, by direct collocation, whatever the maneuver's duration."""
    easy = replace(maneuver, duration=max(maneuver.duration, spline.easy_duration(maneuver)))
    trajectory = collocated_trajectory(easy, "time", clock.left)
    clock.check()
    return trajectory and checked(replace(maneuver, duration=trajectory.duration), trajectory)


METHODS: dict[str, Callable[[Maneuver, TimeLimit], Trajectory]] = {
    "auto": plan_auto,
    "paper": plan_paper,
    "spline": plan_spline,
    "flat": plan_flat,
    "collocation": plan_collocation,
}
FASTEST: dict[str, Callable[[Maneuver, TimeLimit], Trajectory]] = {
    "auto": plan_fastest_spline,
    "spline": plan_fastest_spline,
    "paper": plan_fastest_paper,
    "flat": plan_fastest_flat,
    "collocation": plan_fastest_collocation,
}


def no_plan(maneuver: Maneuver, shortest: Trajectory | None) -> InfeasibleManeuver:
    """What to say of a maneuver, given the shortest plan of the same that was found."""
    if shortest is None:
        return InfeasibleManeuver(f"no plan for {maneuver}, nor for the same in any other time")
    (low, high), (pitch_low, pitch_high) = maneuver.limits.u, maneuver.limits.pitch
    pitch_share = max(shortest.x[4].max() / pitch_high, shortest.x[4].min() / pitch_low)
    shares = {
        "lower": np.mean(shortest.u < low + NEAR * (high - low)),
        "upper": np.mean(shortest.u > high - NEAR * (high - low)),
    }
    riding = " and ".join(f"on the {name} one {share:.0%}" for name, share in shares.items())
    return InfeasibleManeuver(
        f"no plan for {maneuver}; the shortest found takes {shortest.duration:.2f} s: its pitch reaches "
        f"{pitch_share:.0%} of its limit, and its voltages ride {riding} of the time",
        shortest.duration,
    )


def checked(maneuver: Maneuver, trajectory: Trajectory | None) -> Trajectory | None:
    """The trajectory if it keeps what `plan` promises, found by replaying its voltages through (3)."""
    from baselines.replay import replay  # compiles, or loads what was compiled before

    if trajectory is None:
        return None
    limits = maneuver.limits

    def within(values: np.ndarray, bounds: tuple[float, float]) -> bool:
        return bounds[0] - LIMIT_TOLERANCE <= values.min() and values.max() <= bounds[1] + LIMIT_TOLERANCE

    if not (within(trajectory.u, limits.u) and within(trajectory.x[4], limits.pitch)):
        return None
    v = np.stack(virtual_input(thrust(trajectory.u, maneuver.parameters)))
    end, *pitch = replay(trajectory.x[:, 0], v, trajectory.duration, maneuver.parameters)
    arrives = np.abs(end - trajectory.x[:, -1]).max() <= ARRIVAL_TOLERANCE
    return trajectory if arrives and within(np.array(pitch), limits.pitch) else None
