"""Speed of planning and gains compared to common alternatives: `python benchmarks/planning.py`, with the extra `dev`.

All rows are for the paper's maneuver, medians after a warm-up. Compare only rows of one run.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy; threads slow down 6x6 matrices

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import tyro
from numba import njit
from rich.console import Console
from rich.table import Table
from scipy.integrate import odeint, solve_bvp, solve_ivp
from scipy.optimize import fsolve

from heli_gym import Maneuver, Trajectory, linearise, thrust
from heli_gym.baselines import InfeasibleManeuver, ManeuverSampler, plan, riccati_gains
from heli_gym.baselines.paper.boundary_value import COARSE, MAX_NODES, ConstrainedProblem, Solution, solve_unconstrained
from heli_gym.baselines.paper.riccati import integrate, jacobians_along
from heli_gym.baselines.paper.shooting import shooter, solve_by_shooting, solve_near, unconstrained_guess
from heli_gym.baselines.paper.tvlqr import Q, R, integrate_stiff, stationary_cost
from heli_gym.baselines.planning import spline, spline_search
from heli_gym.baselines.planning.collocation import collocate
from heli_gym.baselines.planning.other_solvers import multiple_shooting
from heli_gym.model import virtual_input

REPLAN_LEFT = 10.5, 9.0, 7.0, 5.0, 3.0, 1.5, 1.0, 0.5  # s
REPLANS = 20
REPLAN_ERRORS = np.array([0.01, 0.02, 0.01, 0.02, 0.02, 0.04])  # rad and rad/s, standard deviations


@dataclass
class Args:
    """Time the planners and the Riccati equation."""

    repetitions: int = 30  # largest number, within the seconds below
    seconds: float = 2.0  # per row


def median(function: Callable[[], Any], args: Args) -> float:
    """Median duration of a call in s."""
    function()
    times: list[float] = []
    while len(times) < 3 or (len(times) < args.repetitions and sum(times) < args.seconds):
        began = time.perf_counter()
        function()
        times.append(time.perf_counter() - began)
    return float(np.median(times))


def solve_by_bvp(problem: ConstrainedProblem, guess: Solution, analytic: bool) -> Any:
    """Solve (38) by scipy's `solve_bvp`, related to the paper's bvp4c."""
    start, goal = problem.ends()
    jacobians: dict[str, Any] = {}
    if analytic:
        jacobians["fun_jac"] = problem.rhs_jacobian
        jacobians["bc_jac"] = lambda Ya, Yb, p: (np.eye(12, 6), np.eye(12, 6, k=-6), np.zeros((12, 6)))

    def ends(Ya, Yb, p):
        return np.concatenate((Ya - start, Yb - goal))

    return solve_bvp(problem.rhs, ends, guess.t, guess.Y, guess.p, tol=COARSE, max_nodes=MAX_NODES[COARSE], **jacobians)


def planning(args: Args) -> dict[str, float]:
    """Durations in s of planners, by row name."""
    maneuver = Maneuver()
    problem, bounds = ConstrainedProblem(maneuver), spline.Bounds(maneuver.rig.thrust_bounds(maneuver.limits.u))
    start = spline.guess(maneuver, maneuver.duration, spline_search.SEGMENTS[0])
    near = plan(replace(maneuver, duration=10.1), "paper")
    near_spline = plan(replace(maneuver, duration=10.1), "spline")
    close = spline.guess_from(maneuver, near_spline, spline_search.SEGMENTS[0])

    def paper_guess() -> Solution:
        unconstrained = solve_unconstrained(maneuver)
        assert unconstrained is not None
        return problem.guess(unconstrained.stretched(maneuver.duration))

    guess = paper_guess()

    def shooting_guess() -> Solution:
        unconstrained = unconstrained_guess(maneuver)
        assert unconstrained is not None
        return problem.guess(unconstrained)

    shoot = shooter(problem, 400)

    def end(p: np.ndarray) -> np.ndarray:
        return shoot(np.zeros((6, 2)), p).defects[0]

    return {
        "plan(method='spline'), sampled and checked": median(lambda: plan(maneuver, "spline"), args),
        "  of which the interior-point method": median(lambda: spline.smoothest(maneuver, start, bounds), args),
        "  of which the same from the plan in 10.1 s": median(
            lambda: spline.smoothest(maneuver, close, bounds, spline.WARM), args
        ),
        "plan(method='spline', near=the plan in 10.1 s)": median(
            lambda: plan(maneuver, "spline", near=near_spline), args
        ),
        "plan(method='paper'), sampled and checked": median(lambda: plan(maneuver, "paper"), args),
        "  of which (38) from the paper's initial guess": median(lambda: solve_by_shooting(maneuver), args),
        "  of which that guess": median(shooting_guess, args),
        "  of which (38) from the plan in 10.1 s": median(lambda: solve_near(maneuver, near), args),
        "plan(method='paper', near=the plan in 10.1 s)": median(lambda: plan(maneuver, "paper", near=near), args),
        "(38), solve_bvp, analytic Jacobians": median(lambda: solve_by_bvp(problem, guess, True), args),
        "(38), solve_bvp, without Jacobians": median(lambda: solve_by_bvp(problem, guess, False), args),
        "(38), compiled RK4, 400 steps, and fsolve": median(lambda: fsolve(end, np.zeros(6), xtol=1e-7), args),
        "CasADi, collocation, IPOPT, built and solved": median(lambda: collocate(maneuver, "effort"), args),
        "CasADi, multiple shooting, IPOPT, built and solved": median(
            lambda: multiple_shooting(maneuver, "ipopt"), args
        ),
        "CasADi, multiple shooting, fatrop, built and solved": median(
            lambda: multiple_shooting(maneuver, "fatrop"), args
        ),
    }


@njit
def riccati_rhs(p, tau, t, J, Q, R):
    """Equation (50), backwards in time, with the linearisation linear between samples; P (6, 6) as a vector."""
    s = min(max((t[-1] - tau) / t[1], 0.0), len(t) - 1.0)
    k = min(int(s), len(t) - 2)
    now = (k + 1 - s) * J[k] + (s - k) * J[k + 1]
    A, B, P = np.ascontiguousarray(now[:, :6]), np.ascontiguousarray(now[:, 6:]), p.reshape(6, 6)
    PB = P @ B
    return (A.T @ P + P @ A + Q - PB @ R @ PB.T).ravel()


def gains(args: Args) -> dict[str, float]:
    """Durations in s of gain computations, by row name."""
    maneuver = Maneuver()
    reference, parameters = plan(maneuver), maneuver.parameters
    M, R_inverse = stationary_cost(0.0, parameters, Q, R), np.linalg.inv(R)
    t = np.linspace(0.0, reference.duration, 501)

    def along(reference: Trajectory) -> tuple[np.ndarray, np.ndarray]:
        x, u = reference(t)
        return x, np.stack(virtual_input(thrust(u, parameters)))

    J, rows, columns = jacobians_along(*along(reference), parameters)

    def rhs(tau, p):
        x, u = reference(reference.duration - tau)
        A, B = linearise(x, np.stack(virtual_input(thrust(u, parameters))), parameters)
        P = p.reshape(6, 6)
        return (A.T @ P + P @ A + Q - P @ B @ R_inverse @ B.T @ P).ravel()

    return {
        "riccati_gains, all of it, M given": median(lambda: riccati_gains(reference, parameters, M=M), args),
        "  with M of the stationary regulator": median(lambda: riccati_gains(reference, parameters), args),
        "  of which the linearisation": median(lambda: jacobians_along(*along(reference), parameters), args),
        "  of which RK4 on what does not vanish": median(
            lambda: integrate(J, rows, columns, Q, R, M, 2.0 * t[1]), args
        ),
        "Magnus expansion, for stiff weights": median(
            lambda: integrate_stiff(reference, maneuver.rig, Q, R, M, t), args
        ),
        "LSODA, compiled right-hand side, rtol 1e-6": median(
            lambda: odeint(riccati_rhs, M.ravel(), t, (t, J, Q, R_inverse), rtol=1e-6, atol=1e-8), args
        ),
        "RK45, numpy right-hand side, rtol 1e-6": median(
            lambda: solve_ivp(rhs, (0.0, reference.duration), M.ravel(), rtol=1e-6, atol=1e-8), args
        ),
    }


def sampling(args: Args) -> dict[str, float]:
    """Durations in s of random plans, by row name."""
    sampler, rng = ManeuverSampler(), np.random.default_rng(0)
    return {"100 plans of random maneuvers in 12 s": median(lambda: [sampler(rng) for _ in range(100)], args)}


def replanning(args: Args) -> dict[str, float]:
    """CPU time in s of plans from measured states, by time left: median and worst, planned or refused."""
    flown, rng = plan(Maneuver(duration=11.0), "spline"), np.random.default_rng(0)
    rows: dict[str, float] = {}
    for left in REPLAN_LEFT:
        times, refused = [], 0
        for k in range(REPLANS + 1):
            x = flown(11.0 - left)[0] + REPLAN_ERRORS * rng.normal(size=6)
            began = time.thread_time()
            try:
                plan(Maneuver(duration=left), near=flown, start_state=x)
            except InfeasibleManeuver:
                refused += k > 0
            if k > 0:  # the first one loads the kernels
                times.append(time.thread_time() - began)
        rows[f"{left:g} s left, median, {refused} of {REPLANS} refused"] = float(np.median(times))
        rows[f"{left:g} s left, worst"] = max(times)
    return rows


def main(args: Args) -> None:
    """Print a table for each of `replanning`, `planning`, `gains` and `sampling`."""
    console = Console()
    for title, group in (
        ("from a measured state", replanning),
        ("planning", planning),
        ("gains along 10 s", gains),
        ("random maneuvers", sampling),
    ):
        rows = group(args)
        first = next(iter(rows.values()))
        table = Table("", "time (ms)", "ratio", title=title)
        for name, seconds in rows.items():
            table.add_row(name, f"{1e3 * seconds:.3g}", f"{seconds / first:.2g}")
        console.print(table)


if __name__ == "__main__":
    main(tyro.cli(Args, description=__doc__))
