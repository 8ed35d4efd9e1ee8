"""Iterative learning control: its model agrees with flights, and errors fall from flight to flight."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from heli_gym.baselines import fly, make_policy
from heli_gym.baselines.control.ilc import LearnedFeedforward
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.baselines.evaluation.rollout import fly_repeatedly
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.plant import Plant, Rotors

REFERENCE = find_reference("travel-360")
LAGGING = Plant(rotors=Rotors(lag=0.1, delay=0.02))  # what `lag-lqr` assumes


@pytest.mark.parametrize("k", [20, 100])
def test_the_lifted_response_is_that_of_flights_with_a_pulse_of_voltage(k):
    policy = LearnedFeedforward(make_policy("lag-lqr", REFERENCE))
    env = Heli3DOFEnv(LAGGING)
    plain = fly(env, policy, seed=0)
    for fan in range(2):
        policy.correction = np.zeros_like(policy.correction)
        policy.correction[fan, k] = 0.2
        pulsed = fly(env, policy, seed=0)
        expected = (pulsed.x - plain.x)[0:3:2, 1:]
        found = 0.2 * policy.lifted[:, 2 * k + fan].reshape(-1, 2).T
        assert_allclose(found, expected, atol=0.06 * np.abs(expected).max())


@pytest.mark.parametrize("plant", ["lab", "rigid"])
def test_errors_fall_from_flight_to_flight(plant):
    flights = fly_repeatedly(Heli3DOFEnv(plant), make_policy(f"kalman-lqr@{plant}", REFERENCE), flights=5, seed=3)
    rms = np.array([flight_metrics(one, REFERENCE, (0.0, 12.0)).rms_error_deg[:2] for one in flights])
    assert (rms[-1] < 0.6 * rms[0]).all()
