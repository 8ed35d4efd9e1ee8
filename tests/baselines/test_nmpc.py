"""The predictive controller: its optimum, its limits, and its flights."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.optimize import minimize

from heli_gym import HelicopterParameters
from heli_gym.baselines.control import predictive
from heli_gym.baselines.control.adaptive_filter import Model, sample_thrust_map, with_estimates
from heli_gym.baselines.control.estimation import least_lift
from heli_gym.baselines.control.nmpc import (
    Bounds,
    MpcSettings,
    box_minimum,
    differentiate,
    forward_pass,
    step_model,
    write_targets,
)
from heli_gym.baselines.control.policies import make_policy
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.baselines.evaluation.rollout import fly_many
from heli_gym.env import find_reference
from heli_gym.rig import PAPER
from heli_gym.vector_env import Heli3DOFVectorEnv

REFERENCE = find_reference("travel-360")
P = HelicopterParameters()
FANS = sample_thrust_map(PAPER, PAPER.voltage_limits)


def test_the_minimum_in_a_box_is_that_of_a_general_solver():
    rng = np.random.default_rng(0)
    for _ in range(100):
        root = rng.normal(size=(2, 2))
        H, g = root @ root.T + 0.1 * np.eye(2), 3.0 * rng.normal(size=2)
        low, high = -rng.random(2), rng.random(2)
        d1, d2, *free = box_minimum((H[0, 0], H[0, 1], H[1, 1]), tuple(g), tuple(low), tuple(high))
        bounds = [*zip(low, high)]
        best = minimize(
            lambda d, H=H, g=g: g @ d + 0.5 * d @ H @ d, np.zeros(2), bounds=bounds, options={"ftol": 1e-15}
        )
        assert_allclose([d1, d2], best.x, atol=1e-5)
        for d, is_free, ends in zip((d1, d2), free, bounds):
            assert is_free == (d not in ends)


def test_jacobians_are_those_of_central_differences():
    model = Model(P._replace(c1=0.1), FANS, 0.9, 0.08, (0.1, -0.9), (0.02, 0.03, 0.1))
    z, u = np.array([0.3, 0.5, 0.1, -0.2, 0.4, 0.6, 7.0, 8.0]), np.array([9.0, 6.0])
    A, B = np.empty((8, 8)), np.empty((8, 2))
    differentiate(z, u, A, B, np.empty(8), np.empty(8), 0.05, model)

    def moved(j, step):
        point, out = np.concatenate((z, u)), np.empty(8)
        point[j] += step
        step_model(point[:8], point[8:], out, 0.05, model)
        return out

    central = np.array([(moved(j, 1e-4) - moved(j, -1e-4)) / 2e-4 for j in range(10)]).T
    assert_allclose(np.hstack((A, B)), central, atol=1e-5)


@pytest.mark.parametrize("off", [0.02, 0.4])  # rad; from the larger one, voltages saturate
def test_iterated_to_convergence_a_plan_is_the_optimum_of_a_general_solver(off, monkeypatch):
    monkeypatch.setattr(predictive, "FIRST_ITERATIONS", 60)
    policy = predictive.predictive_policy(REFERENCE, 0.02, PAPER, settings=MpcSettings(nodes=8, step=0.1))
    x = REFERENCE(4.0)[0] + np.array([off, 0.0, -off / 2.0, 0.0, 0.1, 0.0])
    s = policy.init(4.0, x).estimate.s.copy()
    s[:6, 0] = x
    k = np.array([200])
    _, plan = policy.control(policy.first_plan(k), k, s)
    assert plan.u.min() >= 0.0 and plan.u.max() <= 12.0

    targets, model = np.empty((9, 10)), with_estimates(s[:, 0], P, FANS)
    bounds = Bounds(0.0, 12.0, *REFERENCE.limits.u, *REFERENCE.limits.pitch)
    write_targets(targets, policy.x, policy.v, 200, 5, policy.settings, bounds, least_lift(P), P, model)

    def cost(flat):
        Z = np.empty((9, 8))
        Z[0] = s[:8, 0]
        U, K, k_ff = flat.reshape(8, 2), np.zeros((8, 2, 8)), np.zeros((8, 2))
        return forward_pass(Z, U, K, k_ff, 0.0, Z, np.empty((8, 2)), targets, policy.settings, bounds, 0.1, model)

    ours = plan.u[:, :, 0].ravel()
    found = minimize(cost, ours, bounds=[(0.0, 12.0)] * 16, options={"ftol": 1e-13, "maxiter": 300, "maxfun": 10**5})
    assert cost(ours) <= found.fun * (1.0 + 1e-3)


@pytest.mark.parametrize("plant", ["lab", "rigid"])
def test_adaptive_mpc_halves_the_travel_error_of_the_tuned_kalman_lqr_on_unknown_draws(plant):
    envs = Heli3DOFVectorEnv(8, plant, REFERENCE, start_spread_deg=5.0)
    rms = {}
    for name in ("adaptive-mpc", f"kalman-lqr@{plant}"):
        flown = [flight_metrics(one, REFERENCE, (0.0, 12.0)) for one in fly_many(envs, make_policy(name, REFERENCE), 0)]
        rms[name] = np.mean([one.rms_error_deg for one in flown], axis=0)
        assert name != "adaptive-mpc" or all(one.success for one in flown)
    ours, kalman = rms.values()
    assert ours[0] < 0.5 * kalman[0]
    assert ours[1] < 0.95 * kalman[1]


def test_the_amplifier_limits_hold_in_every_plan():
    policy = make_policy("adaptive-mpc", REFERENCE, voltage_limits=(2.0, 9.0))
    for k in range(20):
        policy(0.02 * k, REFERENCE(0.02 * k)[0] + np.array([0.3, 0.0, 0.2, 0.0, 0.0, 0.0]))
        assert policy.memory.plan.u.min() >= 2.0
        assert policy.memory.plan.u.max() <= 9.0
