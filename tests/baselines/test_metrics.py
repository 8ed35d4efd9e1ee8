"""Metrics of a flight against hand calculation and the environment."""

import functools

import gymnasium as gym
import numpy as np
import pytest
from numpy.testing import assert_allclose

from heli_gym import Limits, Trajectory
from heli_gym.baselines import fly, make_policy
from heli_gym.baselines.evaluation.metrics import Metrics, crash_cost, flight_metrics, tracking_reward
from heli_gym.baselines.evaluation.statistics import interquartile_mean, probability_of_improvement, rank_crashes_last
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.task import control_steps, cost

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
    assert [type(value) for value in metrics] == [tuple, tuple, float, float, float, float, float, bool, bool]
    assert {type(value) for value in (*metrics.rms_error_deg, *metrics.terminal_error_deg)} == {float}


def test_limits_are_those_of_the_reference_not_of_the_flight():
    wide = flight_metrics(by_hand(), still(Limits(-1.0, 13.0, -1.2, 1.2)), (0.0, 12.0))
    assert wide.cost == 0.0


def test_saturation_follows_from_the_amplifiers_limits():
    assert flight_metrics(by_hand(), still(Limits()), (3.0, 12.0)).saturated == pytest.approx(3.0 / 4.0)
    assert flight_metrics(by_hand(), still(Limits()), (-1.0, 13.0)).saturated == 0.0


def test_a_flight_that_ends_early_has_no_success_and_counts_at_its_last_error_to_the_end():
    limits = Limits(1.0, 11.0, -np.radians(50.0), np.radians(50.0))
    metrics = flight_metrics(by_hand(steps=2), still(limits), (0.0, 12.0))
    assert (metrics.success, metrics.crashed) == (False, True)
    assert metrics.flown == 0.5
    # travel 0, -1, 2, and then 2 and 2; pitch 0, 60, -20, and then -20 twice
    assert_allclose(metrics.rms_error_deg, np.sqrt([13.0 / 5.0, 1.0, (3600.0 + 3 * 400.0) / 5.0]))
    # as it flew, and then half a second with both voltages 1 V out of a window of 10 V, the pitch within
    assert metrics.cost == pytest.approx(0.25 * (0.1 + 0.1 + 0.1) + 0.5 * (0.1 + 0.1))
    perfect_so_far = Trajectory(np.array([0.0, 0.25, 0.5]), np.zeros((6, 3)), np.full((2, 3), 6.0))
    assert flight_metrics(perfect_so_far, still(Limits()), (0.0, 12.0)).success is False


def test_a_flight_whose_pitch_leaves_the_limit_in_its_last_step_has_crashed_too():
    flight = by_hand()
    assert flight_metrics(flight, still(Limits()), (0.0, 12.0)).crashed is False
    assert flight_metrics(flight, still(Limits()), (0.0, 12.0), pitch_limit=np.radians(4.0)).crashed is True


def test_no_flight_that_goes_on_is_charged_more_than_one_that_crashed():
    rng, limits = np.random.default_rng(0), Limits()
    pitch, u = rng.uniform(-1.4, 1.4, 2000), rng.uniform(*AMPLIFIER_LIMITS, (2, 2000))
    assert cost(pitch, u, limits).max() <= crash_cost(1.4, AMPLIFIER_LIMITS, limits)


def test_a_crash_never_pays():
    """Of 200 flights, the worst ones crash instead, while their errors are still small: no figure gets better."""
    rng = np.random.default_rng(1)
    errors = rng.uniform(1.0, 9.0, (1, 200))
    others = rng.uniform(1.0, 9.0, (1, 200))
    for crashes in (1, 11, 47, 120):
        crashed = np.zeros((1, 200), bool)
        crashed[0, np.argsort(errors[0])[-crashes - 1 : -1]] = True
        early = np.where(crashed, 0.1, errors)
        assert interquartile_mean(rank_crashes_last(early, crashed)) >= interquartile_mean(errors)
        assert interquartile_mean(early) < interquartile_mean(errors)  # what it would be without ranking them
        assert probability_of_improvement(early, others, crashed) <= probability_of_improvement(errors, others)


@pytest.mark.parametrize("name", ["feedforward+tvlqr", "hover-lqr"])
def test_cutting_a_flight_off_raises_its_cost_and_lowers_its_return(name):
    env = Heli3DOFEnv(start_spread_deg=5.0)
    flight = fly(env, policy_for(name, REFERENCE), seed=3)
    whole = flight_metrics(flight, REFERENCE, env.voltage_limits)
    for steps in (1, 50, 300, 499):
        part = Trajectory(flight.t[: steps + 1], flight.x[:, : steps + 1], flight.u[:, : steps + 1])
        metrics = flight_metrics(part, REFERENCE, env.voltage_limits)
        assert metrics.cost > whole.cost
        assert metrics.episode_return < whole.episode_return
        assert metrics.crashed and not metrics.success


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
    core = env.unwrapped
    end = control_period * control_steps(core.reference.duration, control_period)
    left = end - metrics.flown if metrics.crashed else 0.0
    pitch = np.radians(metrics.peak_pitch_deg)
    charge = left * crash_cost(pitch, core.voltage_limits, core.reference.limits)
    assert metrics.episode_return == pytest.approx(env.total_reward, rel=1e-9)
    assert metrics.cost - charge == pytest.approx(env.total_cost, rel=1e-9, abs=1e-9)
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
