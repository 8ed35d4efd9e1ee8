"""The paper's method, Section III-D: (38) by shooting, or by collocation, and from longer durations to shorter ones."""

from dataclasses import replace

from heli_gym.baselines.paper.boundary_value import FINE, ConstrainedProblem, Solution, solve_unconstrained
from heli_gym.baselines.paper.shooting import solve_by_shooting, solve_near
from heli_gym.baselines.planning.feasibility import (
    ATTEMPTS,
    LENGTHENING,
    SHORTEST,
    TimeLimit,
    followed_by_hover,
    infeasible,
    start_clock,
    validated,
)
from heli_gym.baselines.planning.spline import EASY, easy_duration
from heli_gym.trajectory import Maneuver, Trajectory

FARTHEST, NEAREST = (
    0.1,
    5e-3,
)  # relative steps in which durations are shortened: the first, and the one that is the last


def plan_paper(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Section III-D, by shooting, or else by collocation, from (14) or by shortening."""
    trajectory = plan_by_shooting(maneuver, clock) or checked_solution(
        maneuver, solve_from_unconstrained(maneuver, clock), clock
    )
    if trajectory is None:
        trajectory, found = shortened(maneuver, clock)
        if trajectory is None:
            trajectory = hover_after_fastest(maneuver, clock)
        if trajectory is None:
            raise infeasible(maneuver, shortest_checked(maneuver, found, clock), clock)
    return trajectory


def plan_fastest_paper(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Section III-D, shortened as far as it goes."""
    _, found = shortened(replace(maneuver, duration=SHORTEST), clock)
    fastest = shortest_checked(maneuver, found, clock)
    if fastest is None or fastest.duration > maneuver.duration:
        raise infeasible(maneuver, fastest, clock)
    return fastest


def hover_after_fastest(maneuver: Maneuver, clock: TimeLimit) -> Trajectory | None:
    """The fastest plan, then hover, if that is faster than requested."""
    _, found = shortened(replace(maneuver, duration=SHORTEST), clock)
    fastest = shortest_checked(maneuver, found, clock)
    if fastest is None or fastest.duration > maneuver.duration:
        return None
    return validated(maneuver, followed_by_hover(fastest, maneuver), clock)


def plan_by_shooting(maneuver: Maneuver, clock: TimeLimit) -> Trajectory | None:
    """Section III-D by shooting, if that leads to a solution and this passes the check."""
    solution = solve_by_shooting(maneuver, check=clock.check)
    return validated(maneuver, solution and ConstrainedProblem(maneuver).trajectory(solution), clock)


def plan_by_shooting_near(maneuver: Maneuver, near: Trajectory, clock: TimeLimit) -> Trajectory | None:
    """The same, straight from a plan of a similar maneuver."""
    solution = solve_near(maneuver, near, clock.check)
    return validated(maneuver, solution and ConstrainedProblem(maneuver).trajectory(solution), clock)


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
    duration = SHORTEST + easy_duration(maneuver) / EASY - 1.0
    for _ in range(ATTEMPTS):
        duration *= LENGTHENING
        if duration > maneuver.duration:
            solution = solve_from_unconstrained(replace(maneuver, duration=duration), clock)
            if solution is not None:
                return solution
    raise infeasible(maneuver, None, clock)


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
    return validated(maneuver, fine and problem.trajectory(fine), clock)
