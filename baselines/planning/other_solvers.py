"""Plans by solvers that `plan` does not use: scipy's, IPOPT and fatrop in multiple shooting, do-mpc; for comparisons.

Each returns None if its solver finds no solution. The plans are not validated.
"""

import importlib
import math
from typing import Any

import numpy as np

from heli_gym.baselines.paper.boundary_value import ConstrainedProblem
from heli_gym.baselines.planning.collocation import import_casadi
from heli_gym.baselines.planning.paper_method import solve_from_unconstrained
from heli_gym.model import dynamics, hover_input
from heli_gym.trajectory import Maneuver, Trajectory


def plan_by_bvp(maneuver: Maneuver) -> Trajectory | None:
    """Plan of (38) by scipy's `solve_bvp` from the unconstrained plan, as in the paper."""
    solution = solve_from_unconstrained(maneuver)
    return None if solution is None else ConstrainedProblem(maneuver).trajectory(solution)


def multiple_shooting(maneuver: Maneuver, solver: str, intervals: int = 100) -> Trajectory | None:
    """Least effort by CasADi's multiple shooting with constant thrusts, one Runge-Kutta step per interval."""
    ca = import_casadi()
    p, limits, h = maneuver.parameters, maneuver.limits, maneuver.duration / intervals
    x, f = ca.SX.sym("x", 6), ca.SX.sym("f", 2)
    rate = dynamics(ca.vertsplit(x), (f[0] + f[1], f[0] - f[1]), p, ca.sin, ca.cos)
    rhs = ca.Function("rhs", [x, f], [ca.vertcat(*rate)])
    k1 = rhs(x, f)
    k2 = rhs(x + 0.5 * h * k1, f)
    k3 = rhs(x + 0.5 * h * k2, f)
    k4 = rhs(x + h * k3, f)
    step = ca.Function("step", [x, f], [x + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)])
    problem, states, inputs = ca.Opti(), [], []
    for k in range(intervals + 1):
        states.append(problem.variable(6))
        if k < intervals:
            inputs.append(problem.variable(2))
    low, high = maneuver.rig.thrust_bounds(limits.u)
    hover = 0.5 * float(hover_input(maneuver.goal[1], p)[0])
    for k in range(intervals + 1):
        if k < intervals:
            problem.subject_to(states[k + 1] == step(states[k], inputs[k]))
        if k in (0, intervals):
            problem.subject_to(states[k] == maneuver.ends[0 if k == 0 else 1])
        else:
            problem.subject_to(problem.bounded(limits.pitch_min, states[k][4], limits.pitch_max))
        if k < intervals:
            problem.subject_to(problem.bounded(low, inputs[k], high))
            problem.set_initial(inputs[k], hover)
    problem.minimize(sum(ca.sumsqr(f - hover) for f in inputs))
    quiet: dict[str, Any] = {"expand": True, "print_time": False}
    if solver == "fatrop":
        problem.solver(solver, quiet | {"structure_detection": "auto"}, {"print_level": 0})
    else:
        problem.solver(solver, quiet, {"print_level": 0, "sb": "yes"})
    try:
        solution = problem.solve()
    except RuntimeError:
        return None
    thrusts = np.array([np.asarray(solution.value(f)).ravel() for f in inputs]).T
    return held_thrusts(maneuver, thrusts, np.array([np.asarray(solution.value(state)).ravel() for state in states]).T)


def plan_by_do_mpc(maneuver: Maneuver, intervals: int = 100) -> Trajectory | None:
    """Least effort by do-mpc's collocation (IPOPT): one prediction over the whole duration, from the start."""
    ca, do_mpc = import_casadi(), importlib.import_module("do_mpc")
    p, limits = maneuver.parameters, maneuver.limits
    model = do_mpc.model.Model("continuous")
    x, f = model.set_variable("_x", "x", (6, 1)), model.set_variable("_u", "f", (2, 1))
    rate = dynamics(ca.vertsplit(x), (f[0] + f[1], f[0] - f[1]), p, ca.sin, ca.cos)
    model.set_rhs("x", ca.vertcat(*rate))
    model.setup()
    mpc = do_mpc.controller.MPC(model)
    mpc.set_param(n_horizon=intervals, t_step=maneuver.duration / intervals, store_full_solution=True)
    mpc.settings.supress_ipopt_output()
    hover = 0.5 * float(hover_input(maneuver.goal[1], p)[0])
    mpc.set_objective(mterm=ca.DM(0.0), lterm=ca.sumsqr(f - hover))
    low, high = maneuver.rig.thrust_bounds(limits.u)
    mpc.bounds["lower", "_u", "f"], mpc.bounds["upper", "_u", "f"] = low, high
    pitch = [-math.inf, -math.inf, -math.inf, -math.inf, limits.pitch_min, -math.inf]
    mpc.bounds["lower", "_x", "x"] = np.array(pitch)
    mpc.bounds["upper", "_x", "x"] = np.array([*([math.inf] * 4), limits.pitch_max, math.inf])
    mpc.terminal_bounds["lower", "x"] = mpc.terminal_bounds["upper", "x"] = maneuver.ends[1]
    mpc.setup()
    mpc.x0, mpc.u0 = maneuver.ends[0], np.full(2, hover)
    mpc.set_initial_guess()
    mpc.make_step(maneuver.ends[0])
    if not mpc.solver_stats["success"]:
        return None
    thrusts = np.array(
        [np.asarray(mpc.opt_x_num["_u", k, 0] * mpc.opt_x_scaling["_u", k, 0]).ravel() for k in range(intervals)]
    )
    states = np.array([np.asarray(mpc.opt_x_num["_x", k, 0, -1]).ravel() for k in range(intervals + 1)])
    return held_thrusts(maneuver, thrusts.T, states.T)


def held_thrusts(maneuver: Maneuver, f: np.ndarray, x: np.ndarray) -> Trajectory:
    """Trajectory of thrusts (2, N) that are constant over equal intervals, between states x (6, N + 1)."""
    intervals = f.shape[1]
    t = np.linspace(0.0, maneuver.duration, intervals + 1)
    u = maneuver.rig.voltage(np.clip(f, *maneuver.rig.thrust_bounds(maneuver.limits.u)))
    before_steps = t[1:-1] - 1e-6  # voltages are linear between samples: steps take a microsecond
    times = np.sort(np.concatenate((t, before_steps)))
    held = u[:, np.clip(np.floor((times + 1e-9) / t[1]).astype(int), 0, intervals - 1)]
    states = np.stack([np.interp(times, t, row) for row in x])
    return Trajectory(times, states, held, maneuver.limits, maneuver.rig)
