"""Gymnasium wrappers that other libraries rely on."""

import gymnasium as gym
import pytest

torch = pytest.importorskip("torch")
pytest.importorskip("array_api_compat")

import heli_gym  # noqa: E402, F401, registers Heli3DOF-v0


@pytest.mark.parametrize("plant", ["nominal", "lab"])
def test_observations_and_infos_become_tensors(plant):
    env = gym.wrappers.NumpyToTorch(gym.make("Heli3DOF-v0", plant=plant))
    observation, info = env.reset(seed=0)
    for _ in range(3):
        assert isinstance(observation, torch.Tensor) and isinstance(info["state"], torch.Tensor)
        observation, *_, info = env.step(torch.zeros(2))


def test_those_of_many_helicopters_too():
    envs = gym.wrappers.vector.NumpyToTorch(gym.make_vec("Heli3DOF-v0", 3, plant="lab"))
    observation, info = envs.reset(seed=0)
    for _ in range(3):
        assert observation.shape == (3, 48) and isinstance(info["state"], torch.Tensor)
        observation, *_, info = envs.step(torch.zeros(3, 2))
