"""Equations (2)-(4) of the paper: thrust map, equations of motion, and their linearisation.

Arrays are components first: a state x is (6,) or (6, N), in the order (44)
(travel, elevation and pitch, each followed by its rate; rad and rad/s), voltages u and thrusts f are
(front, back), virtual inputs v are (sum, difference) of the thrusts.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from heli_gym.parameters import HelicopterParameters

TINY = 1e-30  # V, prevents 0 / 0 at 0 V; too small to change any voltage
STATE_NAMES = ("travel", "travel rate", "elevation", "elevation rate", "pitch", "pitch rate")


def thrust(u: Any, parameters: HelicopterParameters = HelicopterParameters()) -> Any:
    """Equation (2): thrusts f in N of fans at the voltages u in V, element by element.

    Its two cases are one expression in |u|, so that it accepts any type with an absolute value.
    """
    even, odd = parameters.k_plus + parameters.k_minus, parameters.k_plus - parameters.k_minus
    return 0.5 * (even * u + odd * abs(u)) * u


def voltage(f: ArrayLike, parameters: HelicopterParameters = HelicopterParameters()) -> Any:
    """The inverse of (2): voltages u in V at which the fans thrust f in N, element by element."""
    f = np.asarray(f, dtype=float)
    k = np.where(f >= 0.0, parameters.k_plus, parameters.k_minus)
    # without backward thrust, k_minus = 0, a negative thrust gets 0 V
    ratio = np.divide(f, k, out=np.zeros(np.broadcast(f, k).shape), where=k != 0.0)
    return np.sign(f) * np.sqrt(ratio)


def power_thrust(u: Any, k_plus: Any, k_minus: Any, exponent: Any, dead_zone: Any, power: Callable = pow) -> Any:
    """Thrust in N of a rotor at the voltage u in V: k_plus or k_minus (N/V^exponent) times (|u| - dead_zone)^exponent.

    Generalises (2): exponent 2 without a dead zone gives (2), exponent 1 a linear map. Free of branches, because the
    kernels vectorise it with their own `power`.
    """
    excess = abs(u) - dead_zone
    magnitude = power(0.5 * (excess + abs(excess)), exponent)
    direction = u / (abs(u) + TINY)
    return 0.5 * ((k_plus + k_minus) + (k_plus - k_minus) * direction) * magnitude


def virtual_input(f: Any) -> tuple:
    """Equation (4): sum and difference v = (v1, v2) of the thrusts f = (f_f, f_b), in N."""
    return f[0] + f[1], f[0] - f[1]


def fan_thrusts(v: Any) -> tuple:
    """The inverse of (4): thrusts f = (f_f, f_b) with the sum and difference v = (v1, v2), in N."""
    return 0.5 * (v[0] + v[1]), 0.5 * (v[0] - v[1])


def dynamics(x: Any, v: Any, parameters: HelicopterParameters, sin: Any = np.sin, cos: Any = np.cos) -> tuple:
    """Equation (3) with viscous friction: time derivative of the state x (6, ...) under the inputs v (2, ...) in N.

    Accepts any type with arithmetic: floats, arrays, complex numbers, CasADi expressions, torch tensors. `sin` and
    `cos` must accept the same type.
    """
    _, dq1, q2, dq2, q3, dq3 = x
    v1, v2 = v
    p = parameters
    ddq1 = p.b1 * cos(q2) * sin(q3) * v1 - p.c1 * dq1
    ddq2 = p.a1 * sin(q2) + p.a2 * cos(q2) + p.b2 * cos(q3) * v1 - p.c2 * dq2
    ddq3 = p.a3 * cos(q2) * sin(q3) + p.b3 * v2 - p.c3 * dq3
    return dq1, ddq1, dq2, ddq2, dq3, ddq3


def inverse_dynamics(
    x: Any, ddq2: Any, ddq3: Any, parameters: HelicopterParameters, sin: Any = np.sin, cos: Any = np.cos
) -> tuple:
    """Invert (3b) and (3c): inputs v (2, ...) in N for accelerations of elevation and pitch in rad/s², at states x.

    `dynamics` is affine in v, so three evaluations determine the inverse for any terms in it. Accepts the same types.
    """
    _, _, _, elevation, _, pitch = dynamics(x, (0.0, 0.0), parameters, sin, cos)
    _, _, _, elevation_1, _, pitch_1 = dynamics(x, (1.0, 0.0), parameters, sin, cos)
    _, _, _, elevation_2, _, pitch_2 = dynamics(x, (0.0, 1.0), parameters, sin, cos)
    return solve_2x2(
        elevation_1 - elevation,
        elevation_2 - elevation,
        pitch_1 - pitch,
        pitch_2 - pitch,
        ddq2 - elevation,
        ddq3 - pitch,
    )


def thrust_vector(
    x: Any, ddq1: Any, ddq2: Any, parameters: HelicopterParameters, sin: Any = np.sin, cos: Any = np.cos
) -> tuple:
    """Invert (3a) and (3b): components (v1 sin q3, v1 cos q3) in N of the thrust that accelerates travel and elevation.

    Accelerations in rad/s²; the pitch of x is ignored. Evaluates `dynamics` at pitch 0 and 90 degrees, whose thrust
    directions span the plane of all thrust vectors.
    """
    q1, dq1, q2, dq2, _, dq3 = x
    upright, tilted = (q1, dq1, q2, dq2, 0.0 * q2, dq3), (q1, dq1, q2, dq2, 0.0 * q2 + 0.5 * np.pi, dq3)
    _, travel, _, elevation, _, _ = dynamics(upright, (0.0, 0.0), parameters, sin, cos)
    _, travel_u, _, elevation_u, _, _ = dynamics(upright, (1.0, 0.0), parameters, sin, cos)
    _, travel_t, _, elevation_t, _, _ = dynamics(tilted, (1.0, 0.0), parameters, sin, cos)
    return solve_2x2(
        travel_t - travel,
        travel_u - travel,
        elevation_t - elevation,
        elevation_u - elevation,
        ddq1 - travel,
        ddq2 - elevation,
    )


def solve_2x2(a: Any, b: Any, c: Any, d: Any, y1: Any, y2: Any) -> tuple:
    """Solution (x1, x2) of a x1 + b x2 = y1 and c x1 + d x2 = y2."""
    determinant = a * d - b * c
    return (d * y1 - b * y2) / determinant, (a * y2 - c * y1) / determinant


def linearise(x: ArrayLike, v: ArrayLike, parameters: HelicopterParameters) -> tuple[np.ndarray, np.ndarray]:
    """Equations (47), (48): A (6, 6, ...) and B (6, 2, ...) of (3) about x (6, ...) and v (2, ...).

    Complex steps through `dynamics` are exact to rounding and follow every change of the model.
    """
    x, v = np.asarray(x, dtype=float), np.asarray(v, dtype=float)
    n, step = len(x), 1e-30
    z = np.concatenate((x, v)).astype(complex)
    columns = []
    for j in range(len(z)):
        z[j] += 1j * step
        derivative = dynamics(z[:n], z[n:], parameters)
        columns.append(np.stack(np.broadcast_arrays(*derivative)).imag / step)
        z[j] -= 1j * step
    jacobian = np.stack(columns, axis=1)
    return jacobian[:, :n], jacobian[:, n:]


def hover_input(elevation: ArrayLike, parameters: HelicopterParameters) -> np.ndarray:
    """Virtual input v (2, ...) in N that holds (3) at rest at an elevation in rad: (13) without motion."""
    q2 = np.asarray(elevation, dtype=float)
    zero = np.zeros_like(q2)
    return np.stack(inverse_dynamics((zero, zero, q2, zero, zero, zero), 0.0, 0.0, parameters))


def rk4_step(derivative: Callable, x: Any, inputs: tuple, dt: Any, *constants: Any) -> tuple:
    """State (6, ...) dt seconds after x under dx/dt = derivative(x, input, *constants).

    One Runge-Kutta step of order four; `inputs` are the inputs at its start, middle and end. For (3), a step of 20 ms
    is accurate to 1e-9.
    """
    start, middle, end = inputs
    d1 = derivative(x, start, *constants)
    d2 = derivative(axpy(x, dt / 2.0, d1), middle, *constants)
    d3 = derivative(axpy(x, dt / 2.0, d2), middle, *constants)
    d4 = derivative(axpy(x, dt, d3), end, *constants)
    x = axpy(axpy(x, dt / 6.0, d1), dt / 3.0, d2)
    return axpy(axpy(x, dt / 3.0, d3), dt / 6.0, d4)


def axpy(x: Any, h: Any, d: Any) -> tuple:
    """x + h d, component by component (6, ...)."""
    return x[0] + h * d[0], x[1] + h * d[1], x[2] + h * d[2], x[3] + h * d[3], x[4] + h * d[4], x[5] + h * d[5]
