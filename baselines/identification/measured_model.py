"""Compiled model of real rigs: equation (3) with further effects, as a function of one parameter vector.

All kernels compute with dual numbers (complex numbers with infinitesimal imaginary parts), so that each computes values
and exact derivatives by parameters, initial state and offsets.
"""

import math
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.paper.jacobian import STEP, dual_cos, dual_sin
from heli_gym.compilation import jit_cached
from heli_gym.model import dynamics, rk4_step
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import with_coupling


class MeasuredParameters(NamedTuple):
    """Parameters of the motion of a real rig; the first nine are the coefficients of (3).

    The defaults are near the middle of identified rigs and are the start of the search.
    """

    a1: Any = -1.2  # rad/s²
    a2: Any = 0.8  # rad/s²
    a3: Any = -0.5  # rad/s²
    b1: Any = -0.4  # rad/s² per unit of thrust; the unit is one rotor's thrust in hover
    b2: Any = -0.4  # likewise, on elevation
    b3: Any = 2.5  # likewise, on pitch
    c1: Any = 0.1  # 1/s
    c2: Any = 0.2  # 1/s
    c3: Any = 0.2  # 1/s
    exponent: Any = 1.9  # of the thrust in the rotor's voltage
    reverse: Any = 0.3  # ratio of backward to forward thrust
    mismatch: Any = 0.0  # share by which the front rotor is stronger and the back rotor weaker
    lag: Any = 0.1  # s
    delay: Any = 0.02  # s
    pitch_zero: Any = 0.0  # rad, measured pitch at which the thrusts do not accelerate travel
    pitch_trim: Any = 0.0  # rad/s², on pitch
    voltage_limit: Any = 1000.0  # V, of the amplifier, on both sides
    centrifugal: Any = 1.0  # factor of the arm's centrifugal moment on elevation and its Coriolis moment on travel
    centre: Any = 0.0  # rad, elevation at which the centrifugal moment vanishes
    pitch_spin: Any = 1.0  # factor of the body's centrifugal moment on pitch
    gyro: Any = 0.0  # 1/s, gyroscopic moment of the rotors on pitch, by the rates of elevation and travel
    pitch_speed: Any = 0.0  # 1/rad, pitch acceleration per signed square of the travel rate


NAMES = MeasuredParameters._fields


def measured_dynamics(x: Any, f: Any, p: Any, offsets: Any) -> tuple:
    """Time derivative of the state x (6,) under the thrusts f (front, back) and accelerations `offsets` (3,) in rad/s².

    Added to (3) are the moments of `heli_gym.plant.with_coupling` and the pitch trim.
    """
    q1, dq1, q2, dq2, q3, dq3 = x
    tilt = q3 - p.pitch_zero
    table = HelicopterParameters(0.0, 0.0, p.a1, p.a2, p.a3, p.b1, p.b2, p.b3, p.c1, p.c2, p.c3)
    state = (q1, dq1, q2, dq2, tilt, dq3)
    dx = dynamics(state, (f[0] + f[1], f[0] - f[1]), table, dual_sin, dual_cos)
    speed = dq1 if dq1.real > 0 else -dq1
    coupling = p.centrifugal, p.centre, p.pitch_spin, p.gyro, p.pitch_speed
    _, ddq1, _, ddq2, _, ddq3 = with_coupling(state, dx, speed, table, coupling, dual_sin, dual_cos)
    return dq1, ddq1 + offsets[0], dq2, ddq2 + offsets[1], dq3, ddq3 + p.pitch_trim + offsets[2]


def dual_power(w: Any, exponent: Any) -> Any:
    """|w|^exponent for dual numbers."""
    size = max(abs(w.real), 1e-9)
    value = math.exp(exponent.real * math.log(size))
    slope = exponent.real * value / size * (w.imag if w.real > 0 else -w.imag) + math.log(size) * value * exponent.imag
    return complex(value, slope)


def clip(u: float, limit: Any) -> Any:
    """Clip the voltage to the amplifier's limits."""
    return limit if u > limit.real else -limit if u < -limit.real else u + 0j


def rotor_thrust(w: Any, p: Any, voltage: float) -> Any:
    """Thrust of a rotor at the lagged voltage w, relative to its thrust at `voltage`."""
    f = dual_power(w / voltage, p.exponent)
    return f if w.real > 0 else -p.reverse * f


def dual_exp(z: Any) -> Any:
    """Exponential of a dual number."""
    value = math.exp(z.real)
    return complex(value, value * z.imag)


@cache
def thrust_kernel() -> Callable:
    """Compile a function that fills in thrusts f (2, 2 K + 1) at half steps from commanded voltages u (2, K)."""

    def fill_thrusts(u, theta, dt, voltage, f):
        p = unpack(theta)
        n = int(p.delay.real / dt)
        share = p.delay / dt - n
        half, whole = dual_exp(-0.5 * dt / p.lag), dual_exp(-dt / p.lag)
        for i in range(2):
            gain = 1.0 + p.mismatch if i == 0 else 1.0 - p.mismatch
            w = u[i, 0] + 0.0j
            for k in range(u.shape[1]):
                now, before = clip(u[i, max(k - n, 0)], p.voltage_limit), clip(u[i, max(k - n - 1, 0)], p.voltage_limit)
                command = (1.0 - share) * now + share * before
                f[i, 2 * k] = gain * rotor_thrust(w, p, voltage)
                f[i, 2 * k + 1] = gain * rotor_thrust(command + (w - command) * half, p, voltage)
                w = command + (w - command) * whole
            f[i, 2 * u.shape[1]] = gain * rotor_thrust(w, p, voltage)

    return jit_cached(fill_thrusts)


def unpack(theta: Any) -> Any:
    """Unpack the parameter vector into MeasuredParameters."""
    return MeasuredParameters(
        theta[0], theta[1], theta[2], theta[3], theta[4], theta[5], theta[6], theta[7], theta[8], theta[9], theta[10],
        theta[11], theta[12], theta[13], theta[14], theta[15], theta[16], theta[17], theta[18], theta[19], theta[20],
        theta[21],
    )  # fmt: skip


def flow(x: Any, f: Any, k: int, dt: float, p: Any, offsets: Any) -> Any:
    """State one sample after sample k, by a Runge-Kutta step."""
    inputs = (f[0, 2 * k], f[1, 2 * k]), (f[0, 2 * k + 1], f[1, 2 * k + 1]), (f[0, 2 * k + 2], f[1, 2 * k + 2])
    return rk4_step(measured_dynamics, x, inputs, dt, p, offsets)


@cache
def simulation_kernel() -> Callable:
    """Compile a function that fills in states y (6, n + 1) from state and offsets z (9,) at sample k, and thrusts f."""

    def simulate(z, f, k, dt, theta, y):
        p = unpack(theta)
        x = (z[0], z[1], z[2], z[3], z[4], z[5])
        offsets = (z[6], z[7], z[8])
        for j in range(6):
            y[j, 0] = x[j]
        for i in range(y.shape[1] - 1):
            x = flow(x, f, k + i, dt, p, offsets)
            for j in range(6):
                y[j, i + 1] = x[j]

    return jit_cached(simulate)


@cache
def sensitivity_kernel() -> Callable:
    """Compile a function that fills in angles y (W, 3, n + 1) over windows, and derivatives dy (W, 9 + P, 3, n + 1).

    starts (W,) are the first samples, z (W, 9) states and offsets there; df (P, 2, 2 K + 1) are thrusts with the
    derivatives by the chosen parameters as imaginary parts. dy is by initial states, offsets and parameters.
    """

    def simulate_windows(z, starts, df, dt, theta, chosen, y, dy):
        n = y.shape[2] - 1
        dual = np.empty(9, dtype=np.complex128)
        moved = theta.copy()
        for w in range(len(starts)):
            for j in range(9 + len(chosen)):
                for i in range(9):
                    dual[i] = complex(z[w, i], STEP if i == j else 0.0)
                which = max(j - 9, 0)
                if j >= 9:
                    moved[chosen[which]] = complex(theta[chosen[which]].real, STEP)
                p = unpack(moved)
                f = df[which if j >= 9 else len(chosen)]
                x = (dual[0], dual[1], dual[2], dual[3], dual[4], dual[5])
                offsets = (dual[6], dual[7], dual[8])
                for i in range(n + 1):
                    for axis in range(3):
                        dy[w, j, axis, i] = x[2 * axis].imag / STEP
                        if j == 0:
                            y[w, axis, i] = x[2 * axis].real
                    if i < n:
                        x = flow(x, f, starts[w] + i, dt, p, offsets)
                if j >= 9:
                    moved[chosen[which]] = theta[chosen[which]].real + 0.0j

    return jit_cached(simulate_windows)


N = 12  # size of the filter's state: angles and rates, fading offsets, constant offsets


@cache
def filter_kernel() -> Callable:
    """Compile an extended Kalman filter on angles (3, K) that fills in estimates z (12, K) and innovations e (3, K).

    The state is that of (3), accelerations (3,) that decay by the factors `decay` (3,) per sample, and constant
    accelerations (3,). q (12,) are process variances per second, r (3,) measurement variances; P (12, 12) is the
    initial covariance and is overwritten by the final one. z is given at the sample `first`.
    """

    def run_filter(angles, f, dt, theta, q, r, decay, z, e, P, first, last):
        p = unpack(theta)
        F = np.zeros((N, N))
        A = np.empty((N, N))
        dual = np.empty(9, dtype=np.complex128)
        for i in range(6, N):
            F[i, i] = decay[i - 6] if i < 9 else 1.0
        for k in range(first, last):
            if k > first:
                for j in range(9):
                    for i in range(9):
                        value = z[i, k - 1] if i < 6 else z[i, k - 1] + z[i + 3, k - 1]
                        dual[i] = complex(value, STEP if i == j else 0.0)
                    x = (dual[0], dual[1], dual[2], dual[3], dual[4], dual[5])
                    x = flow(x, f, k - 1, dt, p, (dual[6], dual[7], dual[8]))
                    for i in range(6):
                        F[i, j] = x[i].imag / STEP
                        if j >= 6:
                            F[i, j + 3] = F[i, j]
                        if j == 0:
                            z[i, k] = x[i].real
                for i in range(6, N):
                    z[i, k] = F[i, i] * z[i, k - 1]
                for i in range(N):
                    for j in range(N):
                        total = 0.0
                        for m in range(N):
                            total += F[i, m] * P[m, j]
                        A[i, j] = total
                for i in range(N):
                    for j in range(N):
                        total = q[i] * dt if i == j else 0.0
                        for m in range(N):
                            total += A[i, m] * F[j, m]
                        P[i, j] = total
            for axis in range(3):
                row = 2 * axis
                error = angles[axis, k] - z[row, k]
                variance = P[row, row] + r[axis]
                e[axis, k] = error
                for i in range(N):
                    A[0, i] = P[i, row] / variance
                    A[1, i] = P[row, i]
                for i in range(N):
                    z[i, k] += A[0, i] * error
                    for j in range(N):
                        P[i, j] -= A[0, i] * A[1, j]

    return jit_cached(run_filter)


@cache
def prediction_kernel() -> Callable:
    """Compile a function that fills in angles y (S, 3, n + 1), predicted from estimates z (12, K) at starts (S,)."""

    def predict(z, starts, f, dt, theta, decay, y):
        p = unpack(theta)
        for s in range(len(starts)):
            k = starts[s]
            x = (z[0, k] + 0j, z[1, k] + 0j, z[2, k] + 0j, z[3, k] + 0j, z[4, k] + 0j, z[5, k] + 0j)
            fading = (z[6, k] + 0j, z[7, k] + 0j, z[8, k] + 0j)
            for i in range(y.shape[2]):
                for axis in range(3):
                    y[s, axis, i] = x[2 * axis].real
                if i < y.shape[2] - 1:
                    offsets = (fading[0] + z[9, k], fading[1] + z[10, k], fading[2] + z[11, k])
                    x = flow(x, f, k + i, dt, p, offsets)
                    fading = (fading[0] * decay[0], fading[1] * decay[1], fading[2] * decay[2])

    return jit_cached(predict)


def dual_thrusts(theta: np.ndarray, voltages: np.ndarray, dt: float, voltage: float, chosen: np.ndarray) -> np.ndarray:
    """Thrusts (P + 1, 2, 2 K + 1): P with derivatives by the chosen parameters as imaginary parts, the last real."""
    f = np.empty((len(chosen) + 1, 2, 2 * voltages.shape[1] + 1), dtype=complex)
    for i in range(len(chosen) + 1):
        moved = theta.astype(complex)
        if i < len(chosen):
            moved[chosen[i]] += 1j * STEP
        thrust_kernel()(voltages, moved, dt, voltage, f[i])
    return f
