"""Gradients of flights with respect to a recurrent network's weights, by backpropagation through the simulator.

A batch is `LANES` flights of plants like `lab`, `rigid` and `fleet`: equation (3) or the full rigid body, with rotor
lag, friction, power curves of thrust, thrust loss, delay and encoders. A feedforward with state feedback (51) flies
them, and a GRU corrects it. Compiled kernels integrate one control period and its adjoint; numpy computes the network's
matrix products. The derivative of quantisation is taken as 1 (straight-through estimator).
"""

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numba.np.unsafe.ndarray import to_fixed_tuple
from numpy import cos, floor, sin

from heli_gym.baselines.control.residual import FEATURE_CLIP
from heli_gym.compilation import Compiler
from heli_gym.model import axpy, dynamics, rk4_step, virtual_input
from heli_gym.parameters import Coupling, HelicopterParameters
from heli_gym.plant import COULOMB_RATE, FOOT_SPREAD, quantise, with_coupling
from heli_gym.rigid_body import (
    RigidBodyParameters,
    coriolis,
    generalised_forces,
    gravity,
    mass_matrix,
    rigid_dynamics,
    solve_symmetric,
)
from heli_gym.simulation import fast_math
from heli_gym.simulation.fast_math import power
from heli_gym.task import TOLERANCE

LANES = 128  # flights in a batch
SUBSTEPS = 2  # integration steps in a control period
SAFE_PITCH = 1.1  # rad, pitch from which on a penalty applies; the flight ends at the stop
PITCH_PENALTY = 20.0  # 1/(s rad²), usual penalty of the squared excess pitch
LEAST_VOLTAGE = 0.5  # V; below it, the slope of the inverse of (2), infinite at zero, stays constant
N_FLIGHT_FEATURES = 10  # features that depend on the flight: tracking error (6), base voltages (2), last correction (2)

# Rows of a helicopter's numbers: k_plus with thrust loss, decay by the rotor lag in half a substep, encoder counts;
# then the coefficients of motion, `COEFFICIENTS` of (3) or `RIGID` of the rigid body, with viscous friction last.
K_PLUS, LAG_DECAY, COUNTS, NUMBERS = 0, 1, 2, 5
COEFFICIENTS, RIGID = 9, 14
# Further rows of the helicopters of `fleet`: thrusts at 1 V of the front rotor, forwards and backwards, and of the back
# rotor; exponents of both; share of the thrust left by drift; s from the start of a period to the arrival of delayed
# voltages, and decay by the lag over half of it; Coulomb friction; travel lift; zeros of the sensors; moments between
# the axes.
THRUST, EXPONENTS, EFFECT = NUMBERS + COEFFICIENTS, NUMBERS + COEFFICIENTS + 4, NUMBERS + COEFFICIENTS + 6
REST, REST_DECAY, OF_COULOMB, LIFT, ZEROS = EFFECT + 1, EFFECT + 2, EFFECT + 3, EFFECT + 6, EFFECT + 7
MOMENTS = ZEROS + 3
FLEET = MOMENTS + len(Coupling._fields)  # number of rows
LEAST_SPEED = 0.2  # V


class Settings(NamedTuple):
    """Settings of a task, all of them floats; the kernels receive them as an array, whose dispatch is faster."""

    period: float  # s
    u_low: float  # V, the amplifier's limits
    u_high: float
    pitch_limit: float  # rad, end of a flight
    u_min: float  # V and rad, the reference's limits (9)
    u_max: float
    pitch_min: float
    pitch_max: float
    rate_decay: float  # of the rate filter, per period
    scale: float  # V, greatest correction
    k_plus: float  # N/V^exponent, nominal
    k_minus: float
    cost_weight: float  # deg/s, weight of the cost in the loss
    elevation_weight: float
    base_low: float  # V, limits of the base voltages before the correction
    base_high: float
    exponent: float  # nominal, of the thrust map
    pitch_penalty: float = PITCH_PENALTY


FIELDS = len(Settings._fields)


class Task(NamedTuple):
    """Common data of all flights, in arrays over T control periods."""

    x_ref: np.ndarray  # (T + 1, 6)
    v_ref: np.ndarray  # (T, 2), N
    gains: np.ndarray  # (T, 2, 6)
    preview: np.ndarray  # (T, P), single precision: features that depend on time alone
    settings: Settings
    delay: int  # control periods; of `fleet` at least one more than any helicopter's
    after_crash: bool = False  # whether a crashed flight counts to the end, as in `Metrics`, or its errors end with it


class Weights(NamedTuple):
    """Weights of the network in single precision: a GRU cell, with gates in torch's order, and a linear layer."""

    seen: np.ndarray  # (3H, N_FLIGHT_FEATURES), columns of the input matrix for flight features
    preview: np.ndarray  # (3H, P), columns for time features
    hidden: np.ndarray  # (3H, H)
    input_bias: np.ndarray  # (3H,)
    hidden_bias: np.ndarray  # (3H,)
    output: np.ndarray  # (2, H)
    output_bias: np.ndarray  # (2,)


class Batch(NamedTuple):
    """Starts and plants of the flights, in arrays (..., LANES)."""

    body: np.ndarray  # (NUMBERS + COEFFICIENTS, LANES), (NUMBERS + RIGID, LANES) or (FLEET, LANES)
    x: np.ndarray  # (6, LANES)
    measured: np.ndarray  # (6, LANES)
    u: np.ndarray  # (2, LANES), V, motor voltages
    delay: np.ndarray | None = None  # (LANES,), whole control periods of delay of each; by default the task's
    drift: np.ndarray | None = None  # (LANES,), 1/s, share of the thrust lost per second
    hidden: np.ndarray | None = None  # (H, LANES), first hidden states; by default zero


class Outcome(NamedTuple):
    """Results of the flights, in arrays (LANES,)."""

    travel_deg: np.ndarray  # RMS error
    elevation_deg: np.ndarray
    cost: np.ndarray  # s
    penalty: np.ndarray
    crashed: np.ndarray  # 1 or 0


# One control period, one helicopter after the other; compiled below.


def clip(value: Any, low: Any, high: Any) -> Any:
    """Clip a value to [low, high]."""
    return min(max(value, low), high)


def inside(value: Any, low: Any, high: Any) -> Any:
    """Derivative of `clip`: 1 inside, 0 outside."""
    return 1.0 if low < value < high else 0.0


def settings_of(settings: Any) -> Settings:
    """Settings from an array (FIELDS,)."""
    return Settings(*to_fixed_tuple(settings, FIELDS))  # type: ignore[call-arg]


def base_voltage(f: Any, s: Settings) -> Any:
    """Voltage in V for a thrust f in N by (2), without numpy: `model.voltage` for the compiler."""
    root = (abs(f) / (s.k_plus if f >= 0.0 else -s.k_minus)) ** 0.5
    return root if f >= 0.0 else -root


def base_voltage_slope(u: Any, s: Settings) -> Any:
    """Derivative in V/N of `base_voltage` where it is u."""
    return 1.0 / (2.0 * (s.k_plus if u >= 0.0 else -s.k_minus) * max(abs(u), LEAST_VOLTAGE))


def power_base_voltage(f: Any, s: Settings) -> Any:
    """Voltage in V for a thrust f in N by a power curve."""
    root = power(abs(f) / (s.k_plus if f >= 0.0 else -s.k_minus), 1.0 / s.exponent)
    return root if f >= 0.0 else -root


def power_base_voltage_slope(u: Any, s: Settings) -> Any:
    """Derivative in V/N of `power_base_voltage` where it is u."""
    k = s.k_plus if u >= 0.0 else -s.k_minus
    return 1.0 / (s.exponent * k * power(max(abs(u), LEAST_VOLTAGE), s.exponent - 1.0))


def observe(
    measured: Any, x_ref: Any, v_ref: Any, gains: Any, settings: Any, last: Any, base: Any, features: Any
) -> None:
    """Write the unsaturated base voltages (2, LANES), by (51), and the flight features (N_FLIGHT_FEATURES, LANES)."""
    s = settings_of(settings)
    middle, half = 0.5 * (s.u_low + s.u_high), 0.5 * (s.u_high - s.u_low)
    for i in range(LANES):
        v1, v2 = v_ref[0], v_ref[1]
        for j in range(6):
            error = measured[j, i] - x_ref[j]
            v1 -= gains[0, j] * error
            v2 -= gains[1, j] * error
            features[j, i] = clip(error / TOLERANCE[j], -FEATURE_CLIP, FEATURE_CLIP)
        front, back = base_voltage(0.5 * (v1 + v2), s), base_voltage(0.5 * (v1 - v2), s)
        base[0, i], base[1, i] = front, back
        features[6, i] = clip((front - middle) / half, -FEATURE_CLIP, FEATURE_CLIP)
        features[7, i] = clip((back - middle) / half, -FEATURE_CLIP, FEATURE_CLIP)
        features[8, i], features[9, i] = last[0, i], last[1, i]


def observe_adjoint(
    x_ref: Any, gains: Any, settings: Any, measured: Any, base: Any, d_features: Any, d_base: Any, d_measured: Any,
    d_last: Any,
) -> None:  # fmt: skip
    """Adjoint of `observe`: adds to d_measured and sets d_last."""
    s = settings_of(settings)
    middle, half = 0.5 * (s.u_low + s.u_high), 0.5 * (s.u_high - s.u_low)
    for i in range(LANES):
        d_front = d_base[0, i] + d_features[6, i] / half * inside(
            (base[0, i] - middle) / half, -FEATURE_CLIP, FEATURE_CLIP
        )
        d_back = d_base[1, i] + d_features[7, i] / half * inside(
            (base[1, i] - middle) / half, -FEATURE_CLIP, FEATURE_CLIP
        )
        d_f = d_front * base_voltage_slope(base[0, i], s)
        d_b = d_back * base_voltage_slope(base[1, i], s)
        d_v1, d_v2 = 0.5 * (d_f + d_b), 0.5 * (d_f - d_b)
        for j in range(6):
            error = (measured[j, i] - x_ref[j]) / TOLERANCE[j]
            d_measured[j, i] += (
                d_features[j, i] / TOLERANCE[j] * inside(error, -FEATURE_CLIP, FEATURE_CLIP)
                - gains[0, j] * d_v1
                - gains[1, j] * d_v2
            )
        d_last[0, i], d_last[1, i] = d_features[8, i], d_features[9, i]


# Rotors, delays and sensors of plants like `lab`; `kernels` binds these names to others for `fleet`.


def thrusts(w_f: Any, w_b: Any, body: Any, i: int) -> tuple[Any, Any]:
    """Thrusts (2,) in N of forward rotors at the speeds w, as voltages, by (2)."""
    k = body[K_PLUS, i]
    return k * w_f * w_f, k * w_b * w_b


def slopes_of(w_f: Any, w_b: Any, body: Any, i: int) -> tuple[Any, Any]:
    """Derivatives (2,) of `thrusts` in N/V."""
    k = body[K_PLUS, i]
    return 2.0 * k * w_f, 2.0 * k * w_b


def first_step(s: Settings, body: Any, i: int) -> tuple[Any, Any]:
    """Duration in s of the first part of the period, and the rotors' decay over half of it."""
    return s.period / SUBSTEPS, body[LAG_DECAY, i]


def second_step(s: Settings, body: Any, i: int) -> tuple[Any, Any]:
    """Duration in s of the second part of the period, and the rotors' decay over half of it."""
    return s.period / SUBSTEPS, body[LAG_DECAY, i]


def zero_of(body: Any, axis: int, i: int) -> Any:
    """Angle in rad at which a sensor reads zero."""
    return 0.0


def fleet_thrusts(w_f: Any, w_b: Any, body: Any, i: int) -> tuple[Any, Any]:
    """Thrusts (2,) in N of rotors with power curves, forwards or backwards."""
    front = power(abs(w_f), body[EXPONENTS, i]) * (body[THRUST, i] if w_f >= 0.0 else body[THRUST + 1, i])
    back = power(abs(w_b), body[EXPONENTS + 1, i]) * (body[THRUST + 2, i] if w_b >= 0.0 else body[THRUST + 3, i])
    return front * body[EFFECT, i], back * body[EFFECT, i]


def fleet_slopes(w_f: Any, w_b: Any, body: Any, i: int) -> tuple[Any, Any]:
    """Derivatives (2,) of `fleet_thrusts` in N/V; below `LEAST_SPEED` they go to zero, where they may be infinite."""
    front, back = fleet_thrusts(w_f, w_b, body, i)
    return (
        body[EXPONENTS, i] * abs(front) / max(abs(w_f), LEAST_SPEED),
        body[EXPONENTS + 1, i] * abs(back) / max(abs(w_b), LEAST_SPEED),
    )


def fleet_first_step(s: Settings, body: Any, i: int) -> tuple[Any, Any]:
    """`first_step`, to the arrival of the delayed voltages."""
    return body[REST, i], body[REST_DECAY, i]


def fleet_second_step(s: Settings, body: Any, i: int) -> tuple[Any, Any]:
    """`second_step`, from the arrival of the delayed voltages on."""
    return s.period - body[REST, i], body[LAG_DECAY, i]


def fleet_zero_of(body: Any, axis: int, i: int) -> Any:
    """`zero_of` of a drawn rig."""
    return body[ZEROS + axis, i]


# Equations of motion and their vector-Jacobian products, by (3) or for the rigid body; `kernels` binds these names.


def equation_3_parameters(body: Any, i: int) -> Any:
    """Parameters of (3) of helicopter i; its thrust map has separate rows."""
    k = NUMBERS
    return HelicopterParameters(
        0.0, 0.0, body[k, i], body[k + 1, i], body[k + 2, i], body[k + 3, i], body[k + 4, i], body[k + 5, i],
        body[k + 6, i], body[k + 7, i], body[k + 8, i],
    )  # fmt: skip


def parameters_of(body: Any, i: int) -> Any:
    """Parameters of `derivative` for helicopter i."""
    return equation_3_parameters(body, i)


def derivative(x: Any, v: Any, p: Any) -> Any:
    """State derivative (6,) by (3)."""
    return dynamics(x, v, p, sin, cos)


def equation_3_adjoint(x: Any, v: Any, p: Any, d: Any) -> Any:
    """Products of d (6,) with the Jacobians of (3), with respect to x (6,) and v (2,)."""
    s2, c2, s3, c3 = sin(x[2]), cos(x[2]), sin(x[4]), cos(x[4])
    d_x = (
        0.0,
        d[0] - p.c1 * d[1],
        -p.b1 * s2 * s3 * v[0] * d[1] + (p.a1 * c2 - p.a2 * s2) * d[3] - p.a3 * s2 * s3 * d[5],
        d[2] - p.c2 * d[3],
        p.b1 * c2 * c3 * v[0] * d[1] - p.b2 * s3 * v[0] * d[3] + p.a3 * c2 * c3 * d[5],
        d[4] - p.c3 * d[5],
    )
    return d_x, (p.b1 * c2 * s3 * d[1] + p.b2 * c3 * d[3], p.b3 * d[5])


def derivative_adjoint(x: Any, v: Any, p: Any, d: Any) -> Any:
    """Products of d (6,) with the Jacobians of `derivative`, with respect to x (6,) and v (2,)."""
    return equation_3_adjoint(x, v, p, d)


def fleet_parameters_of(body: Any, i: int) -> Any:
    """Parameters of (3), Coulomb friction (3,), travel lift and `Coupling` of helicopter i."""
    coulomb, k = (body[OF_COULOMB, i], body[OF_COULOMB + 1, i], body[OF_COULOMB + 2, i]), MOMENTS
    coupling = body[k, i], body[k + 1, i], body[k + 2, i], body[k + 3, i], body[k + 4, i]
    return equation_3_parameters(body, i), coulomb, body[LIFT, i], coupling


def dry(rate: Any, coulomb: Any) -> Any:
    """Coulomb friction of `plant.friction` in rad/s²."""
    return coulomb * rate / (rate * rate + COULOMB_RATE * COULOMB_RATE) ** 0.5


def dry_slope(rate: Any, coulomb: Any) -> Any:
    """Derivative of `dry` by the rate."""
    square = rate * rate + COULOMB_RATE * COULOMB_RATE
    return coulomb * COULOMB_RATE * COULOMB_RATE / (square * square**0.5)


def fleet_derivative(x: Any, v: Any, p: Any) -> Any:
    """State derivative (6,) by (3) with Coulomb friction, lift and moments between the axes; the table is left out."""
    own, coulomb, lift, coupling = p
    coupled = with_coupling(x, dynamics(x, v, own, sin, cos), abs(x[1]), own, coupling, sin, cos)
    dq1, ddq1, dq2, ddq2, dq3, ddq3 = coupled
    return (
        dq1,
        ddq1 - dry(dq1, coulomb[0]),
        dq2,
        ddq2 + lift * dq1 * dq1 - dry(dq2, coulomb[1]),
        dq3,
        ddq3 - dry(dq3, coulomb[2]),
    )


def fleet_derivative_adjoint(x: Any, v: Any, p: Any, d: Any) -> Any:
    """Products of d (6,) with the Jacobians of `fleet_derivative`, with respect to x (6,) and v (2,)."""
    own, coulomb, lift, coupling = p
    (d1, d2, d3, d4, d5, d6), d_v = equation_3_adjoint(x, v, own, d)
    m2, m3, m4, m5, m6 = coupling_adjoint(x, own, coupling, d)
    return (
        d1,
        d2 + m2 - dry_slope(x[1], coulomb[0]) * d[1] + 2.0 * lift * x[1] * d[3],
        d3 + m3,
        d4 + m4 - dry_slope(x[3], coulomb[1]) * d[3],
        d5 + m5,
        d6 + m6 - dry_slope(x[5], coulomb[2]) * d[5],
    ), d_v


def coupling_adjoint(x: Any, p: Any, coupling: Any, d: Any) -> Any:
    """Products of d (6,) with the Jacobian of the moments of `with_coupling`, with respect to x[1:] (5,)."""
    _, w1, q2, w2, q3, w3 = x
    centrifugal, centre, spin, gyro, airflow = coupling
    up, along, s3, c3 = sin(q2 - centre), cos(q2 - centre), sin(q3), cos(q3)
    reaction = gyro * FOOT_SPREAD * p.b2 / p.b3
    coriolis_force, swing = 2.0 * centrifugal * up / along, spin * s3 * c3
    return (
        coriolis_force * w2 * d[1]
        - 2.0 * centrifugal * up * along * w1 * d[3]
        + (2.0 * airflow * abs(w1) - 2.0 * swing * w1 + gyro * s3) * d[5],
        2.0 * centrifugal * w1 * w2 / (along * along) * d[1] - centrifugal * (along * along - up * up) * w1 * w1 * d[3],
        coriolis_force * w1 * d[1] + (2.0 * swing * w2 + gyro * c3) * d[5],
        reaction * w3 * (c3 * d[1] - s3 * d[3])
        + (gyro * (w1 * c3 - w2 * s3) - spin * (c3 * c3 - s3 * s3) * (w1 * w1 - w2 * w2)) * d[5],
        reaction * (s3 * d[1] + c3 * d[3]),
    )


def rigid_parameters_of(body: Any, i: int) -> Any:
    """Rigid body and viscous friction (3,) of helicopter i."""
    k = NUMBERS
    rig = RigidBodyParameters(
        body[k, i], body[k + 1, i], body[k + 2, i], body[k + 3, i], body[k + 4, i], body[k + 5, i], body[k + 6, i],
        body[k + 7, i], body[k + 8, i], body[k + 9, i], body[k + 10, i],
    )  # fmt: skip
    return rig, (body[k + 11, i], body[k + 12, i], body[k + 13, i])


def rigid_derivative(x: Any, v: Any, p: Any) -> Any:
    """State derivative (6,) of the full rigid body with viscous friction."""
    rig, c = p
    dq1, ddq1, dq2, ddq2, dq3, ddq3 = rigid_dynamics(x, v, rig, sin, cos)
    return dq1, ddq1 - c[0] * dq1, dq2, ddq2 - c[1] * dq2, dq3, ddq3 - c[2] * dq3


def test_power(angles: Any, w: Any, v: Any, a: Any, rig: Any, test: Any) -> Any:
    """Product of `test` (3,) with torques minus inertial torques at accelerations a (3,) of (q1, eps, phi)."""
    ce, se, cf, sf = angles
    D11, D22, D33, D12, D13, D23 = mass_matrix(ce, se, cf, sf, rig)
    c1, c2, c3 = coriolis(ce, se, cf, sf, w[0], w[1], w[2], rig)
    g1, g2, g3 = gravity(ce, se, cf, sf, rig)
    Q1, Q2, Q3 = generalised_forces(ce, se, cf, sf, v[0], v[1], rig)
    return (
        test[0] * (Q1 - c1 - g1 - D11 * a[0] - D12 * a[1] - D13 * a[2])
        + test[1] * (Q2 - c2 - g2 - D12 * a[0] - D22 * a[1] - D23 * a[2])
        + test[2] * (Q3 - c3 - g3 - D13 * a[0] - D23 * a[1] - D33 * a[2])
    )


def rigid_derivative_adjoint(x: Any, v: Any, p: Any, d: Any) -> Any:
    """Products of d (6,) with the Jacobians of the full model, with respect to x (6,) and v (2,).

    D a = f gives the product of d with the accelerations' Jacobian from D a - f and D^-1 d. Derivatives with respect to
    angles are complex steps. Coriolis torques are quadratic in the rates, so their central difference is exact; the
    other terms are linear.
    """
    rig, c = p
    ce, se, cf, sf = cos(x[2]), -sin(x[2]), cos(x[4]), sin(x[4])
    w = x[1], -x[3], x[5]
    D = mass_matrix(ce, se, cf, sf, rig)
    c1, c2, c3 = coriolis(ce, se, cf, sf, w[0], w[1], w[2], rig)
    g1, g2, g3 = gravity(ce, se, cf, sf, rig)
    Q1, Q2, Q3 = generalised_forces(ce, se, cf, sf, v[0], v[1], rig)
    a = solve_symmetric(D, (Q1 - c1 - g1, Q2 - c2 - g2, Q3 - c3 - g3))
    test = solve_symmetric(D, (d[1], -d[3], d[5]))
    by_eps = test_power((ce - STEP * se, se + STEP * ce, cf, sf), w, v, a, rig, test).imag / 1e-30
    by_phi = test_power((ce, se, cf - STEP * sf, sf + STEP * cf), w, v, a, rig, test).imag / 1e-30
    by_w1 = quadratic_slope(ce, se, cf, sf, w, (1.0, 0.0, 0.0), rig, test)
    by_w2 = quadratic_slope(ce, se, cf, sf, w, (0.0, 1.0, 0.0), rig, test)
    by_w3 = quadratic_slope(ce, se, cf, sf, w, (0.0, 0.0, 1.0), rig, test)
    front = generalised_forces(ce, se, cf, sf, 1.0, 0.0, rig)
    back = generalised_forces(ce, se, cf, sf, 0.0, 1.0, rig)
    d_x = (
        0.0,
        d[0] + by_w1 - c[0] * d[1],
        -by_eps,
        d[2] - by_w2 - c[1] * d[3],
        by_phi,
        d[4] + by_w3 - c[2] * d[5],
    )
    return d_x, (
        test[0] * front[0] + test[1] * front[1] + test[2] * front[2],
        test[0] * back[0] + test[1] * back[1] + test[2] * back[2],
    )


STEP = 1e-30j  # rad, complex step of the angles


def quadratic_slope(ce: Any, se: Any, cf: Any, sf: Any, w: Any, e: Any, rig: Any, test: Any) -> Any:
    """Product of `test` (3,) with the derivative of the negative Coriolis torques along e (3,)."""
    u1, u2, u3 = coriolis(ce, se, cf, sf, w[0] + e[0], w[1] + e[1], w[2] + e[2], rig)
    l1, l2, l3 = coriolis(ce, se, cf, sf, w[0] - e[0], w[1] - e[1], w[2] - e[2], rig)
    return -0.5 * (test[0] * (u1 - l1) + test[1] * (u2 - l2) + test[2] * (u3 - l3))


def scaled(h: Any, d: Any) -> Any:
    """Product h d (6,) of a number and a tuple."""
    return h * d[0], h * d[1], h * d[2], h * d[3], h * d[4], h * d[5]


def rk4_adjoint(x: Any, inputs: Any, h: Any, p: Any, d: Any) -> Any:
    """Adjoint of `rk4_step`: derivatives at x (6,) and at the three inputs (2,), from d (6,) at the end."""
    start, middle, end = inputs
    d1 = derivative(x, start, p)
    x2 = axpy(x, h / 2.0, d1)
    d2 = derivative(x2, middle, p)
    x3 = axpy(x, h / 2.0, d2)
    d3 = derivative(x3, middle, p)
    x4 = axpy(x, h, d3)
    back4, input4 = derivative_adjoint(x4, end, p, scaled(h / 6.0, d))
    back3, input3 = derivative_adjoint(x3, middle, p, axpy(scaled(h / 3.0, d), h, back4))
    back2, input2 = derivative_adjoint(x2, middle, p, axpy(scaled(h / 3.0, d), h / 2.0, back3))
    back1, input1 = derivative_adjoint(x, start, p, axpy(scaled(h / 6.0, d), h / 2.0, back2))
    d = axpy(axpy(axpy(axpy(d, 1.0, back1), 1.0, back2), 1.0, back3), 1.0, back4)
    return d, input1, (input2[0] + input3[0], input2[1] + input3[1]), input4


def six(values: Any, i: int) -> Any:
    """Column i of an array (6, LANES) as a tuple."""
    return values[0, i], values[1, i], values[2, i], values[3, i], values[4, i], values[5, i]


def excess_slope(value: Any, low: Any, high: Any) -> Any:
    """Derivative of `task.excess`."""
    return (1.0 if value > high else (-1.0 if value < low else 0.0)) / (high - low)


def excess(value: Any, low: Any, high: Any) -> Any:
    """Scalar form of `task.excess` for the compiler."""
    return max(max(value - high, low - value), 0.0) / (high - low)


def turned(u: Any, w: Any, decay: Any) -> tuple[Any, Any]:
    """Rotor speeds at the middle and the end of a step, as steady-state voltages, from w under a motor voltage u."""
    middle = u + decay * (w - u)
    return middle, u + decay * (middle - u)


def fly_part(x: Any, w: Any, u: Any, step: Any, body: Any, i: int, p: Any) -> tuple[Any, Any]:
    """State (6,) and rotors (2,) after a step (h, decay), from x and w under the motor voltages u (2,)."""
    h, decay = step
    m_f, e_f = turned(u[0], w[0], decay)
    m_b, e_b = turned(u[1], w[1], decay)
    inputs = (
        virtual_input(thrusts(w[0], w[1], body, i)),
        virtual_input(thrusts(m_f, m_b, body, i)),
        virtual_input(thrusts(e_f, e_b, body, i)),
    )
    return rk4_step(derivative, x, inputs, h, p), (e_f, e_b)


def fly_part_adjoint(x: Any, w: Any, u: Any, step: Any, body: Any, i: int, p: Any, d: Any, d_w: Any) -> tuple:
    """Adjoint of `fly_part`: derivatives by x, w and u, from d (6,) and d_w (2,) at the end of the step."""
    h, decay = step
    (w_f, w_b), (d_f, d_b) = w, d_w
    m_f, e_f = turned(u[0], w_f, decay)
    m_b, e_b = turned(u[1], w_b, decay)
    inputs = (
        virtual_input(thrusts(w_f, w_b, body, i)),
        virtual_input(thrusts(m_f, m_b, body, i)),
        virtual_input(thrusts(e_f, e_b, body, i)),
    )
    d, v1, v2, v3 = rk4_adjoint(x, inputs, h, p, d)
    s_f, s_b = slopes_of(e_f, e_b, body, i)
    d_f, d_b = d_f + s_f * (v3[0] + v3[1]), d_b + s_b * (v3[0] - v3[1])
    to_f, to_b = (1.0 - decay) * d_f, (1.0 - decay) * d_b
    s_f, s_b = slopes_of(m_f, m_b, body, i)
    d_f, d_b = decay * d_f + s_f * (v2[0] + v2[1]), decay * d_b + s_b * (v2[0] - v2[1])
    to_f, to_b = to_f + (1.0 - decay) * d_f, to_b + (1.0 - decay) * d_b
    s_f, s_b = slopes_of(w_f, w_b, body, i)
    return d, (decay * d_f + s_f * (v1[0] + v1[1]), decay * d_b + s_b * (v1[0] - v1[1])), (to_f, to_b)


def fly(
    settings: Any, body: Any, x: Any, rotors: Any, before: Any, motors: Any, measured: Any, base: Any, action: Any,
    alive: Any, x_ref: Any, u: Any, next_x: Any, next_rotors: Any, next_measured: Any, next_alive: Any, sums: Any,
) -> None:  # fmt: skip
    """Fly one control period: write commanded voltages, next states and measurements; add to the sums of `Outcome`.

    The motors receive the voltages `before` in the first part of the period and `motors` in the second.
    """
    s = settings_of(settings)
    for i in range(LANES):
        front = clip(clip(base[0, i], s.base_low, s.base_high) + s.scale * action[0, i], s.u_low, s.u_high)
        back = clip(clip(base[1, i], s.base_low, s.base_high) + s.scale * action[1, i], s.u_low, s.u_high)
        u[0, i], u[1, i] = front, back
        p = parameters_of(body, i)
        first = fly_part(
            six(x, i), (rotors[0, i], rotors[1, i]), (before[0, i], before[1, i]), first_step(s, body, i), body, i, p
        )
        state, w = fly_part(first[0], first[1], (motors[0, i], motors[1, i]), second_step(s, body, i), body, i, p)
        on = alive[i]
        next_rotors[0, i], next_rotors[1, i] = w
        q1, dq1, q2, dq2, q3, dq3 = state
        next_x[0, i], next_x[1, i] = (q1 if on > 0.0 else x[0, i]), (dq1 if on > 0.0 else x[1, i])
        next_x[2, i], next_x[3, i] = (q2 if on > 0.0 else x[2, i]), (dq2 if on > 0.0 else x[3, i])
        next_x[4, i], next_x[5, i] = (q3 if on > 0.0 else x[4, i]), (dq3 if on > 0.0 else x[5, i])
        travel, elevation = q1 - x_ref[0], q2 - x_ref[2]
        over = max(abs(q3) - SAFE_PITCH, 0.0)
        beyond = excess(q3, s.pitch_min, s.pitch_max) + excess(front, s.u_min, s.u_max) + excess(back, s.u_min, s.u_max)
        sums[0, i] += on * travel * travel
        sums[1, i] += on * elevation * elevation
        sums[2, i] += on * s.period * beyond
        sums[3, i] += on * s.period * s.pitch_penalty * over * over
        next_alive[i] = on if abs(q3) <= s.pitch_limit else 0.0
        for axis in range(3):
            counts = body[COUNTS + axis, i]
            angle = next_x[2 * axis, i] - zero_of(body, axis, i)
            shown = quantise(angle, max(counts, 1.0), floor) if counts > 0.0 else angle
            rate = s.rate_decay * measured[2 * axis + 1, i]
            next_measured[2 * axis + 1, i] = rate + (1.0 - s.rate_decay) * (shown - measured[2 * axis, i]) / s.period
            next_measured[2 * axis, i] = shown


def fly_adjoint(
    settings: Any, body: Any, x: Any, rotors: Any, before: Any, motors: Any, alive: Any, x_ref: Any, next_x: Any,
    slopes: Any, d_x: Any, d_rotors: Any, d_measured: Any, d_before: Any, d_motors: Any,
) -> None:  # fmt: skip
    """Adjoint of `fly`: carry d_x, d_rotors and d_measured from the end of the period to its start, in place.

    Adds to d_before and d_motors, which may be the same. `slopes` (3, LANES) are the derivatives of the loss with
    respect to half the sums of squared travel and elevation errors, and to cost and penalty.
    """
    s = settings_of(settings)
    for i in range(LANES):
        on = alive[i]
        # loss at the end of the period
        q3 = next_x[4, i]
        over = max(abs(q3) - SAFE_PITCH, 0.0)
        weight = s.period * slopes[2, i]
        on_pitch = s.cost_weight * excess_slope(q3, s.pitch_min, s.pitch_max)
        on_pitch += 2.0 * s.pitch_penalty * (over if q3 > 0.0 else -over)
        # rate filter
        gain = (1.0 - s.rate_decay) / s.period
        d1 = d_measured[0, i] + gain * d_measured[1, i]
        d2 = d_measured[2, i] + gain * d_measured[3, i]
        d3 = d_measured[4, i] + gain * d_measured[5, i]
        d = (
            on * (d_x[0, i] + d1 + slopes[0, i] * (next_x[0, i] - x_ref[0])),
            on * d_x[1, i],
            on * (d_x[2, i] + d2 + slopes[1, i] * (next_x[2, i] - x_ref[2])),
            on * d_x[3, i],
            on * (d_x[4, i] + d3 + weight * on_pitch),
            on * d_x[5, i],
        )
        for axis in range(3):
            rate = d_measured[2 * axis + 1, i]
            d_measured[2 * axis, i] = -on * gain * rate
            d_measured[2 * axis + 1, i] = on * s.rate_decay * rate

        p = parameters_of(body, i)
        w, u0, u1 = (rotors[0, i], rotors[1, i]), (before[0, i], before[1, i]), (motors[0, i], motors[1, i])
        step0, step1 = first_step(s, body, i), second_step(s, body, i)
        middle = fly_part(six(x, i), w, u0, step0, body, i, p)
        d_w = on * d_rotors[0, i], on * d_rotors[1, i]
        second = fly_part_adjoint(middle[0], middle[1], u1, step1, body, i, p, d, d_w)
        first = fly_part_adjoint(six(x, i), w, u0, step0, body, i, p, second[0], second[1])
        d, d_w = first[0], first[1]
        d_rotors[0, i], d_rotors[1, i] = d_w
        d_motors[0, i] += second[2][0]
        d_motors[1, i] += second[2][1]
        d_before[0, i] += first[2][0]
        d_before[1, i] += first[2][1]
        d_x[0, i], d_x[1, i], d_x[2, i], d_x[3, i], d_x[4, i], d_x[5, i] = d


def command_adjoint(settings: Any, base: Any, action: Any, alive: Any, u: Any, weight: Any, d_u: Any, d_action: Any,
                    d_base: Any) -> None:  # fmt: skip
    """Write d_action and d_base from d_u, the loss's derivative by the commanded voltages; the cost is added here."""
    s = settings_of(settings)
    for motor in range(2):
        for i in range(LANES):
            beyond = alive[i] * weight[i] * s.period * s.cost_weight * excess_slope(u[motor, i], s.u_min, s.u_max)
            d = d_u[motor, i] + beyond
            whole = clip(base[motor, i], s.base_low, s.base_high) + s.scale * action[motor, i]
            d *= inside(whole, s.u_low, s.u_high)
            d_action[motor, i] = s.scale * d
            d_base[motor, i] = d * inside(base[motor, i], s.base_low, s.base_high)


# Elementwise part of the GRU cell.


def tanh(x: Any) -> Any:
    """Hyperbolic tangent in single precision, accurate to 4e-7: branch-free rational minimax approximation of Eigen."""
    x = min(max(x, -9.0), 9.0)
    y = x * x
    p = -2.76076847742355e-16 * y + 2.00018790482477e-13
    p = ((((p * y - 8.60467152213735e-11) * y + 5.12229709037114e-08) * y + 1.48572235717979e-05) * y
         + 6.37261928875436e-04) * y + 4.89352455891786e-03  # fmt: skip
    q = ((1.19825839466702e-06 * y + 1.18534705686654e-04) * y + 2.26843463243900e-03) * y + 4.89352518554385e-03
    return x * p / q


def sigmoid(x: Any) -> Any:
    """Logistic function 1 / (1 + exp(-x))."""
    return 0.5 + 0.5 * tanh(0.5 * x)


def gru(from_input: Any, from_hidden: Any, bias: Any, hidden_bias: Any, hidden: Any, gates: Any, result: Any) -> None:
    """Write the next hidden state (H, LANES) and the gates (4H, LANES): reset, update, new, hidden part of new.

    The inputs are the products (3H, LANES) of the matrices with features and hidden state.
    """
    n = len(hidden)
    for j in range(n):
        b_r, b_z = bias[j] + hidden_bias[j], bias[n + j] + hidden_bias[n + j]
        b_n, b_h = bias[2 * n + j], hidden_bias[2 * n + j]
        for i in range(LANES):
            r = sigmoid(from_input[j, i] + from_hidden[j, i] + b_r)
            z = sigmoid(from_input[n + j, i] + from_hidden[n + j, i] + b_z)
            from_old = from_hidden[2 * n + j, i] + b_h
            new = tanh(from_input[2 * n + j, i] + b_n + r * from_old)
            gates[j, i], gates[n + j, i], gates[2 * n + j, i], gates[3 * n + j, i] = r, z, new, from_old
            result[j, i] = new + z * (hidden[j, i] - new)


def gru_adjoint(gates: Any, hidden: Any, d_result: Any, d_input: Any, d_hidden_product: Any) -> None:
    """Adjoint of `gru`: write the derivatives by both products; leave the direct derivative by `hidden` in d_result."""
    n = len(hidden)
    for j in range(n):
        for i in range(LANES):
            r, z, new, from_old = gates[j, i], gates[n + j, i], gates[2 * n + j, i], gates[3 * n + j, i]
            d = d_result[j, i]
            d_new = d * (1.0 - z) * (1.0 - new * new)
            d_z = d * (hidden[j, i] - new) * z * (1.0 - z)
            d_r = d_new * from_old * r * (1.0 - r)
            d_input[j, i], d_input[n + j, i], d_input[2 * n + j, i] = d_r, d_z, d_new
            d_hidden_product[j, i], d_hidden_product[n + j, i] = d_r, d_z
            d_hidden_product[2 * n + j, i] = d_new * r
            d_result[j, i] = d * z


class Kernels(NamedTuple):
    """Compiled functions of a flight and its adjoint."""

    observe: Callable
    observe_adjoint: Callable
    fly: Callable
    fly_adjoint: Callable
    command_adjoint: Callable
    gru: Callable
    gru_adjoint: Callable


VARIANTS: dict[int, dict[str, Callable]] = {
    NUMBERS + COEFFICIENTS: {},
    NUMBERS + RIGID: {
        "parameters_of": rigid_parameters_of,
        "derivative": rigid_derivative,
        "derivative_adjoint": rigid_derivative_adjoint,
    },
    FLEET: {
        "parameters_of": fleet_parameters_of,
        "derivative": fleet_derivative,
        "derivative_adjoint": fleet_derivative_adjoint,
        "thrusts": fleet_thrusts,
        "slopes_of": fleet_slopes,
        "first_step": fleet_first_step,
        "second_step": fleet_second_step,
        "zero_of": fleet_zero_of,
        "base_voltage": power_base_voltage,
        "base_voltage_slope": power_base_voltage_slope,
    },
}


@cache
def kernels(dtype: type, rows: int) -> Kernels:
    """Compile the flight in double precision, for helicopters with that number of rows, and the network in a dtype."""
    double = Compiler(np.float64, {"sin": fast_math.sine, "cos": fast_math.cosine, **VARIANTS[rows]})
    flight = map(double.entry, (observe, observe_adjoint, fly, fly_adjoint, command_adjoint))
    return Kernels(*flight, *map(Compiler(dtype).entry, (gru, gru_adjoint)))


class Rollout:
    """Flights of a batch, forwards and backwards, with their working arrays.

    Args:
        task: common data of all flights; another task of at most as many control periods may replace it.
        hidden: number H of hidden states.
        dtype: precision of the network.
    """

    def __init__(self, task: Task, hidden: int, dtype: type = np.float32) -> None:
        T, n = len(task.v_ref), hidden
        self.task, self.hidden, self.dtype = task, n, dtype

        def double(*shape: int) -> np.ndarray:
            return np.zeros((*shape, LANES))

        def single(*shape: int) -> np.ndarray:
            return np.zeros((*shape, LANES), dtype)

        self.x, self.rotors, self.measured, self.alive = (
            double(T + 1, 6),
            double(T + 1, 2),
            double(T + 1, 6),
            double(T + 1),
        )
        self.u = double(T + task.delay, 2)  # command in period t: u[t + delay]
        self.base, self.features, self.action = double(T, 2), single(T, N_FLIGHT_FEATURES), single(T + 1, 2)
        self.h, self.gates = single(T + 1, n), single(T, 4 * n)
        self.from_hidden, self.from_input, self.output = single(3 * n), single(3 * n), single(2)

    def kernels(self, batch: Batch) -> Kernels:
        """Compiled functions for the helicopters of a batch."""
        return kernels(self.dtype, len(batch.body))

    def arrivals(self, t: int) -> tuple[Any, Any]:
        """Indices of the commanded voltages that the motors have in the first and in the second part of a period."""
        if self.batch.delay is None:
            return t, t
        rows = t + self.task.delay - self.batch.delay
        motors = np.array([[0], [1]])
        return (rows - 1, motors, np.arange(LANES)), (rows, motors, np.arange(LANES))

    def commands(self, t: int) -> np.ndarray:
        """Commanded voltages (2, LANES) of a control period."""
        s = self.task.settings
        whole = np.clip(self.base[t], s.base_low, s.base_high) + s.scale * self.action[t + 1].astype(float)
        return np.clip(whole, s.u_low, s.u_high)

    def drift(self, t: int) -> None:
        """Set the share of the thrust that is left in a control period."""
        if self.batch.drift is not None:
            self.batch.body[EFFECT] = 1.0 - self.batch.drift * (t + 0.5) * self.task.settings.period

    def forward(self, weights: Weights, batch: Batch) -> Outcome:
        """Fly the batch."""
        k, task, s = self.kernels(batch), self.task, self.task.settings
        settings = np.array(s)
        T, delay = len(task.v_ref), task.delay
        self.batch, self.weights = batch, weights
        self.x[0], self.measured[0], self.rotors[0], self.alive[0] = batch.x, batch.measured, batch.u, 1.0
        self.u[:delay] = batch.u
        self.h[0] = 0.0 if batch.hidden is None else batch.hidden
        bias = task.preview @ weights.preview.T + weights.input_bias
        sums = np.zeros((4, LANES))
        for t in range(T):
            k.observe(
                self.measured[t], task.x_ref[t], task.v_ref[t], task.gains[t], settings, self.action[t], self.base[t],
                self.features[t],
            )  # fmt: skip
            np.matmul(weights.hidden, self.h[t], out=self.from_hidden)
            np.matmul(weights.seen, self.features[t], out=self.from_input)
            k.gru(
                self.from_input, self.from_hidden, bias[t], weights.hidden_bias, self.h[t], self.gates[t], self.h[t + 1]
            )
            np.matmul(weights.output, self.h[t + 1], out=self.output)
            self.output += weights.output_bias[:, None]
            np.tanh(self.output, out=self.action[t + 1])
            if batch.delay is not None:  # may be less than a period
                self.u[t + delay] = self.commands(t)
            before, motors = (self.u[where] for where in self.arrivals(t))
            self.drift(t)
            k.fly(
                settings, batch.body, self.x[t], self.rotors[t], before, motors, self.measured[t], self.base[t],
                self.action[t + 1], self.alive[t], task.x_ref[t + 1], self.u[t + delay], self.x[t + 1],
                self.rotors[t + 1], self.measured[t + 1], self.alive[t + 1], sums,
            )  # fmt: skip
        if task.after_crash:
            _, lanes, left, error, costs, _ = self.crashes()
            sums[:2, lanes] += left * error[[0, 2]] ** 2
            sums[2, lanes] += left * s.period * costs
        travel, elevation = np.degrees(np.sqrt(sums[:2] / T))
        return Outcome(travel, elevation, sums[2], sums[3], 1.0 - self.alive[T])

    def crashes(self) -> tuple[np.ndarray, ...]:
        """Crashes of the last flights: what they cost to the end of the maneuver, by `metrics.crash_cost`.

        Returns the numbers of control periods (n,) flown, the indices (n,) of the flights, the numbers of periods (n,)
        missed, the errors (6, n) at the end, and the costs (n,) per second with their derivatives (n,) by the pitch.
        """
        T, s = len(self.task.v_ref), self.task.settings
        lanes = np.flatnonzero(self.alive[T] == 0.0)
        ends = self.alive[: T + 1, lanes].sum(axis=0).astype(int)
        x = self.x[ends, :, lanes]
        pitch, towards = np.abs(x[:, 4]), np.sign(x[:, 4])
        limit, width = min(s.pitch_max, -s.pitch_min), s.pitch_max - s.pitch_min
        worst = max(excess(s.u_low, s.u_min, s.u_max), excess(s.u_high, s.u_min, s.u_max))
        costs = np.maximum(pitch - limit, 0.0) / width + 2.0 * worst
        return ends, lanes, T - ends, (x - self.task.x_ref[ends]).T, costs, (pitch > limit) * towards / width

    def loss(self, outcome: Outcome) -> float:
        """Mean over the flights of RMS errors in degrees, weighted cost and penalty."""
        s = self.task.settings
        each = outcome.travel_deg + s.elevation_weight * outcome.elevation_deg + s.cost_weight * outcome.cost
        return float((each + outcome.penalty).mean())

    def backward(self, outcome: Outcome) -> Weights:
        """Gradient of `loss` for the flights of the last `forward`; that by their first hidden states is `d_hidden`."""
        task, s, w, batch = self.task, self.task.settings, self.weights, self.batch
        k, settings = self.kernels(batch), np.array(s)
        T, n, delay = len(task.v_ref), self.hidden, task.delay
        squares = np.radians(1.0) ** 2 * T * LANES  # d rms / d (sum / 2), rms in degrees
        slopes = np.stack(
            (
                1.0 / (squares * np.maximum(outcome.travel_deg, 0.02)),
                s.elevation_weight / (squares * np.maximum(outcome.elevation_deg, 0.02)),
                np.full(LANES, 1.0 / LANES),
            )
        )
        d_x, d_rotors, d_measured = np.zeros((6, LANES)), np.zeros((2, LANES)), np.zeros((6, LANES))
        d_u, d_base = np.zeros((T + delay, 2, LANES)), np.zeros((2, LANES))
        d_action, d_last = np.zeros((2, LANES)), np.zeros((2, LANES))

        def zeros(*shape: int) -> np.ndarray:
            return np.zeros(shape, self.dtype)

        at_crash = np.zeros((T + 1, 6, LANES)) if task.after_crash else None
        if at_crash is not None:
            ends, lanes, left, error, _, by_pitch = self.crashes()
            at_crash[ends, 0, lanes] = left * slopes[0, lanes] * error[0]
            at_crash[ends, 2, lanes] = left * slopes[1, lanes] * error[2]
            at_crash[ends, 4, lanes] = left * slopes[2, lanes] * s.period * s.cost_weight * by_pitch
        d_h, d_features, d_bias = zeros(n, LANES), zeros(N_FLIGHT_FEATURES, LANES), zeros(T, 3 * n)
        d_input, d_product = zeros(3 * n, LANES), zeros(3 * n, LANES)
        g = Weights(*map(np.zeros_like, w))
        hidden_t, seen_t, output_t = (np.ascontiguousarray(m.T) for m in (w.hidden, w.seen, w.output))
        for t in reversed(range(T)):
            first, second = self.arrivals(t)
            self.drift(t)
            if at_crash is not None:
                d_x += at_crash[t + 1]
            d_before, d_motors = d_u[first], d_u[second]
            k.fly_adjoint(
                settings, batch.body, self.x[t], self.rotors[t], self.u[first], self.u[second], self.alive[t],
                task.x_ref[t + 1], self.x[t + 1], slopes, d_x, d_rotors, d_measured, d_before, d_motors,
            )  # fmt: skip
            if batch.delay is not None:  # otherwise these are views
                d_u[first], d_u[second] = d_before, d_motors
            k.command_adjoint(
                settings, self.base[t], self.action[t + 1], self.alive[t], self.u[t + delay], slopes[2], d_u[t + delay],
                d_action, d_base,
            )  # fmt: skip
            d_output = ((d_action + d_last) * (1.0 - self.action[t + 1] ** 2)).astype(self.dtype)
            g.output[:] += d_output @ self.h[t + 1].T
            g.output_bias[:] += d_output.sum(axis=1)
            d_h += output_t @ d_output
            k.gru_adjoint(self.gates[t], self.h[t], d_h, d_input, d_product)
            g.hidden[:] += d_product @ self.h[t].T
            g.hidden_bias[:] += d_product.sum(axis=1)
            g.seen[:] += d_input @ self.features[t].T
            d_bias[t] = d_input.sum(axis=1)
            d_h += hidden_t @ d_product
            np.matmul(seen_t, d_input, out=d_features)
            k.observe_adjoint(
                task.x_ref[t], task.gains[t], settings, self.measured[t], self.base[t], d_features, d_base, d_measured,
                d_last,
            )  # fmt: skip
        g.preview[:] = d_bias.T @ task.preview
        g.input_bias[:] = d_bias.sum(axis=0)
        self.d_hidden = d_h
        return g
