"""The boundary value problem (38) by shooting, compiled: six end conditions, and the six parameters of (39), (40).

The right-hand side is that of `baselines.boundary_value`, compiled as it stands. The initial guess is the paper's too:
the unconstrained plan, by the parameters that reproduce it best.
"""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import root

from baselines.boundary_value import (
    BUMPS,
    KAPPA,
    ConstrainedProblem,
    Solution,
    constrained_motion,
    constrained_rhs,
    setup_functions,
)
from baselines.compilation import code_of, kept
from baselines.normal_form import internal_dynamics, thrust_bounds
from heli_gym.trajectory import Maneuver

SEARCH, FINE = 100, 2000  # Runge-Kutta steps of order four: to find the parameters, and to refine them
TOLERANCE = 1e-7  # relative, of the parameters
DIFFERENCE = 1e-6  # share of a parameter, or of 1, by which the end is differentiated
CLOSE = 1e-5  # rad and rad/s, from the goal
STRETCHES = (1.0, 1.1, 1.21)  # of the duration, from which the search may start
FARTHEST, NEAREST = 0.1, 0.01  # relative steps in which durations are shortened: the first, and when to give up
QUADRATURE = np.polynomial.legendre.leggauss(40)
NEWTON_STEPS = 20
GUESS_POINTS = 50  # as in Section III-B


@cache
def shooting_kernel() -> Callable:
    """The compiled `shoot`; compiled at its first call, and kept on disk for as long as the equations stay the same.

    It fills in the states (6, N + 1) and their derivatives, from the start Y[:, 0] on, for parameters p (6,) of (39).
    """
    version = code_of(derivative, ahead)

    def shoot(p, duration, pitch_bounds, f, parameters, Y, dY):
        version  # noqa: B018
        steps = Y.shape[1] - 1
        h, each = duration / steps, 1.0 / steps
        now = (Y[0, 0], Y[1, 0], Y[2, 0], Y[3, 0], Y[4, 0], Y[5, 0])
        for n in range(steps + 1):
            tau = n * each
            d1 = derivative(tau, now, p, pitch_bounds, f, parameters)
            for i in range(6):
                Y[i, n], dY[i, n] = now[i], d1[i]
            if n < steps:
                middle = tau + 0.5 * each
                d2 = derivative(middle, ahead(now, 0.5 * h, d1), p, pitch_bounds, f, parameters)
                d3 = derivative(middle, ahead(now, 0.5 * h, d2), p, pitch_bounds, f, parameters)
                d4 = derivative(tau + each, ahead(now, h, d3), p, pitch_bounds, f, parameters)
                now = ahead(ahead(ahead(ahead(now, h / 6.0, d1), h / 3.0, d2), h / 3.0, d3), h / 6.0, d4)

    return kept(shoot)


def derivative(tau, Y, p, pitch_bounds, f, parameters):
    """The time derivative of the states Y (6,) of (38) at a share tau of the duration, under (39)."""
    phi1, phi2 = 0.0, 0.0
    power = tau
    for k in range(KAPPA[0]):
        power *= tau
        phi1 += p[k] * (power - tau)
    power = tau
    for k in range(KAPPA[1]):
        power *= tau
        phi2 += p[KAPPA[0] + k] * (power - tau)
    motion = constrained_motion(Y, (phi1, phi2), pitch_bounds, f, parameters)
    return constrained_rhs(Y, motion, parameters)


def ahead(Y, h, d):
    """The states Y (6,) a time h later, at rates d."""
    return Y[0] + h * d[0], Y[1] + h * d[1], Y[2] + h * d[2], Y[3] + h * d[3], Y[4] + h * d[4], Y[5] + h * d[5]


def unconstrained_parameters(maneuver: Maneuver) -> np.ndarray | None:
    """The parameters (2,) that solve (14), by Gauss' quadrature and Newton's method; None if there are none.

    The travel starts and ends at rest, and what it covers is the integral of the time that is left times ddeta.
    """
    share, weights = 0.5 * (QUADRATURE[0] + 1.0), 0.5 * QUADRATURE[1]
    T, p = maneuver.duration, np.zeros(2)
    bumps = np.stack([bump(share) for bump in BUMPS])
    weights = np.stack((weights, weights * (1.0 - share))) * T**2
    (y1, _, ddy1), _ = setup_functions(maneuver, T * share, p)
    slope = internal_dynamics(y1, math.pi / 4.0, ddy1, maneuver.parameters)  # ddeta is this times tan(y2)
    for _ in range(NEWTON_STEPS):
        y2 = p @ bumps
        if np.abs(y2).max() >= 0.5 * math.pi:
            return None
        missed = weights @ (slope * np.tan(y2)) - [0.0, maneuver.goal[0] - maneuver.start[0]]
        if np.abs(missed).max() < 1e-9:
            return p
        p = p - np.linalg.solve((weights * slope / np.cos(y2) ** 2) @ bumps.T, missed)
    return None


def parameters_of(problem: ConstrainedProblem, p: np.ndarray) -> np.ndarray:
    """The parameters (6,) of (39) that, unsaturated, come closest to the paper's initial guess, and to its end most.

    The guess is the unconstrained plan with parameters p (2,), its pitch clipped; what is fitted is y1 and xi1.
    """
    T = problem.maneuver.duration
    tau = np.linspace(0.0, 1.0, GUESS_POINTS)
    y1, _, xi1, *_ = problem.guess(Solution(T * tau, np.zeros((2, len(tau))), p)).Y
    fitted = []
    for kappa, y in zip(KAPPA, (y1, xi1)):
        k = np.arange(1, kappa + 1)[:, None]
        positions = tau ** (k + 3) / ((k + 2) * (k + 3)) - tau**3 / 6.0  # (39), integrated twice
        rates = 1.0 / (k + 2) - 0.5
        A = np.concatenate((positions, len(tau) * positions[:, -1:], len(tau) * rates), axis=1)
        target = np.concatenate((y - y[0], len(tau) * (y[-1:] - y[0]), [0.0]))
        fitted.append(np.linalg.lstsq(A.T, target)[0] / T**2)
    return np.concatenate(fitted)


def unchecked() -> None:
    """Nothing that would end a search."""


def solve_by_shooting(
    maneuver: Maneuver, p: np.ndarray | None = None, check: Callable[[], None] = unchecked
) -> Solution | None:
    """A solution of (38), from parameters p (6,) close to it, or else from the paper's initial guess.

    Where the guess leads to none, that for a longer duration may, and its solution, shortened step by step, to the one
    asked for. None if there is no such way. `check` may end the search by what it raises.
    """
    if p is None:
        p = shortened(maneuver, *first_parameters(maneuver, check), check)
        if p is None:
            return None
    end = End(maneuver, FINE, check)
    if not end.is_met_from(p, End(maneuver, SEARCH, check).jacobian):
        return None
    t = np.linspace(0.0, maneuver.duration, FINE + 1)
    return Solution(t, end.Y, end.p, CubicHermiteSpline(t, end.Y, end.dY, axis=1))


def first_parameters(maneuver: Maneuver, check: Callable[[], None]) -> tuple[float, np.ndarray | None]:
    """The shortest of some durations from the maneuver's on for which the paper's guess leads anywhere, and where."""
    for stretch in STRETCHES:
        longer = replace(maneuver, duration=stretch * maneuver.duration)
        unconstrained = unconstrained_parameters(longer)
        if unconstrained is not None:
            end = End(longer, SEARCH, check)
            if end.is_met_from(parameters_of(ConstrainedProblem(longer), unconstrained)):
                return longer.duration, end.p
    return math.inf, None


def shortened(
    maneuver: Maneuver, duration: float, p: np.ndarray | None, check: Callable[[], None]
) -> np.ndarray | None:
    """The parameters for the maneuver's duration, from those for a longer one, in steps that halve when one fails."""
    step = FARTHEST
    while p is not None and duration > maneuver.duration:
        shorter = max((1.0 - step) * duration, maneuver.duration)
        end = End(replace(maneuver, duration=shorter), SEARCH, check)
        if end.is_met_from((duration / shorter) ** 2 * p):  # accelerations scale with 1/T²
            duration, p = shorter, end.p
        else:
            step *= 0.5
            p = p if step > NEAREST else None
    return p


class End:
    """Where parameters (6,) of (39) lead to: called, gives the distance (6,) of the end from the goal."""

    def __init__(self, maneuver: Maneuver, steps: int, check: Callable[[], None] = unchecked) -> None:
        self.check = check
        problem = ConstrainedProblem(maneuver)
        start, self.goal = problem.ends()
        self.p = np.zeros(sum(KAPPA))
        self.Y, self.dY = np.empty((6, steps + 1)), np.empty((6, steps + 1))
        self.Y[:, 0] = start
        f = thrust_bounds(maneuver.limits, maneuver.parameters)
        self.arguments = float(maneuver.duration), problem.pitch_bounds, f, maneuver.parameters
        self.shoot = shooting_kernel()

    def __call__(self, p: np.ndarray) -> np.ndarray:
        self.check()
        self.p = p
        self.shoot(p, *self.arguments, self.Y, self.dY)
        return self.Y[:, -1] - self.goal

    def jacobian(self, p: np.ndarray) -> np.ndarray:
        """The derivatives (6, 6) of the end by the parameters."""
        steps = np.diag(DIFFERENCE * np.maximum(1.0, np.abs(p)))
        return np.stack([(self(p + step) - self(p - step)) / (2.0 * step.sum()) for step in steps], axis=1)

    def is_met_from(self, p: np.ndarray, jacobian: Callable[[np.ndarray], np.ndarray] | None = None) -> bool:
        """Whether Powell's hybrid method finds parameters that lead to the goal from these; keeps them, and the way.

        It differentiates by itself, unless another's Jacobian is close enough.
        """
        with np.errstate(all="ignore"):  # a diverging iteration overflows before it gives up
            found = root(self, p, jac=jacobian, tol=TOLERANCE)
        return bool(found.success and np.abs(self(found.x)).max() < CLOSE)
