"""Independent references for the tests: the paper's equations typed again, and solvers outside the package."""

import functools
import math
from types import SimpleNamespace

import casadi as ca
import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp

from heli_gym import Maneuver, Trajectory, dynamics
from heli_gym.env import find_reference

TABLE_I = SimpleNamespace(
    k_plus=4.855e-3, k_minus=-1.503e-3, a1=-1.1713, a2=0.3946, a3=-0.5326, b1=-0.6354, b2=-0.6523, b3=4.6276
)


def equation_2(u, p=TABLE_I):
    """Thrust in N of one fan at the voltage u in V."""
    return p.k_plus * u**2 if u >= 0 else p.k_minus * u**2


def equation_3(x, v1, v2, p=TABLE_I, lib=np):
    """Time derivative of the state (44), with viscous friction where p has any."""
    c1, c2, c3 = (getattr(p, name, 0.0) for name in ("c1", "c2", "c3"))
    _q1, dq1, q2, dq2, q3, dq3 = x
    return [
        dq1,
        p.b1 * lib.cos(q2) * lib.sin(q3) * v1 - c1 * dq1,
        dq2,
        p.a1 * lib.sin(q2) + p.a2 * lib.cos(q2) + p.b2 * lib.cos(q3) * v1 - c2 * dq2,
        dq3,
        p.a3 * lib.cos(q2) * lib.sin(q3) + p.b3 * v2 - c3 * dq3,
    ]


def inputs(u, p=TABLE_I) -> np.ndarray:
    """Virtual inputs v (2, ...) in N at the voltages u (2, ...), by (2) and (4)."""
    f_f, f_b = np.vectorize(equation_2)(u, p)
    return np.stack((f_f + f_b, f_f - f_b))


def replay(trajectory: Trajectory, p=TABLE_I) -> np.ndarray:
    """States (6, K) at the trajectory's times of a flight from its start through (3) under its voltages, by DOP853."""
    times, voltages = trajectory.t.copy(), trajectory.u.copy()  # read-only, np.interp would copy them at every call

    def rhs(t, x):
        f_f, f_b = (equation_2(float(np.interp(t, times, u)), p) for u in voltages)
        return equation_3(x.tolist(), f_f + f_b, f_f - f_b, p, math)

    flight = solve_ivp(rhs, (0.0, times[-1]), trajectory.x[:, 0], "DOP853", times, rtol=1e-8, atol=1e-10, max_step=0.02)
    assert flight.success
    return flight.y


@functools.cache
def _symbolic_jacobians():
    x, v = sp.symbols("q1 dq1 q2 dq2 q3 dq3"), sp.symbols("v1 v2")
    f = sp.Matrix(equation_3(x, *v, lib=sp))
    return [sp.lambdify((*x, *v), f.jacobian(z), "numpy") for z in (x, v)]


def jacobians(x, v) -> tuple[np.ndarray, np.ndarray]:
    """Equations (47) and (48), derived symbolically from (3): A (6, 6) and B (6, 2)."""
    A, B = _symbolic_jacobians()
    return A(*x, *v), B(*x, *v)


def central_differences(function, z: np.ndarray, step: float = 1e-6) -> np.ndarray:
    """Derivatives of a function of z (n,), one column per component of z."""
    columns = [function(z + step * e) - function(z - step * e) for e in np.eye(len(z))]
    return np.stack(columns, axis=1) / (2.0 * step)


def hover(duration: float, elevation: float = 0.0) -> Trajectory:
    """Rest at an elevation in rad, where (3b) vanishes."""
    p = TABLE_I
    v1 = -(p.a1 * math.sin(elevation) + p.a2 * math.cos(elevation)) / p.b2
    x = np.zeros((6, 2))
    x[2] = elevation
    return Trajectory(np.array([0.0, duration]), x, np.full((2, 2), math.sqrt(0.5 * v1 / p.k_plus)))


def shortest_time(maneuver: Maneuver, guess: Trajectory, intervals: int = 50) -> float:
    """The least transition time in s that any thrusts within the limits reach, by direct collocation.

    Hermite-Simpson with the states at the midpoints as variables, IPOPT, and `heli_gym.dynamics` unchanged.
    """
    limits, n = maneuver.limits, 2 * intervals + 1
    x, f = ca.SX.sym("x", 6), ca.SX.sym("f", 2)
    derivative = dynamics(ca.vertsplit(x), (f[0] + f[1], f[0] - f[1]), maneuver.parameters, ca.sin, ca.cos)
    problem = ca.Opti()
    T, X, F = problem.variable(), problem.variable(6, n), problem.variable(2, n)
    dX, h = ca.Function("f", [x, f], [ca.vertcat(*derivative)]).map(n)(X, F), T / intervals
    left, middle, right = slice(0, n - 2, 2), slice(1, n - 1, 2), slice(2, n, 2)
    problem.minimize(T)
    problem.subject_to(X[:, right] == X[:, left] + h / 6 * (dX[:, left] + 4 * dX[:, middle] + dX[:, right]))
    problem.subject_to(X[:, middle] == (X[:, left] + X[:, right]) / 2 + h / 8 * (dX[:, left] - dX[:, right]))
    for k, (travel, elevation) in ((0, maneuver.start), (n - 1, maneuver.goal)):
        problem.subject_to(X[:, k] == [travel, 0.0, elevation, 0.0, 0.0, 0.0])
    problem.subject_to(problem.bounded(equation_2(limits.u_min), ca.vec(F), equation_2(limits.u_max)))
    problem.subject_to(problem.bounded(limits.pitch_min, X[4, :].T, limits.pitch_max))
    problem.subject_to(T >= 0.1)
    x_guess, u_guess = guess(np.linspace(0.0, guess.duration, n))
    problem.set_initial(T, guess.duration)
    problem.set_initial(X, x_guess)
    problem.set_initial(F, np.vectorize(equation_2)(u_guess))
    problem.solver("ipopt", {"print_time": False}, {"print_level": 0, "sb": "yes", "max_iter": 500})
    return float(problem.solve().value(T))


class EitherReference:
    """A sampler: one of two packaged references, of 5 and 7 s."""

    duration = 7.0

    def __call__(self, rng):
        return find_reference(["climb-7.5", "back-60-descend"][rng.integers(2)])
