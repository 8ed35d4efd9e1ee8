"""Splines for an objective against collocation of the same one: `python benchmarks/planning_objectives.py`.

Needs the extras `eval` and `ocp`. Both start and end in hover; IPOPT starts from the spline. Rates also of the paper's
plan, where it has one.
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from heli_gym import Maneuver, Trajectory
from heli_gym.baselines import InfeasibleManeuver, plan, plan_fastest
from heli_gym.baselines.evaluation.planner_comparison import random_maneuver
from heli_gym.baselines.planning.collocation import import_casadi
from heli_gym.baselines.planning.path import path_limits
from heli_gym.model import dynamics, hover_input

INTERVALS = 120
DURATIONS = 10.0, 12.0, 20.0  # s, of the paper's rotation
RANDOM, SEED, LEISURE = 4, 1, 1.3  # number and seed of random maneuvers, durations relative to their shortest
EASY, EASY_LEISURE = 6, 2.0  # likewise of easy ones
PATIENCE = 60.0  # s, for a plan of the paper's


def optimum(maneuver: Maneuver, objective: str, near: Trajectory) -> float:
    """Best value of an objective, "smoothest" or "reserve", by Hermite-Simpson collocation; NaN without a solution."""
    ca: Any = import_casadi()
    p, n, h, limits = maneuver.parameters, INTERVALS, maneuver.duration / INTERVALS, maneuver.limits
    x, f = ca.SX.sym("x", 6), ca.SX.sym("f", 2)
    rate = dynamics(ca.vertsplit(x), (f[0] + f[1], f[0] - f[1]), p, ca.sin, ca.cos)
    rhs = ca.Function("rhs", [x, f], [ca.vertcat(*rate)])
    problem = ca.Opti()
    X, F, share = problem.variable(6, n + 1), problem.variable(2, n + 1), problem.variable()
    dX = rhs.map(n + 1)(X, F)
    middle = 0.5 * (X[:, :n] + X[:, 1:]) + h / 8.0 * (dX[:, :n] - dX[:, 1:])
    between = rhs.map(n)(middle, 0.5 * (F[:, :n] + F[:, 1:]))
    problem.subject_to(X[:, 1:] == X[:, :n] + h / 6.0 * (dX[:, :n] + 4.0 * between + dX[:, 1:]))
    for node, end in zip((0, n), maneuver.ends):
        problem.subject_to(X[:, node] == end)
        problem.subject_to(F[:, node] == 0.5 * float(hover_input(end[2], p)[0]))
    low, high = maneuver.rig.thrust_bounds(limits.u)
    problem.subject_to(problem.bounded(low, ca.vec(F), high))
    table = path_limits(maneuver).elevation_max
    if table is not None:
        problem.subject_to(table >= X[2, :].T)
    # ranges narrow about their centres by the reserve
    narrowed = [(X[4, :].T, limits.pitch), (middle[4, :].T, limits.pitch)]
    if objective == "reserve":
        thrusts = np.linspace(low, high, 400)
        voltage = ca.interpolant("u", "bspline", [thrusts], maneuver.rig.voltage(np.stack((thrusts, thrusts)))[0])
        narrowed.append((voltage.map(2 * (n + 1))(ca.vec(F).T).T, limits.u))
    for values, (least, most) in narrowed:
        centre, half = 0.5 * (least + most), 0.5 * (1.0 - share) * (most - least)
        problem.subject_to(values <= centre + half)
        problem.subject_to(values >= centre - half)
    rates = 2.0 * ca.sumsqr(F[:, 1:] - F[:, :n]) / h  # of both v1 and v2
    if objective == "reserve":
        problem.minimize(-share + 1e-6 * rates)
    else:
        problem.subject_to(share == 0.0)
        problem.minimize(rates)
    at, guess_u = near(np.linspace(0.0, maneuver.duration, n + 1))
    problem.set_initial(X, at)
    problem.set_initial(F, maneuver.rig.thrust(guess_u))
    problem.solver("ipopt", {"print_time": False}, {"print_level": 0, "sb": "yes", "max_wall_time": 60.0})
    try:
        solution = problem.solve()
    except RuntimeError:  # CasADi's exception if IPOPT does not converge
        return np.nan
    return float(solution.value(share if objective == "reserve" else rates))


def value(maneuver: Maneuver, objective: str, found: Trajectory) -> float:
    """Value of an objective of a plan."""
    if objective == "smoothest":
        f = maneuver.rig.thrust(found.u)
        return 2.0 * float((np.diff(f) ** 2 / np.diff(found.t)).sum())
    free = []
    for values, (least, most) in ((found.u, maneuver.limits.u), (found.x[4], maneuver.limits.pitch)):
        free.append(min(values.min() - least, most - values.max()) / (0.5 * (most - least)))
    return float(min(free))


def maneuvers() -> Iterator[Maneuver]:
    """Yield the paper's rotation in DURATIONS, and random maneuvers."""
    for duration in DURATIONS:
        yield Maneuver(duration=duration)
    rng = np.random.default_rng(SEED)
    for leisure in RANDOM * [LEISURE] + EASY * [EASY_LEISURE]:
        maneuver = random_maneuver(rng)
        yield replace(maneuver, duration=round(leisure * plan_fastest(maneuver).duration, 1))


def main() -> None:
    """Print the value of each objective by splines and by collocation."""
    for maneuver in maneuvers():
        print(maneuver)
        for objective in ("smoothest", "reserve"):
            found = plan(maneuver, "spline", objective=objective)
            by_spline, best = value(maneuver, objective, found), optimum(maneuver, objective, found)
            line = f"  {objective:10s} spline {by_spline:.5f}, collocation {best:.5f}"
            if objective == "smoothest":
                try:
                    line += f", paper {value(maneuver, objective, plan(maneuver, 'paper', PATIENCE)):.5f}"
                except InfeasibleManeuver:
                    line += ", no plan of the paper's"
            print(line, flush=True)


if __name__ == "__main__":
    main()
