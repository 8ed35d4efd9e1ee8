"""The controllers: exact on the reference, and what they do off it."""

import functools
import math
import re

import numpy as np
import pytest
from independent import TABLE_I, hover, inputs
from numpy.testing import assert_allclose, assert_array_equal

from baselines import POLICIES, fly, make_policy, riccati_gains
from baselines.metrics import flight_metrics
from heli_gym import HelicopterParameters
from heli_gym.env import Heli3DOFEnv, find_reference

REFERENCE = find_reference("travel-360")
PERIODS = [0.001, 0.005, 0.02]
CORNER = np.radians([5.0, 0.0, -5.0, 0.0, 5.0, 0.0])
SEEDS = range(6)


@functools.cache
def the_papers(control_period: float = 0.02):
    return make_policy("feedforward+tvlqr", REFERENCE, control_period)


@pytest.fixture(scope="module")
def perturbed():
    """Flights at 20 ms from the same starts up to 5 degrees off, by policy."""
    env = Heli3DOFEnv(start_spread_deg=5.0)
    policies = {name: make_policy(name, REFERENCE) for name in POLICIES}
    return {name: [fly(env, policy, seed=seed) for seed in SEEDS] for name, policy in policies.items()}


def metrics(flights):
    return [flight_metrics(flight, REFERENCE, (0.0, 12.0)) for flight in flights]


# In flight


@pytest.mark.parametrize("control_period", PERIODS)
def test_on_the_nominal_plant_the_papers_controller_stays_within_a_twentieth_of_a_degree(control_period):
    env = Heli3DOFEnv(control_period=control_period)
    [flown] = metrics([fly(env, the_papers(control_period))])
    assert flown.success
    assert flown.flown == pytest.approx(10.0)
    assert max(flown.rms_error_deg) < 0.05


@pytest.mark.parametrize("control_period", PERIODS)
def test_from_a_perturbed_start_the_papers_controller_converges(control_period):
    env = Heli3DOFEnv(control_period=control_period)
    start = REFERENCE.x[:, 0] + CORNER
    flight = fly(env, the_papers(control_period), options={"state": start})
    error = np.abs(flight.x - REFERENCE(flight.t)[0])
    assert flight.duration == pytest.approx(10.0)
    assert error[:, -1].max() < 1e-4  # rad and rad/s, on every axis


def test_from_every_drawn_start_the_papers_controller_converges(perturbed):
    for flight in perturbed["feedforward+tvlqr"]:
        assert flight.duration == pytest.approx(10.0)
        assert np.abs(flight.x[:, -1] - REFERENCE.x[:, -1]).max() < 1e-4


def test_from_a_perturbed_start_the_feedforward_alone_does_not_converge(perturbed):
    for flight, flown in zip(perturbed["open-loop"], metrics(perturbed["open-loop"])):
        start, end = (np.abs(flight.x[0::2, k] - REFERENCE.x[0::2, k]).max() for k in (0, -1))
        assert end > 0.5 * start
        assert not flown.success


def test_the_papers_controller_beats_the_others_from_every_start(perturbed):
    papers = metrics(perturbed["feedforward+tvlqr"])
    for name in POLICIES:
        if name == "feedforward+tvlqr":
            continue
        for ours, other in zip(papers, metrics(perturbed[name])):
            assert ours.episode_return > 1.3 * other.episode_return
            travel, elevation, _ = zip(ours.rms_error_deg, other.rms_error_deg)
            assert travel[0] < travel[1]
            assert elevation[0] < elevation[1]


def test_the_feedforward_alone_flies_the_maneuver_from_the_exact_start():
    [flown] = metrics([fly(Heli3DOFEnv(), make_policy("open-loop", REFERENCE))])
    assert flown.success
    assert max(flown.rms_error_deg) < 0.05


@pytest.mark.parametrize("name", ["feedforward+tvlqr", "hover-lqr"])
@pytest.mark.parametrize("elevation", [-0.1, 0.0, 0.15])
def test_the_regulators_hold_hover_at_any_elevation(name, elevation):
    reference = hover(12.0, elevation)
    start = reference.x[:, 0] + CORNER
    flight = fly(Heli3DOFEnv(reference=reference), make_policy(name, reference), options={"state": start})
    assert_allclose(flight.x[:, -1], reference.x[:, -1], atol=1e-3)


# As functions


@pytest.mark.parametrize("name", POLICIES)
def test_every_policy_gives_two_voltages_at_any_time_and_forgets_nothing_it_needs(name):
    policy = make_policy(name, REFERENCE)
    policy.reset(np.random.default_rng(0))
    for t in (0.0, 0.02, 5.0, 10.0, 10.02):
        u = policy(t, REFERENCE(t)[0] + CORNER)
        assert u.shape == (2,)
        assert np.isfinite(u).all()
        assert_array_equal(policy(t, REFERENCE(t)[0] + CORNER), u)


@pytest.mark.parametrize("name", ["open-loop", "feedforward+tvlqr"])
@pytest.mark.parametrize("control_period", [0.02, 0.03])
def test_on_the_reference_nothing_is_corrected(name, control_period):
    policy = make_policy(name, REFERENCE, control_period)
    for k in range(0, round(10.0 / control_period), 7):
        t = k * control_period
        x, u = REFERENCE(t)[0], REFERENCE(t + 0.5 * control_period)[1]  # the voltages of the middle of the period
        assert_allclose(policy(t, x), u, atol=1e-9)


def test_off_the_reference_the_correction_of_the_thrusts_is_the_gain_times_the_error():
    gains = riccati_gains(REFERENCE)
    for t in (0.0, 2.5, 5.0, 9.98):
        x, u = REFERENCE(t)[0], REFERENCE(t + 0.01)[1]
        for error in (*(1e-3 * np.eye(6)), CORNER):
            v = inputs(the_papers()(t, x + error))
            assert_allclose(v - inputs(u), -gains(t) @ error, atol=1e-9)


def test_open_loop_does_not_look_at_the_measurement():
    policy = make_policy("open-loop", REFERENCE)
    assert_array_equal(policy(3.0, np.zeros(6)), policy(3.0, CORNER))


def test_hover_lqr_asks_for_hover_on_the_reference_and_for_the_stationary_gain_off_it():
    policy = make_policy("hover-lqr", REFERENCE)
    stationary = riccati_gains(hover(1.0))(0.0)
    each = math.sqrt(-0.5 * TABLE_I.a2 / TABLE_I.b2 / TABLE_I.k_plus)
    for t in (0.0, 4.0, 9.0):
        x = REFERENCE(t)[0]
        assert_allclose(policy(t, x), each, atol=1e-9)
        assert_allclose(inputs(policy(t, x + CORNER)) - inputs(np.full(2, each)), -stationary @ CORNER, atol=1e-9)


def test_zero_is_no_voltage():
    assert_array_equal(make_policy("zero", REFERENCE)(1.0, CORNER), 0.0)


def test_a_policy_believes_in_the_parameters_it_is_given():
    twice = HelicopterParameters()._replace(k_plus=2.0 * HelicopterParameters().k_plus)
    hovering = make_policy("hover-lqr", REFERENCE, parameters=twice)(0.0, REFERENCE.x[:, 0])
    assert_allclose(hovering, make_policy("hover-lqr", REFERENCE)(0.0, REFERENCE.x[:, 0]) / math.sqrt(2.0))


@pytest.mark.parametrize("name", ["lqr", "", "Zero", None])
def test_an_unknown_policy_is_named_with_those_that_there_are(name):
    with pytest.raises(ValueError, match=re.escape(f"name = {name!r}") + ".*'feedforward\\+tvlqr'"):
        make_policy(name, REFERENCE)
