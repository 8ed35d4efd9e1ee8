"""Optimal control by direct collocation with CasADi and IPOPT: slow, but almost without assumptions.

Hermite-Simpson collocation of equation (3). Thrusts are linear between the nodes, so that they meet their limits there
too. The extra `ocp` must be installed.
"""

import math
import time
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from scipy.interpolate import CubicHermiteSpline

from heli_gym.baselines.paper.boundary_value import sample_times
from heli_gym.baselines.planning.path import PathLimits, excesses, path_limits
from heli_gym.model import dynamics, hover_input, virtual_input
from heli_gym.trajectory import Maneuver, Trajectory

OBJECTIVES = ("time", "effort")
INTERVALS = 100
SHORTEST, LONGEST = 0.05, 600.0  # s, shortest transition and longest computation
STEPS = 3000  # largest number, of the interior-point method
TIGHTENINGS = 5  # largest number of times that the pitch limits are tightened
WAY_RESERVE = 1e-4  # rad and rad/s, margin to path constraints, which hold at the nodes only
FAR = 1e4  # rad, ends of the level extension of a floor
RESERVE = 3e-5  # rad, margin to the pitch limits for the interpolation error of the replayed plan


class Collocation(NamedTuple):
    """Solution of the collocation: times (K,) in s, states (6, K), and thrusts (2, K) in N, linear between nodes."""

    t: np.ndarray
    x: np.ndarray
    f: np.ndarray


def import_casadi() -> Any:
    """Import CasADi. Raises ImportError, which names the extra to install, if it is missing."""
    try:
        import casadi
    except ImportError as error:
        raise ImportError("optimal control needs CasADi: pip install 'heli-gym[ocp]'") from error
    return casadi


def collocate(
    maneuver: Maneuver,
    objective: str = "effort",
    intervals: int = INTERVALS,
    guess: Collocation | None = None,
    time_limit: float = LONGEST,
    tighter: dict[str, float] | None = None,
) -> Collocation | None:
    """Transition of least time, at most the maneuver's duration, or of least effort in exactly that duration.

    Effort is the integral of the squared distance of both thrusts from hover at the goal.

    Args:
        maneuver: the transition to plan.
        objective: "time" or "effort".
        intervals: number of collocation intervals.
        guess: initial guess; by default a straight line between the ends at hover thrust.
        time_limit: in s, for the solver.
        tighter: amounts by which path constraints are tightened, by name.

    Returns:
        A local optimum; None if the solver finds none.

    Raises:
        ValueError: if the objective is unknown.
        ImportError: if CasADi is missing.
    """
    if objective not in OBJECTIVES:
        raise ValueError(f"objective = {objective!r}: must be one of {', '.join(OBJECTIVES)}")
    ca = import_casadi()
    limits, p, n = maneuver.limits, maneuver.parameters, intervals
    ends = np.array([[travel, 0.0, elevation, 0.0, 0.0, 0.0] for travel, elevation in (maneuver.start, maneuver.goal)])
    hover = 0.5 * float(hover_input(maneuver.goal[1], p)[0])
    x, f = ca.SX.sym("x", 6), ca.SX.sym("f", 2)
    derivative = dynamics(ca.vertsplit(x), (f[0] + f[1], f[0] - f[1]), p, ca.sin, ca.cos)
    rhs = ca.Function("rhs", [x, f], [ca.vertcat(*derivative)])

    problem = ca.Opti()
    X, F = problem.variable(6, n + 1), problem.variable(2, n + 1)
    T = problem.variable() if objective == "time" else maneuver.duration
    h, left, right = T / n, slice(0, n), slice(1, n + 1)
    dX = rhs.map(n + 1)(X, F)
    middle = 0.5 * (X[:, left] + X[:, right]) + h / 8.0 * (dX[:, left] - dX[:, right])
    between = rhs.map(n)(middle, 0.5 * (F[:, left] + F[:, right]))
    problem.subject_to(X[:, right] == X[:, left] + h / 6.0 * (dX[:, left] + 4.0 * between + dX[:, right]))
    for k, end in ((0, ends[0]), (n, ends[1])):
        problem.subject_to(X[:, k] == end)
    low, high = maneuver.rig.thrust_bounds(limits.u)
    problem.subject_to(problem.bounded(low, ca.vec(F), high))
    problem.subject_to(problem.bounded(limits.pitch_min, X[4, :].T, limits.pitch_max))
    problem.subject_to(problem.bounded(limits.pitch_min, middle[4, :].T, limits.pitch_max))
    constrain_way(problem, maneuver, X, F, h, tighter or {})
    if objective == "time":
        problem.minimize(T)
        problem.subject_to(problem.bounded(SHORTEST, T, maneuver.duration))
        problem.set_initial(T, maneuver.duration if guess is None else guess.t[-1])
    else:
        problem.minimize(h * ca.sumsqr(F - hover))

    share = np.linspace(0.0, 1.0, n + 1)
    if guess is None:
        problem.set_initial(X, ends[0][:, None] + (ends[1] - ends[0])[:, None] * share)
        problem.set_initial(F, hover)
    else:
        times = share * guess.t[-1]
        problem.set_initial(X, np.stack([np.interp(times, guess.t, row) for row in guess.x]))
        problem.set_initial(F, np.stack([np.interp(times, guess.t, row) for row in guess.f]))
    options = {"print_level": 0, "sb": "yes", "max_iter": STEPS, "max_wall_time": max(time_limit, 1e-3)}
    problem.solver("ipopt", {"print_time": False}, options)
    try:
        solution = problem.solve()
    except RuntimeError:  # CasADi's exception if IPOPT does not converge
        return None
    return Collocation(share * float(solution.value(T)), solution.value(X), solution.value(F))


def constrain_way(problem: Any, maneuver: Maneuver, X: Any, F: Any, h: Any, tighter: dict[str, float]) -> None:
    """Add the maneuver's path constraints at the nodes to the problem; h is the interval in s."""
    ca, path, rig = import_casadi(), path_limits(maneuver), maneuver.rig
    reserve = {name: WAY_RESERVE + tighter.get(name, 0.0) for name in PathLimits._fields}
    if path.elevation_min is not None:
        problem.subject_to(path.elevation_min + reserve["elevation_min"] <= X[2, :].T)
    if path.elevation_max is not None:
        problem.subject_to(path.elevation_max - reserve["elevation_max"] >= X[2, :].T)
    for row, name, rate in ((1, "travel_rate", path.travel_rate), (3, "elevation_rate", path.elevation_rate)):
        if rate is not None:
            problem.subject_to(problem.bounded(reserve[name] - rate, X[row, :].T, rate - reserve[name]))
    if path.floor is not None:
        floor = ca.interpolant("floor", "linear", [pad_travel(path.floor[0])], np.pad(path.floor[1], 1, mode="edge"))
        problem.subject_to(X[2, :] <= floor.map(X.shape[1])(X[0, :]) - reserve["floor"])
    if path.slew is not None:
        slope = float(np.min(rig.thrust_slope(rig.hover_voltage(maneuver.goal[1]))))
        most = max(path.slew - tighter.get("slew", 0.0), 0.1 * path.slew) * slope  # in N/s, at hover
        problem.subject_to(problem.bounded(-most, ca.vec(F[:, 1:] - F[:, :-1]) / h, most))


def pad_travel(travel: np.ndarray) -> np.ndarray:
    """Append a point far outside at each end of a floor's travel."""
    return np.concatenate((travel[:1] - FAR, travel, travel[-1:] + FAR))


def collocated_trajectory(
    maneuver: Maneuver, objective: str = "effort", time_limit: float | None = None
) -> Trajectory | None:
    """Sampled solution of `collocate` that meets the limits between the nodes too; None if there is none.

    If the pitch exceeds its limits between two nodes, they are tightened by the excess, and the problem solved again.
    """
    deadline = math.inf if time_limit is None else time.perf_counter() + time_limit
    tight, found, tighter = maneuver, None, dict[str, float]()
    for _ in range(TIGHTENINGS):
        left = min(deadline - time.perf_counter(), LONGEST)
        found = collocate(tight, objective, INTERVALS, found, left, tighter)
        if found is None:
            return None
        trajectory = sample(replace(maneuver, duration=float(found.t[-1])), found)
        pitch, (low, high) = trajectory.x[4], maneuver.limits.pitch
        excess = max(low - pitch.min(), pitch.max() - high) + RESERVE
        over = {n: e for n, e in excesses(maneuver, trajectory.t, trajectory.x, trajectory.u).items() if e > 0.0}
        if excess <= 0.0 and not over:
            return trajectory
        tighter |= {name: tighter.get(name, 0.0) + 1.5 * amount for name, amount in over.items()}
        excess = max(excess, 0.0)
        pitch_min, pitch_max = tight.limits.pitch
        excess *= 1.5
        if not pitch_min + excess < 0.0 < pitch_max - excess:
            return None
        tight = replace(
            maneuver, limits=replace(maneuver.limits, pitch_min=pitch_min + excess, pitch_max=pitch_max - excess)
        )
    return None


def sample(maneuver: Maneuver, found: Collocation) -> Trajectory:
    """Sample a solution: thrusts linear and states cubic between the nodes."""
    p, t = maneuver.parameters, sample_times(maneuver)
    f = np.clip([np.interp(t, found.t, row) for row in found.f], *maneuver.rig.thrust_bounds(maneuver.limits.u))
    rates = np.stack(dynamics(found.x, virtual_input(found.f), p))
    x = CubicHermiteSpline(found.t, found.x, rates, axis=1)(t)
    for k, (travel, elevation) in ((0, maneuver.start), (-1, maneuver.goal)):
        x[:, k] = travel, 0.0, elevation, 0.0, 0.0, 0.0
    return Trajectory(t, x, maneuver.rig.voltage(f), maneuver.limits, maneuver.rig)
