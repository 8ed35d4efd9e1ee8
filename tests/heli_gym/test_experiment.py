"""Section IV, in simulation: the nominal flight, a perturbed one and uncertain parameters, in closed loop."""

import functools

import numpy as np
import pytest

from heli_gym import HelicopterParameters
from heli_gym.baselines import fly, make_policy
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.plant import Plant

REFERENCE = find_reference("travel-360")
SAMPLING_TIME = 1e-3  # s, T_a of Section IV
U_MIN, U_MAX, PITCH_MAX_DEG = 1.0, 11.0, 50.0  # (9)
NOMINAL = HelicopterParameters()


@functools.cache
def the_papers(control_period):
    """The controller, which knows the nominal parameters only."""
    return make_policy("feedforward+tvlqr", REFERENCE, control_period)


def flown(start_deg=(0.0, 0.0), plant="nominal", control_period=SAMPLING_TIME):
    """A closed-loop flight that starts with travel and elevation off by these degrees."""
    start = REFERENCE.x[:, 0].copy()
    start[[0, 2]] += np.radians(start_deg)
    env = Heli3DOFEnv(plant, control_period=control_period)
    return fly(env, the_papers(control_period), options={"state": start})


def metrics(flight):
    return flight_metrics(flight, REFERENCE, (0.0, 12.0))


@pytest.fixture(scope="module")
def nominal():
    return flown()


@pytest.fixture(scope="module")
def perturbed():
    return flown((-5.0, 5.0))


def test_section_iv_the_controller_runs_every_millisecond(nominal):
    assert nominal.t.size == 10001
    np.testing.assert_allclose(np.diff(nominal.t), SAMPLING_TIME, rtol=1e-9)


def test_section_iv_travel_and_elevation_follow_their_nominal_trajectories(nominal):
    travel, elevation, _ = metrics(nominal).rms_error_deg
    assert max(travel, elevation) < 0.05
    np.testing.assert_allclose(np.degrees(nominal.x[[0, 2], -1]), [360.0, 0.0], atol=0.05)


def test_section_iv_pitch_remains_within_its_constraints(nominal, perturbed):
    assert np.degrees(np.abs(nominal.x[4]).max()) <= PITCH_MAX_DEG
    assert np.degrees(np.abs(perturbed.x[4]).max()) <= PITCH_MAX_DEG


def test_section_iv_pitch_deviates_more_for_the_sake_of_travel_and_elevation(perturbed):
    travel, elevation, pitch = metrics(perturbed).rms_error_deg
    assert pitch > travel
    assert pitch > elevation


def test_section_iv_undisturbed_voltages_are_the_nominal_ones(nominal):
    middle = nominal.t[:-1] + 0.5 * SAMPLING_TIME
    np.testing.assert_allclose(nominal.u[:, :-1], REFERENCE(middle)[1], atol=0.01)


def test_section_iv_the_feedback_uses_the_reserve_beyond_the_planned_voltages_at_times(perturbed):
    outside = ((perturbed.u < U_MIN) | (perturbed.u > U_MAX)).any(axis=0)
    assert 0.001 < outside.mean() < 0.2
    assert REFERENCE.u.min() >= U_MIN - 1e-6
    assert REFERENCE.u.max() <= U_MAX + 1e-6


def test_section_iv_the_rotation_ends_at_rest_on_the_goal(perturbed):
    np.testing.assert_allclose(perturbed.x[:, -1], [2.0 * np.pi, 0.0, 0.0, 0.0, 0.0, 0.0], atol=1e-3)
    assert metrics(perturbed).success


@pytest.mark.parametrize("factor", [0.95, 1.05])
@pytest.mark.parametrize("coefficient", ["k_plus", "a1", "a2", "a3", "b1", "b2", "b3"])
def test_section_iv_the_controller_is_robust_against_model_uncertainties(coefficient, factor):
    uncertain = Plant(NOMINAL._replace(**{coefficient: factor * getattr(NOMINAL, coefficient)}))
    judged = metrics(flown(plant=uncertain, control_period=0.02))
    assert judged.success
    assert max(judged.rms_error_deg) < 1.5
    assert judged.peak_pitch_deg < PITCH_MAX_DEG + 2.0
