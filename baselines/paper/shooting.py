"""Boundary value problem (38) by multiple shooting: Newton's method on the six parameters of (39), (40).

The initial guess is the paper's: states at the segment ends from the unconstrained plan with its pitch clipped, and
zero parameters. Flights and their derivatives are compiled from the equations in `boundary_value`.
"""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache, partial
from typing import NamedTuple

import numpy as np
from numpy.polynomial.polynomial import polyval

from heli_gym.baselines.paper.boundary_value import (
    CLOSEST_PITCH,
    COEFFICIENTS,
    KAPPA,
    ConstrainedProblem,
    Solution,
    changes,
    constrained_motion,
    constrained_rhs,
    new_inputs,
    setup_functions,
)
from heli_gym.baselines.paper.jacobian import STEP, dual_cos, dual_sin, jacobian
from heli_gym.baselines.paper.normal_form import arrival_weights, internal_dynamics, travel_damping
from heli_gym.baselines.paper.saturation import psi1, psi1_inverse
from heli_gym.compilation import jit_cached
from heli_gym.model import axpy, dynamics, virtual_input
from heli_gym.trajectory import Maneuver, Trajectory

SEGMENTS = 10
SEARCH, FINE = 10, 70  # Runge-Kutta steps of order four per segment, for search and for refinement
CLOSE = {SEARCH: 1e-3, FINE: 1e-6}  # rad and rad/s, largest defects between the segments and at the goal
ITERATIONS = 25  # of Newton's method
LEAST_STEP = 0.5  # smallest share of a Newton step; smaller ones lead to solutions with oscillating elevation
STRETCHES = (1.0, 1.1, 1.21, 1.33, 1.5)  # factors on the duration at which the search starts
FARTHEST, NEAREST = 0.1, 0.01  # relative steps of shortening a duration: first and smallest
NEWTON_STEPS = 20  # for the two parameters of the unconstrained plan
FREE = 1e-3  # distance to the limits, as a share of their range, of voltages used to fit the parameters of (39)


@cache
def shooting_kernel() -> Callable:
    """Compile `shoot` at its first call, cached on disk until the equations change.

    `shoot` starts from the states Y (6, N + 1) at the segment starts, `steps` Runge-Kutta steps apart, and fills in the
    states between them and all derivatives dY (6, N + 1). For each segment it fills in the defect (6,) at the start of
    the next segment or at the goal, and the sensitivity (6, 7) of the state there: six columns of derivatives by the
    parameters p (6,) of (39), and one of the accumulated defects, to first order as if the segments were joined.
    """

    def shoot(Y, p, goal, steps, duration, pitch_bounds, f, parameters, dY, defects, sensitivity):
        last = Y.shape[1] - 1
        h, each = duration / last, 1.0 / last
        V, W = np.zeros((6, 7)), np.zeros((6, 7))
        k1, k2, k3, k4 = np.zeros((6, 7)), np.zeros((6, 7)), np.zeros((6, 7)), np.zeros((6, 7))
        now = (Y[0, 0], Y[1, 0], Y[2, 0], Y[3, 0], Y[4, 0], Y[5, 0])
        for n in range(last + 1):
            tau = n * each
            d1 = variational_equation(tau, now, V, p, pitch_bounds, f, parameters, k1)
            for i in range(6):
                Y[i, n], dY[i, n] = now[i], d1[i]
            if n == last:
                break
            middle = tau + 0.5 * each
            add_scaled(V, 0.5 * h, k1, W)
            d2 = variational_equation(middle, axpy(now, 0.5 * h, d1), W, p, pitch_bounds, f, parameters, k2)
            add_scaled(V, 0.5 * h, k2, W)
            d3 = variational_equation(middle, axpy(now, 0.5 * h, d2), W, p, pitch_bounds, f, parameters, k3)
            add_scaled(V, h, k3, W)
            d4 = variational_equation(tau + each, axpy(now, h, d3), W, p, pitch_bounds, f, parameters, k4)
            now = axpy(axpy(axpy(axpy(now, h / 6.0, d1), h / 3.0, d2), h / 3.0, d3), h / 6.0, d4)
            for i in range(6):
                for j in range(7):
                    V[i, j] += h / 6.0 * (k1[i, j] + 2.0 * (k2[i, j] + k3[i, j]) + k4[i, j])
            if (n + 1) % steps == 0:
                segment = n // steps
                for i in range(6):
                    defects[segment, i] = now[i] - (goal[i] if n + 1 == last else Y[i, n + 1])
                    V[i, 6] += defects[segment, i]
                    for j in range(7):
                        sensitivity[segment, i, j] = V[i, j]
                if n + 1 < last:
                    m = n + 1
                    now = (Y[0, m], Y[1, m], Y[2, m], Y[3, m], Y[4, m], Y[5, m])

    return jit_cached(shoot, fast=True)


def variational_equation(tau, Y, V, p, pitch_bounds, f, parameters, dV):
    """Time derivative of the states Y (6,) of (38) at a share tau of the duration, under (39).

    Fills in the derivative dV of V (6, 7), first-order changes of the states; the first six are by the parameters.
    """
    motion = constrained_motion(Y, new_inputs(tau, p), pitch_bounds, f, parameters)
    columns = jacobian(motion.x, motion.v, parameters)
    for j in range(7):
        phi1, phi2, power = 0.0, 0.0, tau
        for k in range(max(KAPPA)):  # (39), by its j-th parameter
            power *= tau
            if j == k and k < KAPPA[0]:
                phi1 = power - tau
            if j == KAPPA[0] + k:
                phi2 = power - tau
        dY = V[0, j], V[1, j], V[2, j], V[3, j], V[4, j], V[5, j]
        dV[1, j], dV[3, j], dV[5, j] = changes(dY, (phi1, phi2), Y, motion, columns, f)
        dV[0, j], dV[2, j], dV[4, j] = V[1, j], V[3, j], V[5, j]
    return constrained_rhs(Y, motion)


def add_scaled(V, h, dV, W):
    """Fill in W = V + h dV, all (6, 7)."""
    for i in range(6):
        for j in range(7):
            W[i, j] = V[i, j] + h * dV[i, j]


@cache
def interpolation_kernel() -> Callable:
    """Compile cubic Hermite interpolation (6, K) at times t (K,) of Y (6, N + 1) and dY, sampled every h."""

    def interpolate(Y, dY, h, t):
        values = np.empty((len(Y), len(t)))
        for k in range(len(t)):
            n = min(max(int(t[k] / h), 0), Y.shape[1] - 2)
            s = t[k] / h - n
            for i in range(len(Y)):
                rise, start, end = Y[i, n + 1] - Y[i, n], h * dY[i, n], h * dY[i, n + 1]
                bend = 3.0 * rise - 2.0 * start - end + s * (start + end - 2.0 * rise)
                values[i, k] = Y[i, n] + s * (start + s * bend)
        return values

    return jit_cached(interpolate, fast=True)


class Shot(NamedTuple):
    """Flight in segments under parameters p (6,) of (39), with defects between the segments."""

    Y: np.ndarray  # (6, N + 1) states
    dY: np.ndarray  # (6, N + 1) their derivatives
    p: np.ndarray
    defects: np.ndarray  # (S, 6)
    sensitivity: np.ndarray  # (S, 6, 7), see `shooting_kernel`

    @property
    def nodes(self) -> np.ndarray:
        """States (6, S + 1) at the ends of the segments."""
        return self.Y[:, :: self.Y.shape[1] // len(self.defects)]


def shooter(problem: ConstrainedProblem, steps: int) -> Callable[[np.ndarray, np.ndarray], Shot]:
    """Function that integrates a Shot from states (6, S + 1) at the segment ends and parameters (6,).

    Each segment has `steps` steps. The problem's start replaces the first state; no segment starts at the last one.
    """
    maneuver, kernel = problem.maneuver, shooting_kernel()
    start, goal = problem.ends()
    f = maneuver.rig.thrust_bounds(maneuver.limits.u)
    arguments = goal, steps, float(maneuver.duration), problem.pitch_bounds, f, maneuver.parameters

    def shoot(nodes: np.ndarray, p: np.ndarray) -> Shot:
        problem.check()
        segments = nodes.shape[1] - 1
        Y = np.empty((6, segments * steps + 1))
        new = Shot(Y, np.empty_like(Y), p, np.empty((segments, 6)), np.empty((segments, 6, 7)))
        Y[:, ::steps] = nodes
        Y[:, 0] = start
        kernel(Y, p, *arguments, new.dY, new.defects, new.sensitivity)
        return new

    return shoot


def solve_newton(problem: ConstrainedProblem, nodes: np.ndarray, p: np.ndarray, steps: int = SEARCH) -> Shot | None:
    """Solve for a flight with zero defects by damped Newton steps from a guess; None if they do not converge."""
    shoot = shooter(problem, steps)
    with np.errstate(all="ignore"):  # a diverging iteration overflows before it gives up
        now = shoot(nodes, p)
        for _ in range(ITERATIONS):
            if np.abs(now.defects).max() < CLOSE[steps]:
                return now
            new = newton_step(now, shoot)
            if new is None:
                return None
            now = new
    return None


def newton_step(now: Shot, shoot: Callable[[np.ndarray, np.ndarray], Shot]) -> Shot | None:
    """Next iterate by a full or damped Newton step that reduces the defects enough; None if none does."""
    by_p, by_missed = now.sensitivity[:, :, :6], now.sensitivity[:, :, 6]
    try:
        dp = -np.linalg.solve(by_p[-1], by_missed[-1])
    except np.linalg.LinAlgError:
        return None
    change = np.zeros((6, len(now.defects) + 1))
    change[:, 1:] = (by_p @ dp + by_missed).T
    defects, share = (now.defects**2).sum(), 1.0
    while share >= LEAST_STEP:
        new = shoot(now.nodes + share * change, now.p + share * dp)
        if (new.defects**2).sum() <= (1.0 - 0.5 * share) * defects:
            return new
        share *= 0.5
    return None


@cache
def travel_kernel() -> Callable:
    """Compile a function that fills in the travel's second derivative (K,) of (14a) and its derivatives by parameters.

    Arguments: elevation and its two derivatives, (K,) each; pitch with two derivatives, (3, K); and the derivatives of
    the latter by the two parameters, (2, 3, K). The derivatives by the parameters are (2, K).
    """

    def accelerate(y1, dy1, ddy1, pitch, shares, parameters, ddeta, by_p):
        for k in range(len(ddeta)):
            for j in range(2):
                y2 = complex(pitch[0, k], STEP * shares[j, 0, k])
                dy2 = complex(pitch[1, k], STEP * shares[j, 1, k])
                x = 0.0, 0.0, complex(y1[k], 0.0), dy1[k], y2, dy2
                value = internal_dynamics(x, ddy1[k], parameters, dual_sin, dual_cos)
                ddeta[k], by_p[j, k] = value.real, value.imag / STEP

    return jit_cached(accelerate, fast=True)


def unconstrained_guess(maneuver: Maneuver) -> Solution | None:
    """Solve (14) at the segment ends by the trapezoidal rule and Newton's method; None without a solution.

    The travel starts and ends at rest. Without damping, its change is the integral of ddeta times the remaining time;
    with damping, `arrival_weights` replace that factor.
    """
    T, p, parameters = maneuver.duration, np.zeros(2), maneuver.parameters
    share = np.linspace(0.0, 1.0, SEGMENTS * SEARCH + 1)
    bumps = polyval(share, COEFFICIENTS[:, 1:]) / T ** np.arange(3)[:, None]
    h, damping = T / (len(share) - 1), travel_damping(parameters)
    weights = h * np.stack(arrival_weights(T * (1.0 - share), damping))  # at both ends, the pitch is zero
    ddeta, by_p = np.empty_like(share), np.empty((2, len(share)))
    for _ in range(NEWTON_STEPS):
        (y1, dy1, ddy1), outputs = setup_functions(maneuver, T * share, p)
        if np.abs(outputs[0]).max() >= 0.5 * math.pi:
            return None
        travel_kernel()(y1, dy1, ddy1, outputs, bumps, parameters, ddeta, by_p)
        defects = weights @ ddeta - [0.0, maneuver.goal[0] - maneuver.start[0]]
        if np.abs(defects).max() < 1e-9:
            decay = np.exp(damping * T * share)
            deta = cumulative_integral(decay * ddeta, h) / decay
            eta = maneuver.start[0] + cumulative_integral(deta, h)
            return Solution(T * share[::SEARCH], np.stack((eta, deta))[:, ::SEARCH], p)
        p = p - np.linalg.solve(weights @ by_p.T, defects)
    return None


def cumulative_integral(rate: np.ndarray, h: float) -> np.ndarray:
    """Integral (K,) of a rate (K,) sampled every h, by the trapezoidal rule."""
    rise = np.zeros(len(rate))
    np.cumsum(0.5 * h * (rate[:-1] + rate[1:]), out=rise[1:])
    return rise


def guess_from(problem: ConstrainedProblem, near: Trajectory) -> tuple[np.ndarray, np.ndarray]:
    """States (6, S + 1) of a plan at the segment ends, scaled to the problem's duration, and parameters (6,).

    The parameters are fitted where the voltages are off their limits, since only there (39) acts unsaturated.
    """
    share, ratio = np.linspace(0.0, 1.0, SEGMENTS * SEARCH + 1), near.duration / problem.maneuver.duration
    x, u = near(near.duration * share)
    p, bounds = problem.maneuver.parameters, problem.pitch_bounds
    low, high = CLOSEST_PITCH * bounds[0], CLOSEST_PITCH * bounds[1]
    eta, deta, y1, dy1, y2, dy2 = x * np.array([1.0, ratio] * 3)[:, None]
    xi1 = psi1_inverse(np.clip(y2, low, high), bounds)
    pitch = psi1(xi1, bounds)
    xi2 = dy2 / pitch.slope
    _, _, _, ddy1, _, ddy2 = dynamics(x, virtual_input(near.rig.thrust(u)), p)
    ddy1, ddy2 = ratio**2 * ddy1, ratio**2 * ddy2
    margin = FREE * (near.limits.u_max - near.limits.u_min)
    is_free = ((u > near.limits.u_min + margin) & (u < near.limits.u_max - margin)).all(axis=0)
    is_free &= (low < y2) & (y2 < high)
    accelerations = ddy1, (ddy2 - pitch.curvature * xi2**2) / pitch.slope
    fitted = [
        np.linalg.lstsq(basis[:, is_free].T, acceleration[is_free])[0]
        for basis, acceleration in zip(problem.ansatz(problem.maneuver.duration * share), accelerations)
    ]
    return np.stack((y1, dy1, xi1, xi2, eta, deta))[:, ::SEARCH], np.concatenate(fitted)


def no_check() -> None:
    """Do nothing: the default check, which never ends a search."""


def solve_by_shooting(maneuver: Maneuver, check: Callable[[], None] = no_check) -> Solution | None:
    """Solve (38) from the paper's initial guess; None if no solution is found.

    If the guess fails, the search starts from a solution for a longer duration and shortens it step by step to the
    requested one. An exception from `check` ends the search.
    """
    duration, found = solve_longer(maneuver, check)
    step = FARTHEST
    while found is not None and duration > maneuver.duration:
        shorter = max((1.0 - step) * duration, maneuver.duration)
        ratio = duration / shorter
        rates = np.array([1.0, ratio] * 3)[:, None]
        problem = ConstrainedProblem(replace(maneuver, duration=shorter), check)
        nearer = solve_newton(problem, rates * found.nodes, ratio**2 * found.p)
        if nearer is not None:
            duration, found = shorter, nearer
        else:
            step *= 0.5
            found = found if step > NEAREST else None
    return found and refine(ConstrainedProblem(maneuver, check), found)


def solve_near(maneuver: Maneuver, near: Trajectory, check: Callable[[], None] = no_check) -> Solution | None:
    """Solve (38) with a plan of a similar maneuver as the initial guess; None if that fails."""
    problem = ConstrainedProblem(maneuver, check)
    found = solve_newton(problem, *guess_from(problem, near))
    return found and refine(problem, found)


def solve_longer(maneuver: Maneuver, check: Callable[[], None]) -> tuple[float, Shot | None]:
    """First of the durations STRETCHES times the maneuver's for which the paper's guess converges, and its solution."""
    for stretch in STRETCHES:
        longer = replace(maneuver, duration=stretch * maneuver.duration)
        unconstrained = unconstrained_guess(longer)
        if unconstrained is not None:
            problem = ConstrainedProblem(longer, check)
            guess = problem.guess(unconstrained)
            found = solve_newton(problem, guess.Y, guess.p)
            if found is not None:
                return longer.duration, found
    return math.inf, None


def refine(problem: ConstrainedProblem, found: Shot) -> Solution | None:
    """Refine a solution with FINE steps per segment; None if that fails."""
    fine = solve_newton(problem, found.nodes, found.p, FINE)
    if fine is None:
        return None
    t = np.linspace(0.0, problem.maneuver.duration, fine.Y.shape[1])
    return Solution(t, fine.Y, fine.p, partial(interpolation_kernel(), fine.Y, fine.dY, t[1]))
