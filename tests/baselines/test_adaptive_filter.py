"""Adaptive filter: prediction, convergence and Coriolis effects."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import solve_ivp

from heli_gym import HelicopterParameters, dynamics
from heli_gym.baselines.control.adaptive_filter import (
    CENTRIFUGAL,
    DISTURBANCE,
    FRICTION,
    GAIN,
    LAG,
    AdaptiveFilter,
    Estimate,
    FilterNoise,
    Model,
    fan_thrust,
    fan_voltage,
    model_derivative,
    prior_moments,
    sample_thrust_map,
)
from heli_gym.baselines.control.policies import make_policy
from heli_gym.baselines.evaluation.rollout import fly_many
from heli_gym.env import find_reference
from heli_gym.model import thrust, virtual_input
from heli_gym.plant import LAB_FRICTION, LAB_ROTORS
from heli_gym.rig import PAPER, find_rig, rig_names
from heli_gym.rigid_body import VARIANTS, rigid_dynamics, solve_rigid_body
from heli_gym.vector_env import Heli3DOFVectorEnv

REFERENCE = find_reference("travel-360")
P = HelicopterParameters()


def some_estimate(filter_: AdaptiveFilter) -> Estimate:
    x, u = REFERENCE(np.array([3.0]))
    estimate = filter_.init(x, u)
    estimate.s[LAG:, 0] = [0.08, 0.9, 0.1, 0.2, 0.3, 0.0, 0.0, 0.05, -0.04, 0.2]
    return estimate


def test_the_prediction_is_that_of_an_independent_integrator():
    filter_ = AdaptiveFilter(PAPER, 0.02, FilterNoise())
    estimate, u = some_estimate(filter_), np.array([8.0, 6.5])
    lag, gain, *friction = estimate.s[LAG:CENTRIFUGAL, 0]
    disturbance = estimate.s[DISTURBANCE:, 0]

    def derivative(_, z):
        f = gain * P.k_plus * z[6:] ** 2
        rates = np.array(dynamics(z[:6], (f.sum(), f[0] - f[1]), P))
        rates[1::2] += disturbance - np.array(friction) * z[1:6:2]
        return np.concatenate((rates, (u - z[6:]) / lag))

    exact = solve_ivp(derivative, (0.0, 0.02), estimate.s[:8, 0], "DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    predicted = filter_.step(estimate, None, u[:, None]).s
    assert_allclose(predicted[:8, 0], exact, atol=1e-7)
    assert_allclose(predicted[8:], estimate.s[8:])


def test_an_update_is_that_of_bayes_for_jointly_normal_variables():
    filter_ = AdaptiveFilter(PAPER, 0.02, FilterNoise())
    estimate = filter_.step(some_estimate(filter_), None, np.array([[8.0], [6.5]]))
    angles = estimate.s[0:6:2] + np.array([[0.002], [-0.001], [0.003]])
    after = filter_.step(estimate, angles, None)
    m, C, H = estimate.s[:, 0], estimate.P[:, :, 0], np.eye(len(estimate.s))[[0, 2, 4]]
    gain = C @ H.T @ np.linalg.inv(H @ C @ H.T + 16e-8 * np.eye(3))  # 4e-4 rad of encoder noise
    assert_allclose(after.s[:, 0], m + gain @ (angles[:, 0] - H @ m), atol=1e-9)
    assert_allclose(after.P[:, :, 0], C - gain @ H @ C, atol=1e-12)


def test_the_priors_are_the_documented_ranges():
    mean, deviation = prior_moments(FilterNoise())
    assert mean[0] == pytest.approx(0.5 * (LAB_ROTORS.lag.low + LAB_ROTORS.lag.high))
    assert mean[1] == pytest.approx(1.0 - 0.5 * LAB_ROTORS.thrust_loss.high)
    assert_allclose(deviation[2:5], [(r.high - r.low) / 12**0.5 for r in LAB_FRICTION.viscous])
    assert_allclose(prior_moments(FilterNoise(adaptive=False))[1], 0.0)


@pytest.mark.parametrize(
    ("lag", "scale"), [(0.005, 0.05), (0.05, 1.0), (0.08, 1.0), (0.2, 1.0), (0.4, 4.0), (0.0, 0.0)]
)
def test_the_lag_is_estimated_in_a_range_around_that_of_the_rig(lag, scale):
    filter_ = AdaptiveFilter(replace(PAPER, lag=lag), 0.02, FilterNoise())
    x, u = REFERENCE(np.array([3.0]))
    estimate = filter_.init(x, u)
    assert estimate.s[LAG, 0] == pytest.approx(scale * 0.125)
    assert estimate.P[LAG, LAG, 0] == pytest.approx((scale * 0.15) ** 2 / 12.0)
    for far, bound in ((-1.0, 0.02), (9.0, 0.5)):
        estimate.s[LAG] = far
        assert filter_.step(estimate, x[0::2], None).s[LAG, 0] == pytest.approx(scale * bound)


def test_during_a_flight_the_filter_converges_to_the_plants_draw():
    envs = Heli3DOFVectorEnv(6, "lab", REFERENCE, start_spread_deg=5.0)
    policy = make_policy("adaptive-mpc", REFERENCE)
    envs.reset(seed=0)
    plants = [envs.plant_of(i) for i in range(6)]
    fly_many(envs, policy, seed=0)
    s = policy.memory.estimate.s
    drawn = np.array([[q.rotors.lag, 1.0 - q.rotors.thrust_loss, *q.friction.viscous] for q in plants]).T
    error = np.abs(s[LAG:CENTRIFUGAL] - drawn)
    prior = np.abs(prior_moments(FilterNoise())[0][:5, None] - drawn)
    assert (error[LAG - LAG] < 0.01).all()  # s
    assert (error[GAIN - LAG] < 0.02).all()
    assert (error[FRICTION - LAG] < 0.04).all()  # 1/s, of travel
    excited = [0, 1, 2, 4]  # elevation hardly moves on this reference, so that its friction stays uncertain
    assert (error.mean(axis=1) < 0.2 * prior.mean(axis=1))[excited].all()


# rad off the reference in elevation, and what the rigid body adds at least and what may be left, in rad/s²
@pytest.mark.parametrize(
    ("off", "added", "left"), [(0.0, [0.05, 0.1, 0.9], 0.04), (0.1, [0.05, 0.3, 0.9], [0.03, 0.03, 0.1])]
)
@pytest.mark.parametrize(("variant", "lift"), [*zip(VARIANTS, (0.082, -0.08))])
def test_two_coefficients_explain_nearly_all_that_the_rigid_body_adds_to_equation_3(variant, lift, off, added, left):
    x, u = REFERENCE(np.linspace(0.0, 10.0, 101))
    x[2] += off * np.sin(np.arange(101))
    v = np.stack(virtual_input(thrust(u)))
    rigid = np.array(rigid_dynamics(x, v, solve_rigid_body(variant)))[1::2]
    plain = np.array(dynamics(x, v, P))[1::2]
    known = np.array(model_derivative(x, v, Model(P, None, 1.0, 0.1, (lift, -0.95), (0.0, 0.0, 0.0))))[1::2]
    assert (np.abs(rigid - plain).max(axis=1) > added).all()
    assert (np.abs(rigid - known).max(axis=1) < left).all()


@pytest.mark.parametrize("name", rig_names())
def test_the_sampled_thrust_map_is_that_of_the_rig(name):
    rig = find_rig(name)
    fans = sample_thrust_map(rig, rig.voltage_limits)
    u = np.random.default_rng(0).uniform(*rig.voltage_limits, 200)
    for fan, thrusts in enumerate(rig.thrust(np.stack((u, u)))):
        sampled = np.array([fan_thrust(fans, fan, one) for one in u])
        assert_allclose(sampled, thrusts, atol=1e-12 if name == "paper" else 1e-3 * np.abs(thrusts).max())
        back = [fan_thrust(fans, fan, fan_voltage(fans, fan, one)) for one in thrusts]
        assert_allclose(back, thrusts, atol=2e-3 * np.abs(thrusts).max())
