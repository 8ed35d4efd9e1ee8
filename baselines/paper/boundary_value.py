"""Sections III-B and III-D: boundary value problems (14) and (38) of a maneuver, and their solutions."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import Polynomial
from numpy.polynomial.polynomial import polyval
from scipy.integrate import solve_bvp

from heli_gym.baselines.paper.jacobian import STEP
from heli_gym.baselines.paper.normal_form import ddy1_bounds, ddy2_bounds, internal_dynamics
from heli_gym.baselines.paper.saturation import Saturation, ddy2, psi1, psi1_inverse, psi2_bounds, ramp
from heli_gym.compilation import jit_cached
from heli_gym.model import dynamics, fan_thrusts, inverse_dynamics, linearise
from heli_gym.parameters import HelicopterParameters
from heli_gym.trajectory import Maneuver, Trajectory

KAPPA = (2, 4)  # (40)
MESH = {14: 50, 38: 100}  # points of the first mesh, by equation; 50 as in Section III-B
COARSE, FINE = 1e-3, 1e-5  # relative residuals of the search and of the plan
MAX_NODES = {COARSE: 500, FINE: 2000}
SAMPLE_PERIOD = 1e-3  # s, largest step between samples of a plan: the paper's sampling time (Section IV)
MOST_SAMPLES = 200_000  # of a plan: longer plans have larger steps
CLOSEST_PITCH = 0.95  # share of the pitch limit to which the first guess is clipped: psi1 never reaches it
PITCH_RESERVE = 1e-5  # share by which (26) is tightened, so that the replayed pitch meets its limits between samples

# Setup polynomials of Section III-B over t/T. The paper gives their boundary conditions (12b) and (12c); we add
# zero second derivatives, so that the inputs start and end at hover.
RISE = Polynomial([0.0, 0.0, 0.0, 10.0, -15.0, 6.0])
BUMP = Polynomial([0.0, 0.0, 0.0, 1.0, -3.0, 3.0, -1.0])
BUMPS = (BUMP, Polynomial([0.0, 1.0]) * BUMP)
# Coefficients (8, 3, 3) of these three, and of their first two derivatives: [power, polynomial, derivative].
COEFFICIENTS = np.zeros((8, 3, 3))
for k, polynomial in enumerate((RISE, *BUMPS)):
    for n in range(3):
        COEFFICIENTS[: polynomial.degree() + 1 - n, k, n] = polynomial.deriv(n).coef


class Solution(NamedTuple):
    """Solution of (14) or (38), or an initial guess."""

    t: np.ndarray  # (K,)
    Y: np.ndarray  # (2, K) eta and its rate, or (6, K) y1, its rate, xi1, xi2, eta, its rate
    p: np.ndarray  # (2,) or (6,) free parameters
    interpolate: Any = None  # t (N,) -> Y

    def stretched(self, duration: float) -> "Solution":
        """Scale the motion to another duration on a new mesh: rates scale with 1/T, accelerations with 1/T²."""
        ratio = self.t[-1] / duration
        rates = np.array([1.0, ratio] * (len(self.Y) // 2))
        t = np.linspace(0.0, self.t[-1], MESH[38])
        return Solution(t / ratio, rates[:, None] * self.interpolate(t), ratio**2 * self.p)


# Section III-B: without constraints


def setup_functions(maneuver: Maneuver, t: np.ndarray, p: np.ndarray) -> np.ndarray:
    """Upsilon1 and Upsilon2 with their first two derivatives: (2, 3, K), [output, derivative, time]."""
    T = maneuver.duration
    start, goal = maneuver.start[1], maneuver.goal[1]
    rise, first, second = COEFFICIENTS.transpose(1, 0, 2)
    outputs = np.stack(((goal - start) * rise, p[0] * first + p[1] * second), axis=1) / T ** np.arange(3)
    outputs[0, 0, 0] += start
    return polyval(t / T, outputs)


def solve_unconstrained(maneuver: Maneuver, tolerance: float = COARSE) -> Solution | None:
    """Solve (14) with two free parameters from a linear guess, as in the paper; None if there is no solution."""
    T, (eta_0, _), (eta_T, _), parameters = maneuver.duration, maneuver.start, maneuver.goal, maneuver.parameters

    def acceleration(t, Y, outputs):
        (y1, dy1, ddy1), (y2, dy2, _) = outputs
        return internal_dynamics((*Y, y1, dy1, y2, dy2), ddy1, parameters)

    def rhs(t, Y, p):
        return np.stack((Y[1], acceleration(t, Y, setup_functions(maneuver, t, p))))

    def rhs_jacobian(t, Y, p):
        outputs = setup_functions(maneuver, t, p).astype(complex)
        dY, dp = np.zeros((2, 2, len(t))), np.zeros((2, 2, len(t)))
        dY[0, 1] = 1.0
        for k in range(2):  # complex steps
            dY[1, k] = acceleration(t, Y + 1j * STEP * np.eye(2)[k][:, None], outputs).imag / STEP
            moved = outputs.copy()
            moved[1] += 1j * STEP * polyval(t / T, COEFFICIENTS[:, 1 + k]) / T ** np.arange(3)[:, None]
            dp[1, k] = acceleration(t, Y, moved).imag / STEP
        return dY, dp

    def boundary(Ya, Yb, p):
        return np.array([Ya[0] - eta_0, Ya[1], Yb[0] - eta_T, Yb[1]])

    def boundary_jacobian(Ya, Yb, p):
        return np.eye(4, 2), np.eye(4, 2, k=-2), np.zeros((4, 2))

    t = np.linspace(0.0, T, MESH[14])
    guess = Solution(t, np.stack((eta_0 + (eta_T - eta_0) * t / T, np.full_like(t, (eta_T - eta_0) / T))), np.zeros(2))
    solution = run_solver(rhs, boundary, guess, rhs_jacobian, boundary_jacobian, tolerance)
    # beyond 90 degrees the tangent has another branch, unreachable in flight
    if solution is None or np.abs(setup_functions(maneuver, solution.t, solution.p)[1, 0]).max() >= np.pi / 2:
        return None
    return solution


def unconstrained_trajectory(maneuver: Maneuver, solution: Solution) -> Trajectory:
    """Convert a solution of (14) to states and voltages, by (13) and the inverses of (4) and (2)."""
    t = sample_times(maneuver)
    (y1, dy1, ddy1), (y2, dy2, ddy2_) = setup_functions(maneuver, t, solution.p)
    x = np.stack((*solution.interpolate(t), y1, dy1, y2, dy2))
    u = maneuver.rig.voltage(fan_thrusts(inverse_dynamics(x, ddy1, ddy2_, maneuver.parameters)))
    return Trajectory(t, x, u, maneuver.limits, maneuver.rig)


# Section III-D: with constraints


class Motion(NamedTuple):
    """Algebraic variables of (38) at each time: arrays (K,), the state x (6, K) and the inputs v (2, K)."""

    pitch: Saturation
    x: Any  # the state (44)
    dxi2: Any
    ddy1: Any
    ddeta: Any
    v: Any
    free1: Any  # whether psi3 and psi2 are off their bounds
    free2: Any


def constrained_motion(Y: Any, phi: Any, pitch_bounds: Any, f: Any, parameters: HelicopterParameters) -> Motion:
    """Saturated accelerations and inputs of (38): (25), (30)-(34), (37), then (13).

    Y (6, ...) are the states, phi (2, ...) the new inputs, f the bounds of the thrusts.
    """
    y1, dy1, xi1, xi2, eta, deta = Y
    phi1, phi2 = phi
    pitch = psi1(xi1, pitch_bounds)
    x = eta, deta, y1, dy1, pitch.value, pitch.slope * xi2
    dxi2 = ramp(phi2, psi2_bounds(ddy2_bounds(x, f, parameters), pitch, xi2))
    ddy2_ = ddy2(pitch, xi2, dxi2)
    _, v2 = inverse_dynamics(x, 0.0, ddy2_, parameters)
    ddy1 = ramp(phi1, ddy1_bounds(x, v2, f, parameters))
    v = inverse_dynamics(x, ddy1, ddy2_, parameters)
    ddeta = dynamics(x, v, parameters)[1]
    return Motion(pitch, x, dxi2, ddy1, ddeta, v, ddy1 == phi1, dxi2 == phi2)


def new_inputs(tau: float, p: Any) -> tuple:
    """Equation (39): phi1 and phi2 at a share tau of the duration, for parameters p (6,)."""
    phi1, phi2 = 0.0, 0.0
    power = tau
    for k in range(KAPPA[0]):
        power *= tau
        phi1 += p[k] * (power - tau)
    power = tau
    for k in range(KAPPA[1]):
        power *= tau
        phi2 += p[KAPPA[0] + k] * (power - tau)
    return phi1, phi2


@cache
def sampling_kernel() -> Callable:
    """Compile a function that fills in x (6, K) and thrusts (2, K) for states Y (6, K) of (38) at equidistant times."""

    def sample(Y, p, pitch_bounds, f, parameters, x, thrusts):
        for k in range(Y.shape[1]):
            y1, dy1, xi1, xi2, eta, deta = Y[0, k], Y[1, k], Y[2, k], Y[3, k], Y[4, k], Y[5, k]
            phi = new_inputs(k / (Y.shape[1] - 1), p)
            motion = constrained_motion((y1, dy1, xi1, xi2, eta, deta), phi, pitch_bounds, f, parameters)
            x[0, k], x[1, k], x[2, k], x[3, k] = eta, deta, y1, dy1
            x[4, k], x[5, k] = motion.pitch.value, motion.pitch.slope * xi2
            thrusts[0, k], thrusts[1, k] = fan_thrusts(motion.v)

    return jit_cached(sample, fast=True)


def constrained_rhs(Y: Any, motion: Motion) -> tuple:
    """Time derivative of the states Y (6, ...) of (38)."""
    return Y[1], motion.ddy1, Y[3], motion.dxi2, Y[5], motion.ddeta


def changes(dY: Any, dphi: Any, Y: Any, motion: Motion, columns: Any, f: Any) -> tuple:
    """First-order changes of ddy1, d xi2/dt and ddeta of (38) with dY (6, ...) and dphi (2, ...).

    `columns` (8, 6, ...) are the derivatives of (3) by x and v. The corners of a ramp have the inner derivative.
    """
    m, xi2 = motion, Y[3]
    _, slope, curvature, third = m.pitch
    free1, free2 = 1.0 * m.free1, 1.0 * m.free2
    dy1, ddy1, dxi1, dxi2, deta, ddeta = dY
    dx = deta, ddeta, dy1, ddy1, slope * dxi1, curvature * xi2 * dxi1 + slope * dxi2
    c0, c1, c2, c3, c4, c5, by_v1, by_v2 = columns
    on_eta = c0[1] * dx[0] + c1[1] * dx[1] + c2[1] * dx[2] + c3[1] * dx[3] + c4[1] * dx[4] + c5[1] * dx[5]
    on_y1 = c0[3] * dx[0] + c1[3] * dx[1] + c2[3] * dx[2] + c3[3] * dx[3] + c4[3] * dx[4] + c5[3] * dx[5]
    on_y2 = c0[5] * dx[0] + c1[5] * dx[1] + c2[5] * dx[2] + c3[5] * dx[3] + c4[5] * dx[4] + c5[5] * dx[5]

    # Off the bounds of (33), v2 follows from (30); on them, it is constant.
    bend = (xi2**2 * third + m.dxi2 * curvature) * dxi1 + 2.0 * curvature * xi2 * dxi2
    # for large |xi1| the slope underflows, and no bound is active
    d_dxi2 = free2 * dphi[1] + (1.0 - free2) * (on_y2 - bend) / (slope + free2)
    dv2 = free2 * (bend + slope * dphi[1] - on_y2) / by_v2[5]
    # Off the bounds of (22), v1 follows from (13a); on them, v1 is constant plus or minus |v2|, see (20).
    on_lower = 1.0 * (m.v[0] < f[0] + f[1])
    dv1 = free1 * (dphi[0] - on_y1) / by_v1[3] + (1.0 - free1) * (2.0 * on_lower - 1.0) * np.sign(m.v[1]) * dv2
    return on_y1 + by_v1[3] * dv1, d_dxi2, on_eta + by_v1[1] * dv1


@dataclass(frozen=True)
class ConstrainedProblem:
    """Boundary value problem (38) of a maneuver: Y = (y1, dy1, xi1, xi2, eta, deta), p = (p1, p2) of (39).

    The solver calls `check` regularly; an exception from it ends the solution.
    """

    maneuver: Maneuver
    check: Callable[[], None] = lambda: None

    @property
    def pitch_bounds(self) -> tuple[float, float]:
        """Equation (26)."""
        low, high = self.maneuver.limits.pitch
        return low * (1.0 - PITCH_RESERVE), high * (1.0 - PITCH_RESERVE)

    def ansatz(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Equation (39): basis functions of Phi1 (kappa1, K) and of Phi2 (kappa2, K)."""
        tau = t / self.maneuver.duration
        basis = [np.stack([tau ** (k + 1) - tau for k in range(1, kappa + 1)]) for kappa in KAPPA]
        return basis[0], basis[1]

    def motion(self, t: np.ndarray, Y: np.ndarray, p: np.ndarray) -> Motion:
        """Saturated accelerations and inputs of (38) at the times t, under the ansatz (39)."""
        basis1, basis2 = self.ansatz(t)
        phi = p[: KAPPA[0]] @ basis1, p[KAPPA[0] :] @ basis2
        f = self.maneuver.rig.thrust_bounds(self.maneuver.limits.u)
        with np.errstate(divide="ignore"):  # the slope of psi1 underflows close to its bounds
            return constrained_motion(Y, phi, self.pitch_bounds, f, self.maneuver.parameters)

    def rhs(self, t: np.ndarray, Y: np.ndarray, p: np.ndarray) -> np.ndarray:
        """Time derivative (6, K) of Y."""
        self.check()
        return np.stack(np.broadcast_arrays(*constrained_rhs(Y, self.motion(t, Y, p))))

    def rhs_jacobian(self, t: np.ndarray, Y: np.ndarray, p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Derivatives (6, 6, K) and (6, 6, K) of `rhs` with respect to Y and p."""
        f = self.maneuver.rig.thrust_bounds(self.maneuver.limits.u)
        motion = self.motion(t, Y, p)
        columns = np.concatenate(linearise(motion.x, motion.v, self.maneuver.parameters), axis=1).swapaxes(0, 1)
        dY, dp = np.zeros((6, 6, len(t))), np.zeros((6, len(p), len(t)))
        dY[[0, 2, 4], [1, 3, 5]] = 1.0
        zero = np.zeros(2)
        for k, unit in enumerate(np.eye(6)):
            dY[[1, 3, 5], k] = changes(unit, zero, Y, motion, columns, f)
        for rows, basis, unit in zip(np.split(np.arange(6), KAPPA[:1]), self.ansatz(t), np.eye(2)):
            by_phi = np.stack(np.broadcast_arrays(*changes(np.zeros(6), unit, Y, motion, columns, f)))
            dp[[[1], [3], [5]], rows] = by_phi[:, None] * basis
        return dY, dp

    def ends(self) -> np.ndarray:
        """Boundary values (2, 6) of Y, by (12), (35) and (36)."""
        xi1 = psi1_inverse(0.0, self.pitch_bounds)
        points = self.maneuver.start, self.maneuver.goal
        return np.array([[elevation, 0.0, xi1, 0.0, travel, 0.0] for travel, elevation in points])

    def solve(self, guess: Solution, tolerance: float = COARSE) -> Solution | None:
        """Solve (38) from a guess; None if the solver does not converge."""
        start, goal = self.ends()

        def boundary(Ya, Yb, p):
            return np.concatenate((Ya - start, Yb - goal))

        def boundary_jacobian(Ya, Yb, p):
            return np.eye(12, 6), np.eye(12, 6, k=-6), np.zeros((12, 6))

        return run_solver(self.rhs, boundary, guess, self.rhs_jacobian, boundary_jacobian, tolerance)

    def guess(self, unconstrained: Solution) -> Solution:
        """Unconstrained plan in the coordinates of (38), its pitch clipped to the limits (footnote 4)."""
        t, p = unconstrained.t, unconstrained.p
        (y1, dy1, _), (y2, dy2, _) = setup_functions(self.maneuver, t, p)
        low, high = self.pitch_bounds
        inside = np.clip(y2, CLOSEST_PITCH * low, CLOSEST_PITCH * high)
        xi1 = psi1_inverse(inside, self.pitch_bounds)
        xi2 = np.where(inside == y2, dy2, 0.0) / psi1(xi1, self.pitch_bounds).slope
        return Solution(t, np.stack((y1, dy1, xi1, xi2, *unconstrained.Y)), np.zeros(sum(KAPPA)))

    def trajectory(self, solution: Solution) -> Trajectory:
        """Convert a solution to states and voltages, by (25), (28), (13) and the inverses of (4) and (2)."""
        t = sample_times(self.maneuver)
        x, thrusts = np.empty((6, len(t))), np.empty((2, len(t)))
        f = self.maneuver.rig.thrust_bounds(self.maneuver.limits.u)
        Y = np.ascontiguousarray(solution.interpolate(t))
        sampling_kernel()(Y, solution.p, self.pitch_bounds, f, self.maneuver.parameters, x, thrusts)
        x[:, [0, -1]] = self.ends()[:, [4, 5, 0, 1, 3, 3]].T  # exact ends: xi2 = 0 gives q3 = dq3 = 0
        return Trajectory(t, x, self.maneuver.rig.voltage(thrusts), self.maneuver.limits, self.maneuver.rig)


def sample_times(maneuver: Maneuver) -> np.ndarray:
    """Sample times (K,) in s of a plan."""
    return np.linspace(0.0, maneuver.duration, 1 + min(int(np.ceil(maneuver.duration / SAMPLE_PERIOD)), MOST_SAMPLES))


def run_solver(rhs, boundary, guess: Solution, rhs_jacobian, boundary_jacobian, tolerance: float) -> Solution | None:
    """Run scipy's `solve_bvp`, related to the paper's bvp4c; None if it does not converge."""
    with np.errstate(all="ignore"):  # a diverging iteration overflows before it gives up
        try:
            result = solve_bvp(
                rhs,
                boundary,
                guess.t,
                guess.Y,
                guess.p,
                fun_jac=rhs_jacobian,
                bc_jac=boundary_jacobian,
                tol=tolerance,
                max_nodes=MAX_NODES[tolerance],
            )
        except ValueError:
            return None
    return Solution(result.x, result.y, result.p, result.sol) if result.success else None
