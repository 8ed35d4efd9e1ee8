"""Optimal control by direct collocation with CasADi and IPOPT: slow, but almost without assumptions.

Hermite-Simpson collocation of equation (3). Thrusts are linear between the nodes, so that they meet their limits there
too. The extra `ocp` must be installed.
"""

import math
import time
from dataclasses import replace
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from scipy.interpolate import CubicHermiteSpline

from heli_gym.baselines.paper.boundary_value import sample_times
from heli_gym.baselines.planning.lead import leading_trajectory
from heli_gym.baselines.planning.path import PATH_TOLERANCE, PathLimits, excesses, path_limits
from heli_gym.baselines.planning.spline import LEAD_MARGIN, via_estimates
from heli_gym.model import dynamics, hover_input, virtual_input
from heli_gym.parameters import PATH_LIMITS
from heli_gym.trajectory import Maneuver, Trajectory

OBJECTIVES = ("time", "effort")
INTERVALS = 100
FEWEST = 6  # intervals between via points
FEWEST_SAMPLES = 10  # of an interval
SHORTEST, LONGEST = 0.05, 600.0  # s, shortest transition and longest computation
STEPS = 3000  # largest number, of the interior-point method
THRUSTS = 400  # at which the bounds of their rates are tabulated
TIGHTENINGS = 7  # largest number of solutions, each within limits that are tightened by the excess of the last
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
    smooth: bool = False,
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
        smooth: whether the thrusts begin and end with those of hover where the maneuver is at rest.

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
    ends, turn = maneuver.ends, maneuver.goal[0] - maneuver.start[0]
    hover = 0.5 * float(hover_input(maneuver.goal[1], p)[0])
    x, f = ca.SX.sym("x", 6), ca.SX.sym("f", 2)
    derivative = dynamics(ca.vertsplit(x), (f[0] + f[1], f[0] - f[1]), p, ca.sin, ca.cos)
    rhs = ca.Function("rhs", [x, f], [ca.vertcat(*derivative)])

    problem = ca.Opti()
    X, F = problem.variable(6, n + 1), problem.variable(2, n + 1)
    shares, travel, elevation = via_estimates(maneuver, maneuver.duration)
    nodes = phase_nodes(shares, n)
    h, T = phase_steps(problem, maneuver, objective, shares, nodes, guess)
    left, right = slice(0, n), slice(1, n + 1)
    steps = ca.repmat(h.T, 6, 1)
    dX = rhs.map(n + 1)(X, F)
    middle = 0.5 * (X[:, left] + X[:, right]) + steps / 8.0 * (dX[:, left] - dX[:, right])
    between = rhs.map(n)(middle, 0.5 * (F[:, left] + F[:, right]))
    problem.subject_to(X[:, right] == X[:, left] + steps / 6.0 * (dX[:, left] + 4.0 * between + dX[:, right]))
    if maneuver.periodic:
        problem.subject_to(X[[0, 2], 0] == ends[0, [0, 2]])
        problem.subject_to(X[:, n] == X[:, 0] + np.array([turn, 0.0, 0.0, 0.0, 0.0, 0.0]))
        problem.subject_to(F[:, n] == F[:, 0])
    else:
        problem.subject_to(X[:, 0] == ends[0])
        known = [0, 1, 3, 4, 5] if maneuver.elevation_free else list(range(6))
        problem.subject_to(X[known, n] == ends[1, known])
        if maneuver.elevation_free:  # at rest in hover
            problem.subject_to(dX[[3, 5], n] == 0.0)
    for node, (_, angle, lift) in zip(nodes[1:-1], maneuver.via):
        problem.subject_to(X[0, int(node)] == angle)
        if lift is not None:
            problem.subject_to(X[2, int(node)] == lift)
    if smooth or maneuver.lead:  # rotors with lag begin in hover
        for k, state, point in ((0, maneuver.start_state, 0), (n, maneuver.goal_state, 1)):
            if state is None and not maneuver.periodic and not (k and maneuver.elevation_free):
                problem.subject_to(F[:, k] == 0.5 * float(hover_input(ends[point, 2], p)[0]))
    low, high = maneuver.rig.thrust_bounds(limits.u)
    problem.subject_to(problem.bounded(low, ca.vec(F), high))
    inner = slice(0 if maneuver.periodic else 1, n)  # ends given by a state may be at the limits
    problem.subject_to(problem.bounded(limits.pitch_min, X[4, inner].T, limits.pitch_max))
    problem.subject_to(problem.bounded(limits.pitch_min, middle[4, :].T, limits.pitch_max))
    constrain_way(problem, maneuver, X, F, h, tighter or {})
    if objective == "time":
        problem.minimize(T)
        problem.subject_to(problem.bounded(SHORTEST, T, maneuver.duration))
    else:
        problem.minimize(
            ca.dot(ca.vertcat(h[0], 0.5 * (h[left][1:] + h[left][:-1]), h[-1]), ca.sum1((F - hover) ** 2).T)
        )

    if guess is None:
        share = np.concatenate([np.linspace(a, b, k + 1)[:-1] for a, b, k in phases(shares, nodes)] + [[1.0]])
        rows = np.zeros((6, n + 1))
        rows[0], rows[2] = np.interp(share, shares, travel), np.interp(share, shares, elevation)
        for row in (1, 3):
            with np.errstate(all="ignore"):  # a via point next to the start, whose phase has no duration
                rates = np.gradient(rows[row - 1], share * maneuver.duration)
            rows[row] = np.where(np.isfinite(rates), rates, 0.0)
        if maneuver.is_from_rest_to_rest:
            rows[1] = rows[3] = 0.0
        problem.set_initial(X, rows)
        problem.set_initial(F, hover)
    else:
        problem.set_initial(X, guess.x)
        problem.set_initial(F, guess.f)
    options = {"print_level": 0, "sb": "yes", "max_iter": STEPS, "max_wall_time": max(time_limit, 1e-3)}
    problem.solver("ipopt", {"print_time": False}, options)
    try:
        solution = problem.solve()
    except RuntimeError:  # CasADi's exception if IPOPT does not converge
        return None
    t = np.concatenate(([0.0], np.cumsum(np.broadcast_to(solution.value(h), n))))
    if objective == "effort":
        t[-1] = maneuver.duration
    return Collocation(t, solution.value(X), solution.value(F))


def phase_nodes(shares: np.ndarray, intervals: int) -> np.ndarray:
    """Nodes of the start, the via points and the goal (V + 2,), at least FEWEST intervals apart."""
    spare = max(intervals - FEWEST * (len(shares) - 1), 0)
    counts = FEWEST + np.floor(spare * np.diff(shares)).astype(int)
    nodes = np.concatenate(([0], np.cumsum(counts)))
    nodes[-1] = intervals
    return nodes


def phases(shares: np.ndarray, nodes: np.ndarray) -> list[tuple[float, float, int]]:
    """Start and end of each phase between via points, as shares of the duration, and its number of intervals."""
    return [(a, b, int(k)) for a, b, k in zip(shares[:-1], shares[1:], np.diff(nodes))]


def phase_steps(
    problem: Any, maneuver: Maneuver, objective: str, shares: np.ndarray, nodes: np.ndarray, guess: Collocation | None
) -> tuple[Any, Any]:
    """Intervals (n,) in s, equal in each phase between via points, and the duration."""
    ca, timed = import_casadi(), [time is not None for time, *_ in maneuver.via]
    if objective == "effort" and all(timed):
        lengths = ca.DM(np.diff(shares) * maneuver.duration)
        total: Any = maneuver.duration
    else:
        lengths = problem.variable(len(shares) - 1)
        total = ca.sum1(lengths)
        times = shares * maneuver.duration if guess is None else guess.t[nodes]
        problem.set_initial(lengths, np.diff(times))
        problem.subject_to(lengths >= 0.5 * SHORTEST)
        if objective == "effort":
            problem.subject_to(total == maneuver.duration)
        passed = ca.cumsum(lengths)
        for k, (time, *_) in enumerate(maneuver.via):
            if time is not None:
                problem.subject_to(passed[k] == time)
    h = ca.vertcat(*(ca.repmat(lengths[k] / count, count, 1) for k, count in enumerate(np.diff(nodes).tolist())))
    return h, total


def constrain_way(problem: Any, maneuver: Maneuver, X: Any, F: Any, h: Any, tighter: dict[str, float]) -> None:
    """Add the maneuver's path constraints at the nodes to the problem; h are the intervals in s."""
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
    if path.slew is None and path.lead is None:
        return
    # bounds of df/dt in N/s as functions of the thrust f in N
    f = np.linspace(*rig.thrust_bounds(maneuver.limits.u), THRUSTS)
    w = rig.voltage(np.stack((f, f)))
    slopes = rig.thrust_slope(w)
    bounds = []
    if path.slew is not None:
        most = max(path.slew - tighter.get("slew", 0.0), 0.1 * path.slew)
        bounds.append((-most * slopes, most * slopes))
    if path.lead is not None:
        less = LEAD_MARGIN + tighter.get("lead", 0.0)
        limits = maneuver.limits.u_min + less, maneuver.limits.u_max - less
        bounds.append(tuple(slopes * (limit - w) / path.lead for limit in limits))
    for rotor in (0, 1):
        change = (F[rotor, 1:] - F[rotor, :-1]) / h.T
        for least, most in bounds:
            low, high = (ca.interpolant("bound", "linear", [f], values[rotor]) for values in (least, most))
            for at in (F[rotor, :-1], F[rotor, 1:]):
                problem.subject_to(change >= low.map(at.shape[1])(at))
                problem.subject_to(change <= high.map(at.shape[1])(at))


def pad_travel(travel: np.ndarray) -> np.ndarray:
    """Append a point far outside at each end of a floor's travel."""
    return np.concatenate((travel[:1] - FAR, travel, travel[-1:] + FAR))


def collocated_trajectory(
    maneuver: Maneuver, objective: str = "effort", time_limit: float | None = None, smooth: bool = False
) -> Trajectory | None:
    """Sampled solution of `collocate` that meets the limits between the nodes too; None if there is none.

    If the pitch exceeds its limits between two nodes, they are tightened by the excess, and the problem solved again.
    """
    deadline = math.inf if time_limit is None else time.perf_counter() + time_limit
    tight, found, tighter = maneuver, None, dict[str, float]()
    for _ in range(TIGHTENINGS):
        left = min(deadline - time.perf_counter(), LONGEST)
        found = collocate(tight, objective, INTERVALS, found, left, tighter, smooth) or collocate_from_relaxed(
            tight, objective, tighter, smooth, deadline
        )
        if found is None:
            return None
        trajectory = sample(replace(maneuver, duration=float(found.t[-1])), found)
        pitch, (low, high) = trajectory.x[4], maneuver.limits.pitch
        excess = max(low - pitch.min(), pitch.max() - high) + RESERVE
        over = {
            n: e
            for n, e in excesses(maneuver, trajectory.t, trajectory.x, trajectory.u).items()
            if e > 0.5 * PATH_TOLERANCE
        }
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


def collocate_from_relaxed(
    maneuver: Maneuver, objective: str, tighter: dict[str, float], smooth: bool, deadline: float
) -> Collocation | None:
    """Solution of `collocate` from one without path constraints and lead; None if there is none."""
    relaxed = dict.fromkeys(PATH_LIMITS)
    limits = replace(maneuver.limits, **relaxed)  # type: ignore[arg-type]
    easier = replace(maneuver, limits=limits, floor=None, lead=False)
    found = None
    for step in (easier, replace(easier, limits=maneuver.limits, floor=maneuver.floor), maneuver):
        if found is None and step is not easier:
            return None
        left = min(deadline - time.perf_counter(), LONGEST)
        if left <= 0.0:
            return None
        found = collocate(step, objective, INTERVALS, found, left, tighter, smooth)
    return found


def sample(maneuver: Maneuver, found: Collocation) -> Trajectory:
    """Sample a solution: thrusts linear and states cubic between the nodes, which are samples too."""
    p, step = maneuver.parameters, sample_times(maneuver)[1]
    t = np.append(
        np.concatenate(
            [
                np.linspace(begin, end, max(math.ceil((end - begin) / step), FEWEST_SAMPLES), endpoint=False)
                for begin, end in pairwise(found.t.tolist())
            ]
        ),
        maneuver.duration,
    )
    f = np.clip([np.interp(t, found.t, row) for row in found.f], *maneuver.rig.thrust_bounds(maneuver.limits.u))
    rates = np.stack(dynamics(found.x, virtual_input(found.f), p))
    x = CubicHermiteSpline(found.t, found.x, rates, axis=1)(t)
    ends = maneuver.ends
    if maneuver.periodic:
        ends = np.stack((x[:, 0], x[:, 0] + [maneuver.goal[0] - maneuver.start[0], 0.0, 0.0, 0.0, 0.0, 0.0]))
    if maneuver.elevation_free:
        ends[1, 2] = x[2, -1]
    x[:, [0, -1]] = ends.T
    u, lag = maneuver.rig.voltage(f), path_limits(maneuver).lead
    if lag is not None:
        return leading_trajectory(maneuver, t, x, u, lag)
    return Trajectory(t, x, u, maneuver.limits, maneuver.rig)
