"""Model of real rigs against its equations, and its derivatives."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from heli_gym import HelicopterParameters, dynamics
from heli_gym.baselines.identification.measured_model import (
    NAMES,
    MeasuredParameters,
    dual_thrusts,
    measured_dynamics,
    sensitivity_kernel,
    simulation_kernel,
)

NEUTRAL = MeasuredParameters(centrifugal=0.0, pitch_spin=0.0)
NO_OFFSETS = (0j, 0j, 0j)
X = np.random.default_rng(0).uniform(-0.5, 0.5, 6)


def accelerations(x, f, p):
    derivative = measured_dynamics([complex(value) for value in x], [complex(value) for value in f], p, NO_OFFSETS)
    return np.array([value.real for value in derivative])[1::2]


def test_without_effects_it_is_equation_3():
    p = NEUTRAL
    table = HelicopterParameters(0.0, 0.0, p.a1, p.a2, p.a3, p.b1, p.b2, p.b3, p.c1, p.c2, p.c3)
    expected = np.array(dynamics(X, (1.7, 0.3), table))[1::2]
    np.testing.assert_allclose(accelerations(X, (1.0, 0.7), p), expected, rtol=1e-12)


def test_centrifugal_moments_conserve_energy_and_angular_momentum_of_masses_along_the_arm():
    free = NEUTRAL._replace(a1=0.0, a2=0.0, a3=0.0, c1=0.0, c2=0.0, c3=0.0, centrifugal=1.0)

    def derivative(t, x):
        dx = np.array(x)
        dx[0::2], dx[1::2] = x[1::2], accelerations(x, (0.0, 0.0), free)
        return dx

    flight = solve_ivp(derivative, (0.0, 5.0), [0.0, 1.5, 0.3, 0.4, 0.0, 0.0], rtol=1e-9, atol=1e-10)
    _, dq1, q2, dq2, _, _ = flight.y
    energy = 0.5 * (np.cos(q2) ** 2 * dq1**2 + dq2**2)
    np.testing.assert_allclose(energy, energy[0], rtol=1e-6)
    np.testing.assert_allclose(np.cos(q2) ** 2 * dq1, np.cos(q2[0]) ** 2 * dq1[0], rtol=1e-6)


@pytest.mark.parametrize("ratio", [1.0, 0.86, 1.25])
def test_gyroscopic_moments_do_no_work_where_travel_and_elevation_have_the_same_inertia(ratio):
    p = NEUTRAL._replace(a1=0.0, a2=0.0, a3=0.0, c1=0.0, c2=0.0, c3=0.0, b1=ratio * NEUTRAL.b2, gyro=-1.3)
    ddq1, ddq2, ddq3 = accelerations(X, (0.0, 0.0), p)
    assert abs(ddq3) > 0.1
    # inertias of travel and elevation in units of that of pitch
    of_travel, of_elevation = p.b3 / (0.27 * abs(p.b1)), p.b3 / (0.27 * abs(p.b2))
    power = of_travel * X[1] * ddq1 + of_elevation * X[3] * ddq2 + X[5] * ddq3
    left = p.gyro * (1.0 - p.b2 / p.b1) * np.sin(X[4]) * X[1] * X[5]
    assert power == pytest.approx(left, abs=1e-12)
    assert (abs(power) < 1e-12) == (ratio == 1.0)


def test_thrust_is_one_unit_at_the_hover_voltage_after_lag_and_delay():
    p = MeasuredParameters(mismatch=0.0, exponent=1.6, lag=0.08, delay=0.035)
    u = np.full((2, 300), 4.0)
    u[0, :100] = 0.0
    f = dual_thrusts(np.array(p), u, 0.01, 4.0, np.arange(0))[0].real
    assert f[1, -1] == pytest.approx(1.0)
    times = np.arange(601) * 0.005 - 1.0 - 0.035
    expected = np.where(times > 0.0, np.maximum(1.0 - np.exp(-times / 0.08), 0.0) ** 1.6, 0.0)
    np.testing.assert_allclose(f[0], expected, atol=0.01)  # the delay ends within a sample


def test_the_amplifier_limits_and_the_reversed_rotor_gives_less():
    p = MeasuredParameters(voltage_limit=5.0, reverse=0.25, exponent=2.0, delay=0.0)
    f = dual_thrusts(np.array(p), np.array([[9.0] * 200, [-9.0] * 200]), 0.01, 5.0, np.arange(0))[0].real
    np.testing.assert_allclose(f[:, -1], [1.0, -0.25], rtol=1e-8)


def test_simulation_agrees_with_an_adaptive_integrator():
    p = MeasuredParameters(gyro=-1.0, pitch_speed=0.1, centre=0.1, pitch_zero=0.05)
    f = np.ones((2, 401), dtype=complex) * np.array([[1.1], [0.95]])
    y = np.empty((6, 201), dtype=complex)
    z = np.concatenate((X, np.zeros(3))).astype(complex)
    simulation_kernel()(z, f, 0, 0.01, np.array(p, dtype=complex), y)

    def derivative(t, x):
        dx = np.array(x)
        dx[0::2], dx[1::2] = x[1::2], accelerations(x, (1.1, 0.95), p)
        return dx

    expected = solve_ivp(derivative, (0.0, 2.0), X, rtol=1e-10, atol=1e-11).y[:, -1]
    np.testing.assert_allclose(y[:, -1].real, expected, atol=1e-7)


def test_sensitivities_are_the_differences():
    p = np.array(MeasuredParameters(delay=0.033, voltage_limit=4.6, gyro=-1.0))
    t = np.arange(120) * 0.01
    u = 4.0 + np.array([np.sin(7.0 * t), np.cos(5.0 * t)])
    starts, z = np.array([5]), np.concatenate((X, [0.1, -0.1, 0.2]))[None]
    chosen = np.arange(len(NAMES))

    def angles(theta, states, names):
        y, dy = np.empty((1, 3, 101)), np.empty((1, 9 + len(names), 3, 101))
        f = dual_thrusts(theta, u, 0.01, 4.0, names)
        sensitivity_kernel()(states, starts, f, 0.01, theta.astype(complex), names, y, dy)
        return y, dy

    _, dy = angles(p, z, chosen)
    for j in range(9 + len(NAMES)):
        step, pair = 1e-6, []
        for sign in (1.0, -1.0):
            theta, states = p.copy(), z.copy()
            if j < 9:
                states[0, j] += sign * step
            else:
                theta[j - 9] += sign * step
            pair.append(angles(theta, states, np.arange(0))[0])
        largest = max(np.abs(dy[0, j]).max(), 1.0)
        np.testing.assert_allclose(dy[:, j], (pair[0] - pair[1]) / (2.0 * step), atol=2e-6 * largest)
