"""Observation, reward, cost, termination and success: pure functions, checked by their definitions."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from independent import hover, inputs
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym import HelicopterParameters, Limits, Trajectory, task
from heli_gym.env import REFERENCES, Heli3DOFEnv, find_reference
from heli_gym.model import dynamics
from heli_gym.plant import Gust, MovingMass, Plant, Push, Uniform

LIMITS = Limits(u_min=2.0, u_max=10.0, pitch_min=-0.4, pitch_max=0.6)
PARAMETERS = HelicopterParameters()
REFERENCE = find_reference("travel-360")

angles = st.floats(-4.0, 4.0)
errors = arrays(float, 6, elements=angles)
volts = arrays(float, 2, elements=st.floats(-12.0, 12.0))
windows = st.tuples(st.floats(-12.0, 5.0), st.floats(6.0, 24.0))


# Every function broadcasts: a batch is its members, arrays are floats

BROADCASTING = {
    "to_voltage": (lambda x, u: task.to_voltage(u, (0.0, 15.0), 8.0), 2),
    "to_action": (lambda x, u: task.to_action(u, (0.0, 15.0), 8.0), 2),
    "reward": (lambda x, u: task.reward(x, u, 12.0), 0),
    "cost": (lambda x, u: task.cost(x[4], u, LIMITS), 0),
    "crashed": (lambda x, u: task.crashed(x[4], 1.4), 0),
    "succeeded": (lambda x, u: task.succeeded(0.05 * x), 0),
}


@pytest.mark.parametrize("name", BROADCASTING)
def test_a_batch_is_its_members(name):
    function, components = BROADCASTING[name]
    rng = np.random.default_rng(0)
    x, u = rng.uniform(-2.0, 2.0, (6, 3, 50)), rng.uniform(-2.0, 14.0, (2, 3, 50))
    batch = np.asarray(function(x, u))
    assert batch.shape == ((2, 3, 50) if components else (3, 50))
    assert len(np.unique(batch)) > 1
    for i, j in np.ndindex(3, 50):
        assert_array_equal(batch[..., i, j], function(x[:, i, j], u[:, i, j]))


@pytest.mark.parametrize("name", ["reward", "cost", "crashed", "succeeded"])
@given(errors, volts)
def test_lists_of_floats_give_the_same_as_arrays(name, x, u):
    functions = {
        "reward": lambda x, u: task.reward(x, u, 12.0),
        "cost": lambda x, u: task.cost(x[4], u, LIMITS),
        "crashed": lambda x, u: task.crashed(x[4], 1.4),
        "succeeded": lambda x, u: task.succeeded(x),
    }
    assert_array_equal(functions[name](x, u), functions[name](x.tolist(), u.tolist()))


# Actions


@given(st.floats(-3.0, 3.0), windows, st.floats(0.05, 0.95))
def test_to_action_inverts_to_voltage(action, limits, share):
    hover = limits[0] + share * (limits[1] - limits[0])
    assert_allclose(task.to_action(task.to_voltage(action, limits, hover), limits, hover), action, atol=1e-12)


@given(windows, st.floats(0.05, 0.95))
def test_actions_of_one_are_the_limits_and_zero_is_hover(limits, share):
    hover = limits[0] + share * (limits[1] - limits[0])
    assert_allclose([task.to_voltage(action, limits, hover) for action in (-1.0, 1.0)], limits, atol=1e-13)
    assert task.to_voltage(0.0, limits, hover) == hover


@given(windows, st.floats(0.05, 0.95), st.floats(-1.0, 1.0))
def test_the_voltage_is_linear_on_either_side_of_hover(limits, share, action):
    hover = limits[0] + share * (limits[1] - limits[0])
    expected = np.interp(action, (-1.0, 0.0, 1.0), (limits[0], hover, limits[1]))
    assert_allclose(task.to_voltage(action, limits, hover), expected, atol=1e-13)


def test_hover_is_where_equation_3_rests_with_a_level_arm():
    u = task.hover_voltage(PARAMETERS, (0.0, 12.0))
    assert_allclose(dynamics(np.zeros(6), inputs(u), PARAMETERS), 0.0, atol=1e-12)
    for limits in ((0.0, 7.9), (8.0, 12.0), (0.0, 6.0)):  # no room on one side of it, or hover is not within
        assert_array_equal(task.hover_voltage(PARAMETERS, limits), np.mean(limits))
    assert_array_equal(task.hover_voltage(PARAMETERS._replace(b2=0.0), (0.0, 12.0)), 6.0)


@given(errors, volts)
def test_a_reward_is_positive_and_at_most_one(error, du):
    assert 0.0 < task.reward(error, du, 12.0) <= 1.0


def test_a_reward_is_one_on_the_reference_and_a_half_at_the_tolerance_of_any_one_error():
    for low, high in ((0.0, 12.0), (-24.0, 24.0)):
        assert task.reward(np.zeros(6), np.zeros(2), high - low) == 1.0
        half = 0.5 * (high - low)
        for one in np.diag([*np.radians([3.0, 6.0, 3.0, 6.0, 6.0, 30.0]), half, half]):
            assert task.reward(one[:6], one[6:], high - low) == pytest.approx(0.5)
            assert task.reward(-one[:6], -one[6:], high - low) == pytest.approx(0.5)


@given(errors, volts, st.integers(0, 7), st.floats(1.01, 5.0))
def test_a_greater_error_is_never_rewarded_more(error, du, k, factor):
    z = np.concatenate((error, du))
    greater = z.copy()
    greater[k] *= factor
    before, after = (task.reward(values[:6], values[6:], 12.0) for values in (z, greater))
    assert after <= before
    assert after < before or abs(z[k]) < 1e-6


# Cost


@given(st.floats(-1.4, 1.4), volts)
def test_the_cost_is_the_excess_over_the_limits_in_their_widths(pitch, u):
    windows = (pitch, -0.4, 0.6), (u[0], 2.0, 10.0), (u[1], 2.0, 10.0)
    excess = [max(low - value, value - high, 0.0) / (high - low) for value, low, high in windows]
    assert task.cost(pitch, u, LIMITS) == pytest.approx(sum(excess), abs=1e-15)


@pytest.mark.parametrize(("pitch", "u_f", "u_b"), [*itertools.product([-0.4, 0.1, 0.6], [2.0, 6.0, 10.0], [2.0, 10.0])])
def test_the_cost_is_zero_up_to_the_limits_and_positive_beyond(pitch, u_f, u_b):
    assert task.cost(pitch, (u_f, u_b), LIMITS) == pytest.approx(0.0, abs=1e-15)
    for outside in ((-0.401, u_f, u_b), (0.601, u_f, u_b), (pitch, 1.99, u_b), (pitch, u_f, 10.01)):
        assert task.cost(outside[0], outside[1:], LIMITS) > 1e-4


# The end


@given(st.floats(-3.0, 3.0), st.floats(0.1, 1.5))
def test_a_flight_has_crashed_beyond_the_pitch_limit_on_either_side(pitch, limit):
    assert task.crashed(pitch, limit) == (pitch > limit or pitch < -limit)
    assert not task.crashed(limit, limit)
    assert not task.crashed(-limit, limit)


def test_success_takes_every_error_within_its_tolerance():
    tolerances = np.radians([3.0, 6.0, 3.0, 6.0, 6.0, 30.0])
    assert task.succeeded(tolerances * (1.0 - 1e-12))
    for k, sign in itertools.product(range(6), (-1.0, 1.0)):
        error = np.zeros(6)
        error[k] = sign * 1.001 * tolerances[k]
        assert not task.succeeded(error)


# The control grid


@pytest.mark.parametrize(
    ("duration", "control_period", "steps"),
    [(10.0, 0.001, 10000), (10.0, 0.005, 2000), (10.0, 0.02, 500), (10.0, 0.03, 334), (9.99, 0.03, 333),
     (0.05, 0.05, 1), (0.01, 0.02, 1), (0.3, 0.1, 3), (0.7, 0.1, 7), (10.001, 0.02, 501)],
)  # fmt: skip
def test_a_maneuver_takes_as_many_steps_as_cover_it(duration, control_period, steps):
    assert task.control_steps(duration, control_period) == steps


@given(st.integers(1, 20000), st.sampled_from([0.001, 0.002, 0.005, 0.01, 0.02, 0.03, 0.05, 1 / 60, 0.0070001]))
def test_a_multiple_of_the_control_period_takes_no_extra_step(steps, control_period):
    assert task.control_steps(steps * control_period, control_period) == steps


@given(st.floats(0.05, 60.0), st.floats(0.001, 0.05))
def test_the_last_step_reaches_the_end_and_the_one_before_does_not(duration, control_period):
    steps = task.control_steps(duration, control_period)
    assert steps * control_period >= duration * (1.0 - 1e-8)
    assert (steps - 1) * control_period < duration


def test_the_grid_has_states_at_the_start_of_each_period_and_voltages_in_its_middle():
    t = np.linspace(0.0, 1.0, 11)
    x = np.outer([1.0, 1.0, 2.0, 2.0, -3.0, -3.0], t)
    x[1::2] = x[1::2, 10:]  # constant rates
    reference = Trajectory(t, x, np.outer([4.0, -8.0], t))
    states, voltages = task.control_grid(reference, 0.04)
    assert_allclose(states[0::2], np.outer([1.0, 2.0, -3.0], 0.04 * np.arange(26)), atol=1e-12)
    assert_allclose(voltages[:, :25], np.outer([4.0, -8.0], 0.04 * np.arange(25) + 0.02), atol=1e-12)
    early, early_voltages = task.control_grid(reference, 0.04, ahead=0.4)
    assert_allclose(early[:, :16], states[:, 10:], atol=1e-12)
    assert_allclose(early_voltages[:, :16], voltages[:, 10:], atol=1e-12)
    assert_allclose(early[:, 16:], np.repeat(x[:, -1:], 10, axis=1), atol=1e-12)  # the end is held


def test_the_features_are_the_reference_at_each_preview_in_its_units_and_the_remaining_time():
    table = task.reference_table(REFERENCE, 0.03)
    assert table.shape == (48, 335)
    x, u = task.control_grid(REFERENCE, 0.03)
    assert_array_equal(table[:8], np.concatenate((x, u)))
    units = np.array([1.0, 1.0, 0.25, 0.5, 0.5, 2.0])[:, None]
    shown = [table[8:15], *table[15:47].reshape(4, 8, 335)]
    for part, ahead in zip(shown, (0.0, 0.1, 0.2, 0.4, 0.8)):
        states, voltages = task.control_grid(REFERENCE, 0.03, ahead)
        assert_allclose(part[-7:-2], states[1:] / units[1:], atol=1e-12)
        assert_allclose(part[-2:], voltages / 6.0 - 1.0, atol=1e-12)
        if ahead:
            assert_allclose(part[0], states[0] - x[0], atol=1e-12)
    assert_allclose(table[47, :-1], 1.0 - 0.003 * np.arange(334), atol=1e-12)
    assert table[47, -1] == 0.0  # the last period outlasts the maneuver


def test_the_features_of_long_and_steep_references_saturate():
    t = np.linspace(0.0, 500.0, 51)
    steep = Trajectory(t, 1e3 * np.ones((6, 1)) * t, np.full((2, 51), 500.0))
    features = task.reference_table(steep, 0.05)[8:]
    assert np.abs(features).max() == features[-1, 0] == 10.0
    assert features[-1, -1] == 0.0


def test_the_features_of_the_packaged_references_are_of_order_one():
    for path in REFERENCES.glob("*.npz"):
        features = task.reference_table(find_reference(path.stem), 0.02)[8:]
        assert 0.4 < np.abs(features).max() < 3.0


def test_every_entry_of_the_observation_has_a_width():
    low, high = task.observation_bounds()
    assert low.shape == high.shape == (task.OBSERVED,)
    assert (low < high).all()


HOVER = hover(2.0)
STRONG = (
    Push("travel", 20.0, 0.0, 10.0),
    Push("elevation", Uniform(-50.0, 3.0), -1.0, np.inf),
    Push("pitch", 50.0, 0.1, 1.0),
    Gust("travel", 200.0, 1.0),
    MovingMass(-50.0, -5.0),
)


@pytest.mark.parametrize("disturbances", [*((one,) for one in STRONG), STRONG], ids=[*map(repr, STRONG), "all"])
def test_no_push_gust_or_moving_mass_takes_a_flight_out_of_the_observation_space(disturbances):
    env = Heli3DOFEnv("nominal", HOVER, pitch_limit=1.3)
    for action in ([-1.0, -1.0], [1.0, 1.0], [0.0, 0.0]):
        env.reset(seed=0, options={"plant": Plant(disturbances=disturbances)})
        over = False
        while not over:
            observation, _, terminated, truncated, _ = env.step(np.array(action, np.float32))
            over = terminated or truncated
            assert observation in env.observation_space
