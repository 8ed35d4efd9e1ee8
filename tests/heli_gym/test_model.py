"""Equations (2)-(4), their linearisation and their integration, against other derivations and integrators."""

import math

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from independent import TABLE_I, central_differences, equation_2, equation_3, inputs, jacobians
from numpy.testing import assert_allclose, assert_array_equal
from scipy.integrate import solve_ivp

from heli_gym import HelicopterParameters, dynamics, linearise, thrust, voltage
from heli_gym.model import fan_thrusts, hover_input, rk4_step, virtual_input

NOMINAL = HelicopterParameters()
RNG = np.random.default_rng(1)
STATES = RNG.uniform(-1.0, 1.0, (6, 40)) * np.array([[10.0], [2.0], [0.5], [1.0], [1.3], [3.0]])
INPUTS = RNG.uniform(-1.0, 1.0, (2, 40)) * np.array([[1.4], [0.7]])
FLIGHTS = list(zip(STATES.T, INPUTS.T))


@given(st.floats(-15.0, 15.0))
def test_thrust_is_the_quadratic_of_the_voltages_sign(u):
    assert_allclose(thrust(u), equation_2(u), rtol=1e-14)


@given(st.floats(-15.0, 15.0), st.floats(-15.0, 15.0))
def test_more_voltage_is_never_less_thrust(u, w):
    assert (thrust(u) <= thrust(w)) == (u <= w) or math.isclose(u, w, abs_tol=1e-7)


@given(st.floats(-15.0, 15.0))
def test_voltage_inverts_thrust(u):
    assert_allclose(voltage(thrust(u)), u, rtol=1e-12, atol=1e-150)


@given(st.floats(-0.4, 0.8))
def test_thrust_inverts_voltage(f):
    assert_allclose(thrust(voltage(f)), f, rtol=1e-12, atol=1e-300)


def test_no_thrust_takes_no_voltage():
    assert_array_equal(voltage([0.0, -0.0]), 0.0)


def test_the_thrust_map_belongs_to_its_parameters():
    stronger = NOMINAL._replace(k_plus=2.0 * NOMINAL.k_plus)
    assert_allclose(thrust(np.array([-3.0, 3.0]), stronger), [thrust(-3.0), 2.0 * thrust(3.0)])
    assert_allclose(voltage(thrust(np.array([-3.0, 3.0]), stronger), stronger), [-3.0, 3.0])


@given(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
def test_fan_thrusts_inverts_virtual_input(f_f, f_b):
    v1, v2 = virtual_input(np.array([f_f, f_b]))
    assert_allclose((v1, v2), (f_f + f_b, f_f - f_b))
    assert_allclose(fan_thrusts((v1, v2)), (f_f, f_b), rtol=1e-14, atol=1e-15)


@pytest.mark.parametrize(("x", "v"), FLIGHTS[:10])
def test_dynamics_is_equation_3(x, v):
    assert_allclose(dynamics(x, v, NOMINAL), equation_3(x, *v), rtol=1e-14)


def test_dynamics_of_a_batch_is_that_of_its_members():
    batch = np.stack(dynamics(STATES, INPUTS, NOMINAL))
    assert batch.shape == STATES.shape
    assert_array_equal(batch, np.stack([dynamics(x, v, NOMINAL) for x, v in FLIGHTS], axis=1))


def test_parameters_that_are_arrays_describe_as_many_helicopters():
    x, v = FLIGHTS[0]
    b1, b3 = RNG.uniform(0.8, 1.2, (2, 5)) * np.array([[NOMINAL.b1], [NOMINAL.b3]])
    fleet = NOMINAL._replace(b1=b1, b3=b3)
    members = [NOMINAL._replace(b1=b1[n], b3=b3[n]) for n in range(5)]
    derivative = np.stack(np.broadcast_arrays(*dynamics(x, v, fleet)))
    assert_array_equal(derivative, np.stack([dynamics(x, v, member) for member in members], axis=1))
    for jacobian, of_members in zip(linearise(x, v, fleet), zip(*(linearise(x, v, member) for member in members))):
        assert_array_equal(jacobian, np.stack(of_members, axis=-1))


def test_dynamics_runs_on_python_floats():
    x, v = FLIGHTS[0]
    derivative = dynamics(x.tolist(), v.tolist(), NOMINAL, math.sin, math.cos)
    assert all(type(value) is float for value in derivative)
    assert_allclose(derivative, equation_3(x, *v), rtol=1e-14)


def casadi_dynamics() -> tuple[ca.Function, ca.Function]:
    x, v = ca.SX.sym("x", 6), ca.SX.sym("v", 2)
    f = ca.vertcat(*dynamics(ca.vertsplit(x), ca.vertsplit(v), NOMINAL, ca.sin, ca.cos))
    return ca.Function("f", [x, v], [f]), ca.Function("J", [x, v], [ca.jacobian(f, x), ca.jacobian(f, v)])


def test_casadi_runs_and_differentiates_the_dynamics_unchanged():
    f, jacobian = casadi_dynamics()
    for x, v in FLIGHTS:
        assert_allclose(f(x, v).full()[:, 0], dynamics(x, v, NOMINAL), rtol=1e-13, atol=1e-15)
        for of_casadi, ours in zip(jacobian(x, v), linearise(x, v, NOMINAL)):
            assert_allclose(of_casadi.full(), ours, rtol=1e-13, atol=1e-15)


def test_linearise_agrees_with_the_symbolic_derivatives():
    for x, v in FLIGHTS:
        for ours, symbolic in zip(linearise(x, v, NOMINAL), jacobians(x, v)):
            assert_allclose(ours, symbolic, rtol=1e-13, atol=1e-15)


def test_linearise_agrees_with_central_differences():
    for x, v in FLIGHTS:
        A, B = linearise(x, v, NOMINAL)
        numeric = central_differences(lambda z: np.array(dynamics(z[:6], z[6:], NOMINAL)), np.concatenate((x, v)))
        assert_allclose(np.hstack((A, B)), numeric, atol=1e-8)


def test_linearisation_of_a_batch_is_that_of_its_members():
    A, B = linearise(STATES, INPUTS, NOMINAL)
    assert A.shape == (6, 6, 40)
    assert B.shape == (6, 2, 40)
    for n, (x, v) in enumerate(FLIGHTS):
        of_one = linearise(x, v, NOMINAL)
        assert_allclose(A[..., n], of_one[0], rtol=1e-15)
        assert_allclose(B[..., n], of_one[1], rtol=1e-15)


def test_linearise_leaves_its_arguments_alone():
    x, v = np.ones(6), np.ones(2)
    linearise(x, v, NOMINAL)
    assert_array_equal(x, 1.0)
    assert_array_equal(v, 1.0)


@given(st.floats(-100.0, 100.0), st.floats(-1.5, 1.5))
def test_hover_is_an_equilibrium(travel, elevation):
    rest = [travel, 0.0, elevation, 0.0, 0.0, 0.0]
    assert_allclose(equation_3(rest, *hover_input(elevation, NOMINAL)), 0.0, atol=1e-15)


def test_hover_of_a_batch_is_that_of_its_members():
    elevations = np.linspace(-0.3, 0.3, 5)
    assert_array_equal(
        hover_input(elevations, NOMINAL), np.stack([hover_input(q2, NOMINAL) for q2 in elevations], axis=1)
    )


@pytest.mark.parametrize(("x", "v"), FLIGHTS[:10])
def test_the_mirrored_helicopter_flies_the_mirrored_flight(x, v):
    mirror = np.array([-1.0, -1.0, 1.0, 1.0, -1.0, -1.0])
    assert_allclose(dynamics(mirror * x, v * [1.0, -1.0], NOMINAL), mirror * dynamics(x, v, NOMINAL), rtol=1e-14)


@pytest.mark.parametrize(("x", "v"), FLIGHTS[:10])
def test_the_travel_angle_does_not_matter(x, v):
    assert_array_equal(dynamics([x[0] + 5.0, *x[1:]], v, NOMINAL), dynamics(x, v, NOMINAL))


def step(x, v, dt):
    """One Runge-Kutta step through (3) under a constant v."""
    return np.array(rk4_step(lambda z, held: dynamics(z, held, NOMINAL), x, (v, v, v), dt))


def exact(x, v, duration):
    flight = solve_ivp(
        lambda t, x: equation_3(x, *v), (0.0, duration), x, "DOP853", rtol=1e-13, atol=1e-14, max_step=0.05
    )
    return flight.y[:, -1]


def flown(x, v, duration, steps):
    for _ in range(steps):
        x = step(x, v, duration / steps)
    return np.array(x)


@pytest.mark.parametrize(("x", "v"), FLIGHTS[:5])
def test_rk4_converges_with_order_four(x, v):
    errors = [np.abs(flown(x, v, 1.0, steps) - exact(x, v, 1.0)).max() for steps in (10, 20, 40)]
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    assert_allclose(orders, 4.0, atol=0.4)


def test_rk4_over_20_ms_at_the_amplifiers_limits_is_accurate_to_1e_9():
    for x in STATES.T:
        for u in ([0.0, 12.0], [12.0, 0.0], [12.0, 12.0]):
            v = inputs(np.array(u))
            assert_allclose(step(x, v, 0.02), exact(x, v, 0.02), rtol=0.0, atol=1e-9)


def test_rk4_of_a_batch_is_that_of_its_members():
    batch = np.stack(step(STATES, INPUTS, 0.02))
    assert_array_equal(batch, np.stack([step(x, v, 0.02) for x, v in FLIGHTS], axis=1))


def test_rk4_backwards_returns_to_the_start():
    x, v = FLIGHTS[0]
    assert_allclose(step(step(x, v, 0.02), v, -0.02), x, atol=1e-9)


def test_free_fall_settles_around_the_angle_where_the_weights_balance():
    # at rest without thrust (3b) vanishes where tan q2 = -a2 / a1, below the horizon
    balance = math.atan(-TABLE_I.a2 / TABLE_I.a1)
    assert_allclose(hover_input(balance, NOMINAL), 0.0, atol=1e-15)
    assert dynamics(np.zeros(6), np.zeros(2), NOMINAL)[3] * balance > 0.0
