"""The paper's method, Section III-D: (38) by shooting or collocation, with homotopy from longer durations."""

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
from heli_gym.baselines.planning.spline_search import EASY, easy_duration
from heli_gym.trajectory import Maneuver, Trajectory

FARTHEST, NEAREST = (
    0.1,
    5e-3,
)  # relative steps of shortening a duration: first and smallest


def plan_paper(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Plan of Section III-D, by shooting, else by collocation from (14), else by shortening a longer plan."""
    trajectory = plan_by_shooting(maneuver, clock) or checked_solution(
        maneuver, solve_from_unconstrained(maneuver, clock), clock
    )
    if trajectory is None:
        trajectory, found = shorten(maneuver, clock)
        if trajectory is None:
            trajectory = hover_after_fastest(maneuver, clock)
        if trajectory is None:
            raise infeasible(maneuver, shortest_checked(maneuver, found, clock), clock)
    return trajectory


def plan_fastest_paper(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Plan of Section III-D of the shortest duration found."""
    _, found = shorten(replace(maneuver, duration=SHORTEST), clock)
    fastest = shortest_checked(maneuver, found, clock)
    if fastest is None or fastest.duration > maneuver.duration:
        raise infeasible(maneuver, fastest, clock)
    return fastest


def hover_after_fastest(maneuver: Maneuver, clock: TimeLimit) -> Trajectory | None:
    """Fastest plan followed by hover, if it is shorter than requested; None otherwise."""
    _, found = shorten(replace(maneuver, duration=SHORTEST), clock)
    fastest = shortest_checked(maneuver, found, clock)
    if fastest is None or fastest.duration > maneuver.duration:
        return None
    return validated(maneuver, followed_by_hover(fastest, maneuver), clock)


def plan_by_shooting(maneuver: Maneuver, clock: TimeLimit) -> Trajectory | None:
    """Validated plan of Section III-D by shooting; None if there is none."""
    solution = solve_by_shooting(maneuver, check=clock.check)
    return validated(maneuver, solution and ConstrainedProblem(maneuver).trajectory(solution), clock)


def plan_by_shooting_near(maneuver: Maneuver, near: Trajectory, clock: TimeLimit) -> Trajectory | None:
    """Validated plan of Section III-D by shooting, from a plan of a similar maneuver; None if there is none."""
    solution = solve_near(maneuver, near, clock.check)
    return validated(maneuver, solution and ConstrainedProblem(maneuver).trajectory(solution), clock)


def solve_from_unconstrained(maneuver: Maneuver, clock: TimeLimit | None = None) -> Solution | None:
    """Solve (14), then (38) from that solution, as in the paper; None if either fails."""
    clock = clock or start_clock(maneuver, None)
    unconstrained = solve_unconstrained(maneuver)
    if unconstrained is None:
        return None
    problem = ConstrainedProblem(maneuver, clock.check)
    return problem.solve(problem.guess(unconstrained.stretched(maneuver.duration)))


def shorten(maneuver: Maneuver, clock: TimeLimit) -> tuple[Trajectory | None, list[Solution]]:
    """Shorten a solution to the maneuver's duration by homotopy, in steps that halve after a failure.

    The sequence of durations is independent of the maneuver's until it comes near it, so that a method that succeeds
    for one duration succeeds for every longer one. If only a step past the maneuver's duration converges, to another
    branch of solutions, the maneuver is solved from there. Returns the plan or None, and the solutions found, in order
    of decreasing duration.
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
    """Solve (38) for a longer duration, from the unconstrained plan. Raises InfeasibleManeuver if that fails."""
    duration = SHORTEST + easy_duration(maneuver) / EASY - 1.0
    for _ in range(ATTEMPTS):
        duration *= LENGTHENING
        if duration > maneuver.duration:
            solution = solve_from_unconstrained(replace(maneuver, duration=duration), clock)
            if solution is not None:
                return solution
    raise infeasible(maneuver, None, clock)


def shortest_checked(maneuver: Maneuver, found: list[Solution], clock: TimeLimit) -> Trajectory | None:
    """Trajectory of the last solution that passes validation; None if there is none."""
    for solution in reversed(found):
        trajectory = checked_solution(replace(maneuver, duration=float(solution.t[-1])), solution, clock)
        if trajectory is not None:
            return trajectory
    return None


def checked_solution(maneuver: Maneuver, solution: Solution | None, clock: TimeLimit) -> Trajectory | None:
    """Trajectory of a refined solution of (38); None if it does not pass validation."""
    problem = ConstrainedProblem(maneuver, clock.check)
    fine = solution and problem.solve(solution, FINE)
    return validated(maneuver, fine and problem.trajectory(fine), clock)
