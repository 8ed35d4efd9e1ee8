import gymnasium as gym
import numpy as np
import pytest
from gymnasium.vector import AutoresetMode, SyncVectorEnv
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym.env import Heli3DOFEnv
from heli_gym.plant import Gust, Plant, Push, RotorFault, Sensors
from heli_gym.vector_env import Heli3DOFVectorEnv

GUSTY = Plant(
    sensors=Sensors(noise=0.002),
    disturbances=(Gust("pitch", 0.5), Push("travel", 0.3, 1.0), RotorFault("back", 0.2, 2.0)),
)
ARGUMENTS = [
    {},
    {"start_spread_deg": 5.0, "plant": "lab"},
    {"random_start": True, "plant": "rigid"},
    {"plant": GUSTY, "control_period": 0.05},
]


def assert_same(actual, expected, where):
    assert set(actual) == set(expected), where
    for name, value in expected.items():
        if isinstance(value, dict):
            assert_same(actual[name], value, f"{where}.{name}")
        elif value.dtype == object and name == "final_obs":
            for a, b in zip(actual[name], value):
                assert (a is None) == (b is None), f"{where}.{name}"
                if b is not None:
                    assert_allclose(a, b, atol=1e-6, err_msg=f"{where}.{name}")
        elif value.dtype == object:
            assert list(actual[name]) == list(value), f"{where}.{name}"
        elif value.dtype == bool:
            assert_array_equal(actual[name], value, err_msg=f"{where}.{name}")
        else:
            assert_allclose(actual[name], value, rtol=0, atol=1e-12, err_msg=f"{where}.{name}")


@pytest.mark.parametrize("mode", [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP])
@pytest.mark.parametrize("arguments", ARGUMENTS, ids=["nominal", "lab", "rigid", "gusty"])
def test_each_helicopter_flies_what_a_single_environment_with_its_seed_flies(mode, arguments):
    n, rng = 3, np.random.default_rng(0)
    together = Heli3DOFVectorEnv(n, autoreset_mode=mode, **arguments)
    apart = SyncVectorEnv([lambda: Heli3DOFEnv(**arguments)] * n, autoreset_mode=mode)
    (observation, info), (expected, expected_info) = together.reset(seed=5), apart.reset(seed=5)
    assert_array_equal(observation, expected)
    assert_same(info, expected_info, "reset")
    ends = 0
    for k in range(700):
        actions = rng.uniform(0.1, 0.55, (n, 2))
        actual, expected = together.step(actions), apart.step(actions)
        assert_allclose(actual[0], expected[0], rtol=0, atol=1e-6)
        for a, b in zip(actual[1:4], expected[1:4]):
            assert_allclose(a, b, rtol=0, atol=1e-12)
        without_plant = {key: v for key, v in expected[4].items() if key not in ("plant", "_plant")}
        if "final_info" in without_plant:
            without_plant["final_info"] = {
                key: v for key, v in without_plant["final_info"].items() if key not in ("plant", "_plant")
            }
        for name in set(actual[4]) - set(without_plant):
            assert name in ("voltage", "cost", "_voltage", "_cost") and not actual[4][f"_{name.strip('_')}"].any()
        shown = {key: v for key, v in actual[4].items() if key in without_plant}
        assert_same(shown, without_plant, f"step {k}")
        ends += int((actual[2] | actual[3]).sum())
    assert ends >= n
