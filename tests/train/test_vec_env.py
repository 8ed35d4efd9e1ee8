"""`HeliVecEnv` is equivalent to `make_vec_env` for clients of Stable-Baselines3."""

import pickle

import gymnasium as gym
import numpy as np
import pytest

pytest.importorskip("torch")
pytest.importorskip("stable_baselines3")

from numpy.testing import assert_allclose, assert_array_equal
from stable_baselines3 import PPO
from stable_baselines3.common.env_util import make_vec_env
from stable_baselines3.common.evaluation import evaluate_policy
from stable_baselines3.common.vec_env import VecFrameStack, VecMonitor, VecNormalize

import heli_gym  # noqa: F401, registers Heli3DOF-v0
from heli_gym.baselines import VectorResidualAction, make_policy
from heli_gym.baselines.control.residual import ResidualPolicy
from heli_gym.env import find_reference
from heli_gym.plant import PLANTS
from heli_gym.train.vec_env import HeliVecEnv, ResidualVecEnv

SHORT = {"reference": "climb-7.5", "plant": "lab", "start_spread_deg": 3.0}


def native(n=3, **arguments):
    return HeliVecEnv(gym.make_vec("Heli3DOF-v0", n, autoreset_mode="SameStep", **(SHORT | arguments)))


def usual(n=3, **arguments):
    return make_vec_env("Heli3DOF-v0", n, env_kwargs=SHORT | arguments)


class Constant:
    """A model that always acts alike."""

    def __init__(self, action):
        self.action = np.array(action, np.float32)

    def predict(self, observation, state=None, episode_start=None, deterministic=True):
        return np.tile(self.action, (len(observation), 1)), state


@pytest.mark.parametrize("action", [(0.0, 0.0), (0.1, -0.1)])
def test_steps_infos_and_episodes_are_those_of_make_vec_env(action):
    ours, theirs = native(), usual()
    for vec in (ours, theirs):
        vec.seed(4)
    assert_array_equal(ours.reset(), theirs.reset())
    assert [set(info) - {"TimeLimit.truncated"} for info in ours.reset_infos] == [set(i) for i in theirs.reset_infos]
    ends = 0
    for _ in range(300):
        actions = np.tile(np.array(action, np.float32), (3, 1))
        (a, r, done, infos), (b, s, over, expected) = ours.step(actions), theirs.step(actions)
        assert_allclose(a, b, rtol=0, atol=1e-6)
        assert_allclose(r, s, rtol=0, atol=1e-7)
        assert r.dtype == s.dtype == np.float32
        assert_array_equal(done, over)
        for info, other in zip(infos, expected):
            assert set(info) == set(other)
            for key in set(info) - {"episode"}:
                assert_allclose(info[key], other[key], rtol=0, atol=1e-6, err_msg=key)
            if "episode" in info:
                ends += 1
                assert info["episode"]["l"] == other["episode"]["l"]
                assert info["episode"]["r"] == pytest.approx(other["episode"]["r"], abs=2e-5)
    assert ends >= 3


@pytest.mark.filterwarnings("ignore:The environment is already wrapped with a `Monitor`")
def test_evaluate_policy_reports_the_same_as_for_make_vec_env():
    found = []
    for vec in (native(), usual(), VecMonitor(native())):
        vec.seed(0)
        found.append(evaluate_policy(Constant((0.0, 0.0)), vec, n_eval_episodes=6, return_episode_rewards=True))
    for returns, lengths in found[1:]:
        assert_allclose(returns, found[0][0], atol=2e-5)
        assert lengths == found[0][1]
    assert max(found[0][0]) < 5.0  # seconds on the reference, of 5


def test_options_are_those_of_each_helicopter():
    vec = native()
    start = find_reference("climb-7.5").x[:, 0]
    vec.set_options([{"state": start + 0.1}, {}, {"state": start - 0.1, "plant": "nominal"}])
    vec.reset()
    states = [info["state"] for info in vec.reset_infos]
    assert_allclose(states[0], start + 0.1), assert_allclose(states[2], start - 0.1)
    assert np.abs(states[1] - start).max() <= np.radians(3.0)
    assert [plant.sensors is None for plant in vec.get_attr("drawn_plant")] == [False, False, True]
    vec.reset()  # options are for one reset
    assert [plant.sensors is None for plant in vec.get_attr("drawn_plant")] == [False] * 3
    vec.set_options([{"moon": 1}, {}, {}])
    with pytest.raises(ValueError, match="options"):
        vec.reset()


def test_attributes_and_methods_are_those_of_single_environments():
    ours, theirs = native(), usual()
    for vec in (ours, theirs):
        vec.seed(1)
        vec.reset()
    for name in ("plant", "drawn_plant", "control_period", "voltage_limits", "pitch_limit", "np_random_seed", "rig"):
        assert ours.get_attr(name) == theirs.get_attr(name), name
    assert_array_equal(ours.get_attr("reference")[0].x, theirs.get_attr("reference")[0].x)
    assert ours.get_attr("plant", [1]) == [PLANTS["lab"]]
    assert ours.get_attr("spec")[0].max_episode_steps == theirs.get_attr("spec")[0].max_episode_steps == 250
    for a, b in zip(
        ours.env_method("to_action", (7.0, 8.0), indices=[0, 2]), theirs.env_method("to_action", (7.0, 8.0))
    ):
        assert_array_equal(a, b)
    assert len(ours.env_method("to_action", (7.0, 8.0), indices=1)) == 1
    with pytest.raises(AttributeError):
        ours.env_method("reset")
    with pytest.raises(NotImplementedError):
        ours.set_attr("pitch_limit", 1.0)


def test_wrapped_vector_environments_are_accepted_and_others_refused():
    envs = gym.make_vec("Heli3DOF-v0", 2, autoreset_mode="SameStep", max_episode_steps=10)
    wrapped = gym.wrappers.vector.TransformReward(VectorResidualAction(envs), lambda reward: 2.0 * reward)
    vec = HeliVecEnv(wrapped)
    vec.seed(0)
    assert vec.reset().shape == (2, 50)
    rewards = 0.0
    for _ in range(10):
        _, reward, done, infos = vec.step(np.zeros((2, 2), np.float32))
        rewards += reward
    assert_allclose(rewards, 2.0 * 0.2, rtol=1e-3)  # the base tracks
    assert done.all() and all(info["TimeLimit.truncated"] for info in infos)
    assert infos[0]["terminal_observation"].shape == (50,) and infos[0]["base_voltage"].shape == (2,)
    assert_allclose([info["episode"]["r"] for info in infos], rewards, rtol=1e-6)
    with pytest.raises(ValueError, match="Heli3DOF"):
        HeliVecEnv(gym.make_vec("CartPole-v1", 2))
    with pytest.raises(ValueError, match="reward_unit = 0"):
        HeliVecEnv(envs, reward_unit=0.0)


def test_the_form_for_training_scales_rewards_and_spreads_the_first_flights():
    envs = gym.make_vec("Heli3DOF-v0", 4, autoreset_mode="SameStep")
    vec = HeliVecEnv(envs, spread=True, reward_unit=0.02, sparse_infos=True)
    plain = HeliVecEnv(gym.make_vec("Heli3DOF-v0", 4, autoreset_mode="SameStep"), spread=True)
    vec.reset(), plain.reset()
    assert_allclose([info["time"] for info in vec.reset_infos], [0.0, 2.5, 5.0, 7.5])
    (_, ours, _, infos), (_, theirs, *_) = (one.step(np.zeros((4, 2), np.float32)) for one in (vec, plain))
    assert_allclose(ours, theirs / 0.02, rtol=1e-6)
    assert infos == [{}] * 4


@pytest.mark.filterwarnings("ignore:The environment is already wrapped with a `Monitor`")
def test_wrappers_and_learners_of_stable_baselines_work_on_it():
    vec = VecNormalize(VecMonitor(VecFrameStack(native(), 2)))
    agent = PPO("MlpPolicy", vec, n_steps=16, batch_size=48, n_epochs=1, device="cpu").learn(96)
    assert agent.observation_space.shape == (96,)


def test_helicopters_spread_over_the_maneuver_begin_it_in_a_given_state():
    vec = HeliVecEnv(gym.make_vec("Heli3DOF-v0", 4, autoreset_mode="SameStep"), spread=True)
    start = vec.core.references[0].x[:, 0] + 0.1
    vec.set_options([{}, {"state": start}, {}, {}])
    vec.reset()
    assert_array_equal(vec.info["state"][1], start)
    assert vec.info["time"][1] == 0.0 and np.all(vec.info["time"][2:] > 0.0)


def test_a_model_saved_on_one_plant_is_loaded_on_another_rig_plant_and_reference(tmp_path):
    PPO("MlpPolicy", gym.make("Heli3DOF-v0"), n_steps=16, batch_size=16, n_epochs=1, device="cpu").learn(16).save(
        tmp_path / "model.zip"
    )
    for arguments in (
        {"plant": "lab"},
        {"plant": "rigid", "reference": "elevation-sine", "control_period": 0.05},
        {"reference": "take-off", "pitch_limit": 1.5, "voltage_limits": (-24.0, 24.0)},
    ):
        for env in (gym.make("Heli3DOF-v0", **arguments), native(2, **arguments)):
            agent = PPO.load(tmp_path / "model.zip", env=env, device="cpu")
            agent.learn(16)


@pytest.mark.parametrize("bad", [np.nan, np.inf, "x"])
def test_refused_actions_change_neither_helicopters_nor_the_memory_of_the_corrected_policy(bad):
    envs = gym.make_vec("Heli3DOF-v0", 2, autoreset_mode="SameStep", **SHORT).unwrapped
    reference = find_reference("climb-7.5")
    policy = ResidualPolicy(make_policy("lqi", reference), reference, None, 1.0)
    vec = ResidualVecEnv(envs, policy)
    vec.reset()
    before = pickle.dumps((policy.memory, envs.simulation.blocks))
    vec.step_async(np.array([[0.0, bad], [0.0, 0.0]]))
    with pytest.raises(ValueError, match="actions = "):
        vec.step_wait()
    assert pickle.dumps((policy.memory, envs.simulation.blocks)) == before
