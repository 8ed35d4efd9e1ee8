"""`ResidualAction`: corrections of a controller by any learner."""

from dataclasses import replace

import gymnasium as gym
import numpy as np
import pytest
from gymnasium.envs.registration import EnvSpec
from gymnasium.utils.env_checker import check_env
from independent import EitherReference
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym.baselines import ResidualAction, VectorResidualAction, fly, make_policy
from heli_gym.baselines.control.residual import ResidualPolicy
from heli_gym.env import find_reference
from heli_gym.rig import PAPER

SHORT = find_reference("climb-7.5")
BASES = ("feedforward+tvlqr", "lag-lqr", "kalman-lqr", "lqi")
SAMPLED = {"reference": EitherReference(), "plant": "lab", "start_spread_deg": 3.0}


def flight(env, seed, actions):
    """Observations, states and infos from the reset to the end of the episode."""
    observation, info = env.reset(seed=seed)
    steps = [(observation, info)]
    over = False
    while not over:
        observation, _, terminated, truncated, info = env.step(actions)
        steps.append((observation, info))
        over = terminated or truncated
    return steps


@pytest.mark.parametrize("base", BASES)
def test_zero_flies_the_base_bit_for_bit(base):
    plain = gym.make("Heli3DOF-v0", plant="lab", reference=SHORT, start_spread_deg=3.0)
    expected = fly(plain, make_policy(base, SHORT), seed=3)
    env = ResidualAction(gym.make("Heli3DOF-v0", plant="lab", reference=SHORT, start_spread_deg=3.0), base)
    for _ in range(2):  # a second flight as the first
        steps = flight(env, 3, np.zeros(2, np.float32))
        assert_array_equal(np.array([info["state"] for _, info in steps]).T, expected.x)


@pytest.mark.parametrize("action", [(1.0, -0.5), (-3.0, 9.0)])
def test_an_action_corrects_the_saturated_voltages_of_the_base_by_the_authority(action):
    env = ResidualAction(gym.make("Heli3DOF-v0", reference=SHORT), authority=2.0)
    _, info = env.reset(seed=0)
    for _ in range(50):
        base = info["base_voltage"]
        expected = make_policy("feedforward+tvlqr", SHORT)(info["time"], info["measurement"])
        assert_array_equal(base, np.clip(expected, 0.0, 12.0))
        *_, info = env.step(action)
        assert_allclose(info["voltage"], np.clip(base + 2.0 * np.clip(action, -1.0, 1.0), 0.0, 12.0), atol=1e-12)


def test_the_voltages_of_the_base_are_in_the_observation():
    env = ResidualAction(gym.make("Heli3DOF-v0", plant="lab"))
    observation, info = env.reset(seed=0)
    assert observation.shape == (50,) and observation in env.observation_space
    for _ in range(20):
        assert_allclose(observation[-2:], info["base_voltage"] / 6.0 - 1.0, rtol=1e-6)
        observation, *_, info = env.step(env.action_space.sample())


def test_each_reference_of_a_sampler_has_a_policy_of_its_own():
    env, plain = ResidualAction(gym.make("Heli3DOF-v0", **SAMPLED)), gym.make("Heli3DOF-v0", **SAMPLED)
    durations = set()
    for seed in range(6):
        steps = flight(env, seed, (0.0, 0.0))
        plain.reset(seed=seed)
        reference = plain.unwrapped.reference
        durations.add(reference.duration)
        expected = fly(plain, make_policy("feedforward+tvlqr", reference), seed=seed)
        assert_array_equal(np.array([info["state"] for _, info in steps]).T, expected.x)
    assert len(durations) == 2


@pytest.mark.filterwarnings("ignore:.*is different from the unwrapped version")
def test_gymnasiums_checker_is_content_and_the_spec_makes_it_again():
    env = ResidualAction(gym.make("Heli3DOF-v0", reference="climb-7.5"), authority=1.0)
    check_env(env, skip_render_check=True)
    again = gym.make(EnvSpec.from_json(env.spec.to_json()))
    assert isinstance(again, ResidualAction) and again.authority == 1.0
    env.reset(seed=0)
    again.reset(seed=0)
    assert_array_equal(env.step((0.1, 0.2))[0], again.step((0.1, 0.2))[0])


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"authority": -1.0}, "authority = -1"),
        ({"authority": float("nan")}, "authority = nan"),
        ({"authority": "3"}, "authority = '3'"),
        ({"policy": "moon"}, "'moon'"),
    ],
)
def test_unknown_names_are_refused(arguments, said):
    with pytest.raises(ValueError, match=said):
        ResidualAction(gym.make("Heli3DOF-v0"), **arguments)
    with pytest.raises(ValueError, match=said):
        VectorResidualAction(gym.make_vec("Heli3DOF-v0", 2), **arguments)


def test_other_environments_and_actions_are_refused():
    with pytest.raises(ValueError, match="Heli3DOF"):
        ResidualAction(gym.make("CartPole-v1"))
    with pytest.raises(ValueError, match="Heli3DOF"):
        VectorResidualAction(gym.make_vec("CartPole-v1", 2))
    env = ResidualAction(gym.make("Heli3DOF-v0"))
    env.reset()
    for action in ((np.nan, 0.0), (0.0,), "ab", np.zeros(2, bool)):
        with pytest.raises(ValueError, match="action = "):
            env.step(action)


@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
@pytest.mark.parametrize(
    ("base", "arguments"),
    [
        ("feedforward+tvlqr", {"reference": SHORT, "plant": "lab", "start_spread_deg": 3.0}),
        ("kalman-lqr", {"reference": SHORT, "plant": "lab", "start_spread_deg": 3.0, "random_start": True}),
        ("lag-lqr", SAMPLED),
        ("nmpc", {"reference": SHORT, "plant": "lab", "start_spread_deg": 3.0, "random_start": True}),
        ("residual", {"reference": SHORT, "plant": "lab", "start_spread_deg": 3.0, "random_start": True}),
    ],
)
def test_each_of_many_flies_as_if_alone(mode, base, arguments):
    n, rng = 3, np.random.default_rng(0)
    together = VectorResidualAction(gym.make_vec("Heli3DOF-v0", n, autoreset_mode=mode, **arguments), base)
    apart = gym.make_vec(
        "Heli3DOF-v0",
        n,
        vectorization_mode="sync",
        wrappers=[lambda env: ResidualAction(env, base)],
        vector_kwargs={"autoreset_mode": mode},
        **arguments,
    )
    assert together.single_observation_space == apart.single_observation_space
    (a, info), (b, expected) = together.reset(seed=5), apart.reset(seed=5)
    assert_allclose(a, b, atol=1e-6)
    assert set(info) == set(expected)
    ends = 0
    for _ in range(400):
        actions = rng.uniform(-0.3, 0.3, (n, 2)).astype(np.float32)
        (a, *ours, info), (b, *theirs, expected) = together.step(actions), apart.step(actions)
        assert_allclose(a, b, atol=1e-5)
        for mine, other in zip(ours, theirs):
            assert_allclose(mine, other, atol=1e-9)
        assert set(info) == set(expected)
        if "final_obs" in info:
            for mine, other in zip(info["final_obs"], expected["final_obs"]):
                assert (mine is None) == (other is None)
                if mine is not None:
                    assert_allclose(mine, other, atol=1e-5)
        ends += int((ours[1] | ours[2]).sum())
    assert ends >= n


def test_helicopters_that_are_reset_by_hand_begin_anew_and_the_others_fly_on():
    arguments = {"reference": SHORT, "plant": "lab"}
    envs = VectorResidualAction(gym.make_vec("Heli3DOF-v0", 3, autoreset_mode="Disabled", **arguments), "kalman-lqr")
    envs.reset(seed=0)
    for _ in range(30):
        before = envs.step(np.zeros((3, 2)))
    mask = np.array([False, True, False])
    after, _ = envs.reset(seed=7, options={"reset_mask": mask})
    assert_allclose(after[~mask], before[0][~mask])
    alone = ResidualAction(gym.make("Heli3DOF-v0", **arguments), "kalman-lqr")
    observation, _ = alone.reset(seed=8)
    for _ in range(30):
        assert_allclose(after[1], observation, atol=1e-6)
        after, *_ = envs.step(np.zeros((3, 2)))
        observation, *_ = alone.step(np.zeros(2))


@pytest.mark.parametrize("rig", ["quanser", "ntnu"])
def test_the_base_is_made_for_the_rig_of_the_environment(rig):
    arguments = {"rig": rig, "reference": "climb-7.5"}
    env = ResidualAction(gym.make("Heli3DOF-v0", **arguments))
    steps = flight(env, 0, np.zeros(2, np.float32))
    assert steps[-1][1]["is_success"]
    envs = VectorResidualAction(gym.make_vec("Heli3DOF-v0", 2, **arguments))
    envs.reset(seed=0)
    for _ in range(len(steps) - 1):
        *_, info = envs.step(np.zeros((2, 2)))
    assert info["is_success"].all()


@pytest.mark.parametrize("base", ["kalman-lqr", "adaptive-lqr", "l1-adaptive", "lag-lqr+safe"])
def test_without_a_whole_period_of_delay_zero_flies_the_base_bit_for_bit(base):
    rig = replace(PAPER, delay=0.002)
    reference = replace(SHORT, rig=rig)
    expected = fly(gym.make("Heli3DOF-v0", rig=rig, reference=reference), make_policy(base, reference), seed=3)
    steps = flight(ResidualAction(gym.make("Heli3DOF-v0", rig=rig, reference=reference), base), 3, np.zeros(2))
    assert_array_equal(np.array([info["state"] for _, info in steps]).T, expected.x)


@pytest.mark.parametrize("base", ["feedforward+tvlqr", "kalman-lqr", "adaptive-lqr", "l1-adaptive", "lag-lqr+safe"])
def test_a_learned_policy_corrects_the_base_as_the_wrapper_did_in_training(base):
    action = np.array([0.2, -0.1], np.float32)
    env = ResidualAction(gym.make("Heli3DOF-v0", plant="lab", reference=SHORT), base, authority=2.0)
    learned = ResidualPolicy(make_policy(base, SHORT), SHORT, lambda features: action.astype(float), 2.0)
    flown = fly(gym.make("Heli3DOF-v0", plant="lab", reference=SHORT), learned, seed=3)
    steps = flight(env, 3, action)
    assert_allclose(np.array([info["state"] for _, info in steps]).T, flown.x, atol=1e-6)
