"""Sections III-B and III-D: maneuver in, Trajectory out."""

import math
from dataclasses import replace

import numpy as np
from scipy.integrate import solve_ivp

from baselines.boundary_value import FINE, ConstrainedProblem, Solution, solve_unconstrained, unconstrained_trajectory
from heli_gym.model import dynamics, thrust, virtual_input
from heli_gym.trajectory import Maneuver, Trajectory

METHODS = ("paper",)
ARRIVAL_TOLERANCE = 1e-3  # rad and rad/s, between the end of the replayed plan and the goal
LIMIT_TOLERANCE = 1e-6  # V and rad
LENGTHENING, ATTEMPTS = 1.4, 16  # factor by which the duration is stretched until a plan is found, and how often
FARTHEST, NEAREST = 0.1, 5e-3  # relative steps in which it is then shortened: the first, and the one that is the last
SHORTEST = 2.0  # s, of any maneuver that is worth trying


class InfeasibleManeuver(RuntimeError):
    """No plan was found that meets the limits of a maneuver.

    Attributes:
        shortest_duration: the shortest duration in s for which the same transition was planned; None if none was.
    """

    def __init__(self, message: str, shortest_duration: float | None = None) -> None:
        super().__init__(message)
        self.shortest_duration = shortest_duration


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


def plan(maneuver: Maneuver, method: str = "paper") -> Trajectory:
    """A trajectory from rest to rest that meets the maneuver's limits.

    The method "paper" solves (38) with the ansatz (39), (40), the unconstrained plan being the initial guess. If that
    finds nothing, it starts from a longer duration, which is easier, and shortens it step by step.
    What is returned has been replayed through (3) by an adaptive integrator: it ends within 1e-3 rad and 1e-3 rad/s
    of the goal, and stays within the limits to 1e-6 V and rad.

    Raises:
        ValueError: if the method is unknown.
        InfeasibleManeuver: if the method finds no such trajectory; names the constraint in the way and the shortest
            duration that it can plan.
    """
    if method not in METHODS:
        raise ValueError(f"method = {method!r}: one of {', '.join(METHODS)} is needed")
    trajectory = checked(maneuver, solve_from_unconstrained(maneuver))
    return plan_by_shortening(maneuver) if trajectory is None else trajectory


def solve_from_unconstrained(maneuver: Maneuver) -> Solution | None:
    """The paper's way: (14) first, then (38) from there."""
    unconstrained = solve_unconstrained(maneuver)
    if unconstrained is None:
        return None
    problem = ConstrainedProblem(maneuver)
    return problem.solve(problem.guess(unconstrained.stretched(maneuver.duration)))


def plan_by_shortening(maneuver: Maneuver) -> Trajectory:
    """Homotopy in the duration, from one that works down to the maneuver's, in steps that halve when one fails.

    The durations do not depend on the one that is asked for until they come near it: what is found for one is found for
    every longer one. Where a step leads past it only, to another branch of solutions, the way back up is tried.
    """
    found = [first_solution(maneuver)]
    step = FARTHEST

    def reach(duration: float, start: Solution) -> Solution | None:
        return ConstrainedProblem(replace(maneuver, duration=duration)).solve(start.stretched(duration))

    while step > NEAREST:
        shorter = float(found[-1].t[-1]) * (1.0 - step)
        if shorter > maneuver.duration:
            ahead = reach(shorter, found[-1])
            if ahead is not None:
                found.append(ahead)
                continue
        else:
            trajectory = checked(maneuver, reach(maneuver.duration, found[-1]))
            if trajectory is None and (below := reach(shorter, found[-1])):
                trajectory = checked(maneuver, reach(maneuver.duration, below))
            if trajectory is not None:
                return trajectory
        step /= 2.0
    raise infeasible(maneuver, found)


def first_solution(maneuver: Maneuver) -> Solution:
    """A solution of (38) in a longer time, found from the unconstrained plan; raises InfeasibleManeuver if none is."""
    # Level flight at the pitch limit accelerates the travel by b1/b2 a2 tan(q3), see (14a), half of the way.
    p, pitch = maneuver.parameters, min(np.abs(maneuver.limits.pitch))
    acceleration = abs(p.b1 / p.b2 * p.a2) * np.tan(pitch)
    duration = SHORTEST + 2.0 * np.sqrt(abs(maneuver.goal[0] - maneuver.start[0]) / acceleration)
    for _ in range(ATTEMPTS):
        duration *= LENGTHENING
        if duration > maneuver.duration:
            solution = solve_from_unconstrained(replace(maneuver, duration=duration))
            if solution is not None:
                return solution
    raise InfeasibleManeuver(f"no plan for {maneuver}, nor for the same in up to {duration:.0f} s")


def infeasible(maneuver: Maneuver, found: list[Solution]) -> InfeasibleManeuver:
    """What to say of a maneuver, given solutions of the same in longer and then ever shorter times."""
    for solution in reversed(found):
        shortest = checked(replace(maneuver, duration=float(solution.t[-1])), solution)
        if shortest is not None:
            break
    else:
        return InfeasibleManeuver(f"no plan for {maneuver}, nor for the same in up to {found[0].t[-1]:.0f} s")
    (low, high), (pitch_low, pitch_high) = maneuver.limits.u, maneuver.limits.pitch
    pitch_share = max(shortest.x[4].max() / pitch_high, shortest.x[4].min() / pitch_low)
    saturated = np.mean((shortest.u < low + LIMIT_TOLERANCE) | (shortest.u > high - LIMIT_TOLERANCE))
    return InfeasibleManeuver(
        f"no plan for {maneuver}; the shortest found takes {shortest.duration:.2f} s, "
        f"where the pitch reaches {pitch_share:.0%} of its limit and the voltages ride on theirs "
        f"{saturated:.0%} of the time",
        shortest.duration,
    )


def checked(maneuver: Maneuver, solution: Solution | None) -> Trajectory | None:
    """The trajectory of a solution if it keeps what `plan` promises, found by replaying its voltages through (3)."""
    fine = solution and ConstrainedProblem(maneuver).solve(solution, FINE)
    if fine is None:
        return None
    trajectory = ConstrainedProblem(maneuver).trajectory(fine)
    start, goal = trajectory.x[:, 0], trajectory.x[:, -1]

    # np.interp copies what is read-only
    times, (u_f, u_b) = trajectory.t.copy(), trajectory.u.copy()

    def rhs(t, x):
        u = np.array((np.interp(t, times, u_f), np.interp(t, times, u_b)))
        return dynamics(x, virtual_input(thrust(u, maneuver.parameters)), maneuver.parameters, math.sin, math.cos)

    replay = solve_ivp(rhs, (0.0, maneuver.duration), start, rtol=1e-7, atol=1e-9, max_step=0.05)
    arrives = np.abs(replay.y[:, -1] - goal).max() <= ARRIVAL_TOLERANCE
    limits = maneuver.limits
    within = all(
        low - LIMIT_TOLERANCE <= values.min() and values.max() <= high + LIMIT_TOLERANCE
        for values, (low, high) in (
            (trajectory.u, limits.u),
            (trajectory.x[4], limits.pitch),
            (replay.y[4], limits.pitch),
        )
    )
    return trajectory if arrives and within else None
