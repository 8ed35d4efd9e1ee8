"""The normal form is equation (3) in other coordinates; the input bounds are the image of the voltage window."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from independent import TABLE_I, equation_2, equation_3
from numpy.testing import assert_allclose
from scipy.integrate import solve_ivp

from heli_gym import HelicopterParameters, dynamics
from heli_gym.baselines.paper.normal_form import (
    alpha1,
    alpha2,
    arrival_weights,
    ddy1_bounds,
    ddy2_bounds,
    internal_dynamics,
    travel_damping,
    v1_bounds,
    v2_bounds,
)
from heli_gym.model import inverse_dynamics, thrust_vector
from heli_gym.rig import PAPER

NOMINAL = HelicopterParameters()
DAMPED = HelicopterParameters(c1=0.1, c2=0.2, c3=0.5)
WINDOWS = [(1.0, 11.0), (0.0, 12.0), (-4.0, 10.0), (-9.0, -2.0), (3.0, 4.0)]
PITCHES = st.floats(-1.4, 1.4)
ELEVATIONS = st.floats(-1.0, 1.0)
THRUSTS = st.floats(-1.5, 1.5)


def voltage_box(window, points=401):
    """The thrusts (2, points²) in N of all pairs of voltages on a grid over the window."""
    thrusts = np.vectorize(equation_2)(np.linspace(*window, points))
    return np.stack(np.meshgrid(thrusts, thrusts)).reshape(2, -1)


def state(y1, y2):
    """A state with these outputs, and some travel and rates."""
    return 0.3, 0.1, y1, -0.2, y2, 0.4


@given(ELEVATIONS, PITCHES, THRUSTS, THRUSTS)
def test_the_outputs_accelerate_as_equation_3_says(y1, y2, v1, v2):
    x = state(y1, y2)
    _, ddq1, _, ddq2, _, ddq3 = equation_3(x, v1, v2)
    assert_allclose(alpha1(x, v1, NOMINAL), ddq2, rtol=1e-13)
    assert_allclose(alpha2(x, v2, NOMINAL), ddq3, rtol=1e-13)
    assert_allclose(internal_dynamics(x, ddq2, NOMINAL), ddq1, rtol=1e-9, atol=1e-12)


@given(ELEVATIONS, PITCHES, THRUSTS, THRUSTS)
def test_the_inverse_dynamics_invert_the_output_dynamics(y1, y2, v1, v2):
    x = state(y1, y2)
    inverted = inverse_dynamics(x, alpha1(x, v1, DAMPED), alpha2(x, v2, DAMPED), DAMPED)
    assert_allclose(inverted, (v1, v2), rtol=1e-12, atol=1e-13)


@given(ELEVATIONS, PITCHES, THRUSTS, THRUSTS)
def test_the_thrust_vector_inverts_travel_and_elevation(y1, y2, v1, v2):
    x = state(y1, y2)
    _, ddq1, _, ddq2, _, _ = dynamics(x, (v1, v2), DAMPED)
    assert_allclose(
        thrust_vector(x, ddq1, ddq2, DAMPED), (v1 * math.sin(y2), v1 * math.cos(y2)), rtol=1e-11, atol=1e-12
    )


def test_the_travel_damping_is_that_of_3a():
    assert travel_damping(NOMINAL) == 0.0
    assert travel_damping(DAMPED) == pytest.approx(0.1)


@pytest.mark.parametrize("damping", [0.0, 0.3])
def test_an_acceleration_leaves_rate_and_travel_as_scipy_integrates(damping):
    flown = solve_ivp(lambda t, z: [z[1], -damping * z[1]], (0.0, 4.0), [0.0, 1.0], rtol=1e-10, atol=1e-12).y[:, -1]
    rate, travel = arrival_weights(4.0, damping)
    assert_allclose((travel, rate), flown, rtol=1e-8)


@pytest.mark.parametrize("signs", [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0)])
def test_bounds_are_in_order_for_all_signs_of_the_inputs(signs):
    p = NOMINAL._replace(b2=signs[0] * NOMINAL.b2, b3=signs[1] * NOMINAL.b3)
    f = PAPER.thrust_bounds(PAPER.limits.u)
    for low, high in (ddy1_bounds(state(0.1, 0.2), 0.05, f, p), ddy2_bounds(state(0.1, 0.2), f, p)):
        assert low < high


@pytest.mark.parametrize("window", WINDOWS)
def test_the_thrust_bounds_are_the_extremes_over_the_window(window):
    f = voltage_box(window)
    assert_allclose(PAPER.thrust_bounds(window), (f.min(), f.max()), rtol=1e-14)


@pytest.mark.parametrize("window", WINDOWS)
def test_the_bounds_of_the_difference_are_the_extremes_over_the_voltage_box(window):
    f_f, f_b = voltage_box(window)
    bounds = v2_bounds(PAPER.thrust_bounds(window))
    assert_allclose(bounds, ((f_f - f_b).min(), (f_f - f_b).max()), rtol=1e-14)


@pytest.mark.parametrize("window", WINDOWS)
@pytest.mark.parametrize("share", [-0.95, -0.4, 0.0, 0.1, 0.7])
def test_the_bounds_of_the_sum_are_the_extremes_at_a_difference(window, share):
    f = PAPER.thrust_bounds(window)
    v2 = share * v2_bounds(f)[1]
    f_b = np.vectorize(equation_2)(np.linspace(*window, 200001))
    allowed = (f[0] <= f_b + v2) & (f_b + v2 <= f[1])
    sums = (2.0 * f_b + v2)[allowed]
    assert_allclose(v1_bounds(v2, f), (sums.min(), sums.max()), atol=2e-5)


@pytest.mark.parametrize("window", WINDOWS)
@given(share1=st.floats(-0.5, 1.5), share2=st.floats(-1.5, 1.5))
def test_inputs_within_the_bounds_are_exactly_those_that_the_fans_can_thrust(window, share1, share2):
    f = f_min, f_max = PAPER.thrust_bounds(window)
    v1, v2 = 2.0 * (f_min + share1 * (f_max - f_min)), share2 * (f_max - f_min)
    low, high = v2_bounds(f)
    within = low <= v2 <= high and v1_bounds(v2, f)[0] <= v1 <= v1_bounds(v2, f)[1]
    thrusts = 0.5 * (v1 + v2), 0.5 * (v1 - v2)
    if min(abs(each - bound) for each in thrusts for bound in f) > 1e-9:
        assert within == all(f_min <= each <= f_max for each in thrusts)


@pytest.mark.parametrize("window", WINDOWS)
@given(y1=ELEVATIONS, y2=PITCHES, shares=st.tuples(st.floats(0.0, 1.0), st.floats(0.0, 1.0)))
def test_the_accelerations_of_any_voltages_in_the_window_lie_within_the_bounds(window, y1, y2, shares):
    u_min, u_max = window
    f_f, f_b = (equation_2(u_min + share * (u_max - u_min)) for share in shares)
    _, _, _, ddy1, _, ddy2 = equation_3([0.0, 0.0, y1, 0.0, y2, 0.0], f_f + f_b, f_f - f_b)
    f = PAPER.thrust_bounds(window)
    for value, (low, high) in (
        (ddy1, ddy1_bounds(state(y1, y2), f_f - f_b, f, NOMINAL)),
        (ddy2, ddy2_bounds(state(y1, y2), f, NOMINAL)),
    ):
        assert low - 1e-12 <= value <= high + 1e-12


@pytest.mark.parametrize("window", WINDOWS)
def test_the_bounds_of_the_pitch_acceleration_are_the_extremes_over_the_voltage_box(window):
    y1, y2, p = 0.2, -0.6, TABLE_I
    f_f, f_b = voltage_box(window)
    ddy2 = p.a3 * np.cos(y1) * np.sin(y2) + p.b3 * (f_f - f_b)
    bounds = ddy2_bounds(state(y1, y2), PAPER.thrust_bounds(window), NOMINAL)
    assert_allclose(bounds, (ddy2.min(), ddy2.max()), rtol=1e-13)


def test_everything_broadcasts():
    y1, y2, v2 = np.random.default_rng(4).uniform(-0.4, 0.4, (3, 7))
    f = PAPER.thrust_bounds(PAPER.limits.u)
    batch = np.stack(ddy1_bounds(state(y1, y2), v2, f, NOMINAL) + ddy2_bounds(state(y1, y2), f, NOMINAL))
    for n in range(7):
        member = ddy1_bounds(state(y1[n], y2[n]), v2[n], f, NOMINAL) + ddy2_bounds(state(y1[n], y2[n]), f, NOMINAL)
        assert_allclose(batch[:, n], member, rtol=1e-15)
