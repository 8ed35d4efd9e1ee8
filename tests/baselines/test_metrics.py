"""The metrics of a flight, by hand and as the environment counts."""

import functools

import gymnasium as gym
import numpy as np
import pytest
from numpy.testing import assert_allclose

from heli_gym import Limits, Trajectory
from heli_gym.baselines import fly, make_policy
from heli_gym.baselines.evaluation.metrics import Metrics, flight_metrics, tracking_reward
from heli_gym.env import Heli3DOFEnv, find_reference

REFERENCE = find_reference("travel-360")


policy_for = functools.cache(make_policy)


def still(limits: Limits) -> Trajectory:
    """A reference that rests at zero under 6 V, for 1 s."""
    return Trajectory(np.array([0.0, 1.0]), np.zeros((6, 2)), np.full((2, 2), 6.0), limits)


def by_hand(steps: int = 4) -> Trajectory:
    """A flight along `still`, a quarter of a second per step."""
    x, u = np.zeros((6, 5)), np.full((2, 5), 6.0)
    x[0] = np.radians([0.0, -1.0, 2.0, -1.0, -2.0])  # travel: squares 0, 1, 4, 1, 4 of a degree
    x[2] = np.radians([1.0, 1.0, 1.0, 1.0, 1.0])
    x[4] = np.radians([0.0, 60.0, -20.0, 0.0, 5.0])
    u[0] = [12.0, 6.0, 3.0, 6.0, 0.0]  # the last repeats nothing: no time is left to apply it
    u[1] = [6.0, 0.0, 6.0, 6.0, 12.0]
    return Trajectory(0.25 * np.arange(steps + 1), x[:, : steps + 1], u[:, : steps + 1])


def test_every_metric_of_a_flight_by_hand():
    metrics = flight_metrics(by_hand(), still(Limits(1.0, 11.0, -np.radians(50.0), np.radians(50.0))), (0.0, 12.0))
    assert_allclose(metrics.rms_error_deg, np.sqrt([2.0, 1.0, (3600.0 + 400.0 + 25.0) / 5.0]))
    assert_allclose(metrics.terminal_error_deg, [2.0, 1.0, 5.0])
    assert metrics.peak_pitch_deg == pytest.approx(60.0)
    assert metrics.saturated == pytest.approx(2.0 / 4.0)  # at 12 V in the first step, at 0 V in the second
    # 1 V too much, then 1 V too little, of a window of 10 V; 10 degrees too much of a window of 100
    assert metrics.cost == pytest.approx(0.25 * (0.1 + 0.1 + 0.1))
    squares = [
        (1 / 9 + 1 / 9 + 100.0) + 1.0,  # 6 V off
        (4 / 9 + 1 / 9 + 400 / 36) + 1.0,  # 6 V off
        (1 / 9 + 1 / 9) + 0.25,  # 3 V off
        (4 / 9 + 1 / 9 + 25 / 36) + 0.0,
    ]
    assert metrics.episode_return == pytest.approx(sum(0.25 / (1.0 + square) for square in squares))
    assert metrics.flown == 1.0
    assert metrics.success is True


def test_the_metrics_are_plain_numbers():
    metrics = flight_metrics(by_hand(), still(Limits()), (0.0, 12.0))
    assert [type(value) for value in metrics] == [tuple, tuple, float, float, float, float, float, bool]
    assert {type(value) for value in (*metrics.rms_error_deg, *metrics.terminal_error_deg)} == {float}


def test_limits_are_those_of_the_reference_not_of_the_flight():
    wide = flight_metrics(by_hand(), still(Limits(-1.0, 13.0, -1.2, 1.2)), (0.0, 12.0))
    assert wide.cost == 0.0


def test_saturation_is_told_by_the_amplifiers_limits():
    assert flight_metrics(by_hand(), still(Limits()), (3.0, 12.0)).saturated == pytest.approx(3.0 / 4.0)
    assert flight_metrics(by_hand(), still(Limits()), (-1.0, 13.0)).saturated == 0.0


def test_a_flight_that_ends_early_has_no_success_and_counts_what_was_flown():
    metrics = flight_metrics(by_hand(steps=2), still(Limits()), (0.0, 12.0))
    assert metrics.success is False
    assert metrics.flown == 0.5
    assert_allclose(metrics.rms_error_deg, np.sqrt([5.0 / 3.0, 1.0, 4000.0 / 3.0]))
    perfect_so_far = Trajectory(np.array([0.0, 0.25, 0.5]), np.zeros((6, 3)), np.full((2, 3), 6.0))
    assert flight_metrics(perfect_so_far, still(Limits()), (0.0, 12.0)).success is False


@pytest.mark.parametrize(("row", "degrees"), [(0, 3.1), (1, 6.1), (2, 3.1), (3, 6.1), (4, 6.1), (5, 30.1)])
def test_a_flight_that_ends_out_of_tolerance_on_one_axis_has_no_success(row, degrees):
    flight = by_hand()
    x = flight.x.copy()
    x[row, -1] = np.radians(degrees)
    assert not flight_metrics(Trajectory(flight.t, x, flight.u), still(Limits()), (0.0, 12.0)).success


class Summing(gym.Wrapper):
    """Sums what the environment pays and charges."""

    def reset(self, **kwargs):
        self.total_reward, self.total_cost = 0.0, 0.0
        return self.env.reset(**kwargs)

    def step(self, action):
        observation, reward, terminated, truncated, info = self.env.step(action)
        self.total_reward += reward
        self.total_cost += info["cost"]
        self.success = info.get("is_success")
        return observation, reward, terminated, truncated, info


class Tumble:
    def reset(self, rng):
        pass

    def __call__(self, t, measurement):
        return np.array([12.0, 0.0])


def summed(policy, **arguments) -> tuple[Metrics, Summing]:
    env = Summing(Heli3DOFEnv(**arguments))
    flight = fly(env, policy, seed=1)
    return flight_metrics(flight, env.unwrapped.reference, env.unwrapped.voltage_limits), env


@pytest.mark.parametrize("name", ["feedforward+tvlqr", "open-loop", "hover-lqr", "zero", "tumble"])
@pytest.mark.parametrize("control_period", [0.02, 0.03])
def test_return_cost_and_success_are_those_of_the_environment(name, control_period):
    policy = Tumble() if name == "tumble" else policy_for(name, REFERENCE, control_period)
    metrics, env = summed(policy, control_period=control_period, start_spread_deg=5.0)
    assert metrics.episode_return == pytest.approx(env.total_reward, rel=1e-9)
    assert metrics.cost == pytest.approx(env.total_cost, rel=1e-9, abs=1e-12)
    assert metrics.success is env.success
    assert metrics.episode_return <= metrics.flown


def test_a_crash_has_no_success_and_ends_before_the_maneuver():
    metrics, _ = summed(Tumble())
    assert metrics.success is False
    assert metrics.flown < 2.0
    assert metrics.peak_pitch_deg > 80.0
    assert metrics.saturated == 1.0


def test_an_exact_flight_earns_almost_a_second_per_second():
    metrics, _ = summed(policy_for("feedforward+tvlqr", REFERENCE, 0.02))
    assert 9.999 < metrics.episode_return <= 10.0
    assert metrics.success is True


def test_the_reward_of_tracking_is_greatest_without_error_and_cost():
    zero = np.zeros((2, 1)), np.zeros(1)
    best = tracking_reward(*zero, np.ones(1))
    assert_allclose(best, 1.0)
    assert (tracking_reward(np.full((2, 1), 0.02), np.zeros(1), np.ones(1)) < best).all()
    assert (tracking_reward(np.zeros((2, 1)), np.full(1, 0.1), np.ones(1)) < best).all()
