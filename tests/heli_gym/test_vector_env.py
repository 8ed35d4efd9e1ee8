import copy
import pickle

import gymnasium as gym
import numpy as np
import pytest
from gymnasium.vector import AutoresetMode, SyncVectorEnv
from independent import EitherReference
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym import on_rig
from heli_gym.env import Heli3DOFEnv
from heli_gym.plant import PLANTS, Gust, Plant, Push, RotorFault, Sensors
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
    {"plant": "lab", "reference": EitherReference(), "random_start": True, "start_spread_deg": 2.0},
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
@pytest.mark.parametrize("arguments", ARGUMENTS, ids=["nominal", "lab", "rigid", "gusty", "drawn references"])
def test_each_helicopter_flies_like_a_single_environment_with_its_seed(mode, arguments):
    n, rng = 3, np.random.default_rng(0)
    together = Heli3DOFVectorEnv(n, autoreset_mode=mode, **arguments)
    apart = SyncVectorEnv([lambda: Heli3DOFEnv(**arguments)] * n, autoreset_mode=mode)
    (observation, info), (expected, expected_info) = together.reset(seed=5), apart.reset(seed=5)
    assert_array_equal(observation, expected)
    assert_same(info, expected_info, "reset")
    ends = 0
    for k in range(700):
        actions = rng.uniform(-0.2, 0.2, (n, 2))
        actual, expected = together.step(actions), apart.step(actions)
        assert_allclose(actual[0], expected[0], rtol=0, atol=1e-6)
        for a, b in zip(actual[1:4], expected[1:4]):
            assert_allclose(a, b, rtol=0, atol=1e-12)
        assert_same(actual[4], expected[4], f"step {k}")
        ends += int((actual[2] | actual[3]).sum())
    assert ends >= n


@pytest.mark.parametrize("plant", PLANTS)
def test_each_of_many_flies_bit_for_bit_like_a_single_environment(plant):
    n, actions = 37, np.random.default_rng(0).uniform(-0.2, 0.2, (50, 37, 2))
    together = Heli3DOFVectorEnv(n, plant, start_spread_deg=5.0)
    together.reset(seed=0)
    flown = np.array([together.step(action)[4]["state"].copy() for action in actions])
    for j in (0, n - 1):
        alone = Heli3DOFEnv(plant, start_spread_deg=5.0)
        alone.reset(seed=j)
        assert_array_equal([alone.step(action[j])[4]["state"].copy() for action in actions], flown[:, j])


def test_make_vec_makes_the_native_one():
    envs = gym.make_vec("heli_gym:Heli3DOF-v0", num_envs=3, autoreset_mode="SameStep")
    assert isinstance(envs.unwrapped, Heli3DOFVectorEnv)
    assert envs.metadata["autoreset_mode"] is AutoresetMode.SAME_STEP
    observation, _ = envs.reset(seed=0)
    assert envs.observation_space.contains(observation)


def test_a_masked_reset_starts_only_the_masked_helicopters():
    envs = Heli3DOFVectorEnv(4, plant="lab", reference="travel-90-climb", autoreset_mode="Disabled")
    mask = np.array([True, False, False, True])
    envs.reset(seed=0)
    before = envs.step(np.full((4, 2), 0.3))
    observation, info = envs.reset(options={"reset_mask": mask})
    assert_array_equal(observation[~mask], before[0][~mask])
    assert_array_equal(info["time"], np.where(mask, 0.0, 0.02))
    assert_array_equal(info["_state"], mask)
    assert_array_equal(info["voltage"], np.where(mask, 0.0, before[4]["voltage"].T).T)


def test_a_flight_that_is_over_has_to_be_reset_where_nothing_does_it():
    envs = Heli3DOFVectorEnv(2, autoreset_mode=AutoresetMode.DISABLED)
    envs.reset(seed=0)
    over = np.zeros(2, bool)
    while not over.any():
        _, _, terminated, truncated, _ = envs.step(np.array([[0.3, 0.3], [1.0, -1.0]]))
        over = terminated | truncated
    with pytest.raises(gym.error.ResetNeeded, match=r"\[1\]"):
        envs.step(np.zeros((2, 2)))
    envs.reset(options={"reset_mask": over})
    envs.step(np.zeros((2, 2)))


def test_arrays_that_are_handed_out_are_not_written_again():
    envs = Heli3DOFVectorEnv(2, plant="lab", start_spread_deg=3.0)
    first = envs.reset(seed=0)
    kept = [first[0].copy(), first[1]["state"].copy()]
    second = envs.step(np.zeros((2, 2)))
    kept += [second[0].copy(), second[4]["state"].copy()]
    for _ in range(10):
        envs.step(np.ones((2, 2)))
    for array, before in zip((first[0], first[1]["state"], second[0], second[4]["state"]), kept):
        assert_array_equal(array, before)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Heli3DOFVectorEnv(0), "num_envs = 0"),
        (lambda: Heli3DOFVectorEnv(2.0), "num_envs = 2.0"),
        (lambda: Heli3DOFVectorEnv(2, dtype="float16"), "dtype = 'float16'"),
        (lambda: Heli3DOFVectorEnv(2, autoreset_mode="Never"), "autoreset_mode = 'Never'"),
        (lambda: Heli3DOFVectorEnv(2, render_mode="human"), "render_mode = 'human'"),
        (lambda: Heli3DOFVectorEnv(2, plant=["lab"]), "plant: 1 values"),
        (lambda: Heli3DOFVectorEnv(2, plant=["lab", "rigid"]), "either all plants"),
        (lambda: Heli3DOFVectorEnv(2, reference="moon"), "reference = 'moon'"),
        (lambda: Heli3DOFVectorEnv(10**400), "num_envs = 1000"),
        (lambda: Heli3DOFVectorEnv(2**31), "num_envs = 2147483648"),
        (lambda: Heli3DOFVectorEnv(2, max_episode_steps=0), "max_episode_steps = 0"),
        (lambda: Heli3DOFVectorEnv(2).reset(options=5), "options = 5"),
        (lambda: Heli3DOFVectorEnv(2).reset(options={"mask": 1}), "options = .*'state'"),
        (lambda: Heli3DOFVectorEnv(2).reset(options={"reset_mask": np.zeros(2, bool)}), "reset_mask"),
        (lambda: Heli3DOFVectorEnv(2).reset(options={"reset_mask": np.ones(3, bool)}), "reset_mask"),
        (lambda: Heli3DOFVectorEnv(2).reset(options={"plant": ["lab"]}), "options\\['plant'\\]: 1 values"),
        (lambda: Heli3DOFVectorEnv(2).reset(options={"state": [10**400] * 6}), "options\\['state'\\]"),
        (lambda: Heli3DOFVectorEnv(2).reset(seed=-1), "seed = -1"),
        (lambda: Heli3DOFVectorEnv(2).reset(seed=[1, -2]), "seed = -2"),
        (lambda: Heli3DOFVectorEnv(2).reset(seed=1.5), "seed = 1.5"),
        (lambda: Heli3DOFVectorEnv(2).reset(seed=[1, 1.5]), "seed = 1.5"),
        (lambda: Heli3DOFVectorEnv(2).reset(options={"state": np.full(6, 9.0)}), "options\\['state'\\]"),
        (lambda: Heli3DOFVectorEnv(2).reset(options={"time": [0.0]}), "options\\['time'\\]"),
        (lambda: Heli3DOFVectorEnv(2).reset(seed=[1, 2, 3]), "seed = "),
    ],
)
def test_unknown_names_are_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


@pytest.mark.parametrize(
    ("actions", "message"),
    [
        (np.zeros(2), "actions have shape"),
        (np.zeros((2, 2), bool), "actions = "),
        (np.zeros((2, 2), complex), "actions = "),
        ([["0", "0"], ["0", "0"]], "actions = "),
        ([[10**400, 0], [0, 0]], "actions = "),
        (np.zeros((3, 2)), "actions have shape"),
        (np.array([[0.0, 0.0], [np.nan, 0.0]]), r"actions\[1\]"),
        (np.array([[0.0, np.inf], [0.0, 0.0]], np.float32), r"actions\[0\]"),
    ],
)
def test_bad_actions_are_refused_by_name(actions, message):
    envs = Heli3DOFVectorEnv(2)
    envs.reset(seed=0)
    with pytest.raises(ValueError, match=message):
        envs.step(actions)


def test_stepping_before_a_reset_is_refused():
    with pytest.raises(gym.error.ResetNeeded):
        Heli3DOFVectorEnv(2).step(np.zeros((2, 2)))


def test_changing_the_measurement_that_was_handed_out_does_not_change_the_state():
    envs = Heli3DOFVectorEnv(3)
    for info in (envs.reset(seed=0)[1], envs.step(np.full((3, 2), 0.3))[4]):
        state = info["state"].copy()
        info["measurement"] += 1.0
        assert_array_equal(info["state"], state)


def test_helicopters_with_the_same_sampler_fly_references_of_their_own_which_end_when_they_do():
    sampler = EitherReference()
    envs = Heli3DOFVectorEnv(8, reference=sampler, autoreset_mode="SameStep", pitch_limit=1.5)
    with pytest.raises(gym.error.ResetNeeded, match="drawn"):
        envs.reference_of(0)
    envs.reset(seed=0)
    expected = [sampler(np.random.default_rng(seed)).duration for seed in range(8)]
    assert [envs.reference_of(i).duration for i in range(8)] == expected and len(set(expected)) == 2
    ends = np.zeros(8)
    for k in range(1, 351):
        u = np.array([envs.reference_of(i)(0.02 * k - 0.01)[1] for i in range(8)])
        *_, truncated, _ = envs.step(envs.to_action(u))
        ends[truncated & (ends == 0.0)] = 0.02 * k
    assert_allclose(ends, expected)


def test_a_reset_of_some_renews_their_references_only():
    envs = Heli3DOFVectorEnv(6, reference=EitherReference(), autoreset_mode="Disabled")
    envs.reset(seed=0)
    before = [envs.reference_of(i) for i in range(6)]
    mask = np.arange(6) == 2
    for seed in range(4):
        observation, _ = envs.reset(seed=seed, options={"reset_mask": mask})
        expected = EitherReference()(np.random.default_rng(seed + 2))
        assert_array_equal(envs.reference_of(2).x, expected.x)
        assert_allclose(observation[2, 47], expected.duration / 10.0, rtol=1e-6)
        assert all(envs.reference_of(i) is before[i] for i in range(6) if i != 2)


@pytest.mark.parametrize("mode", ["NextStep", "SameStep", "Disabled"])
def test_changing_any_array_that_was_handed_out_changes_no_flight(mode):
    flights = []
    for scribble in (False, True):
        envs = Heli3DOFVectorEnv(4, "lab", "climb-7.5", autoreset_mode=mode, start_spread_deg=5.0, pitch_limit=0.3)
        mask = np.ones(4, bool)
        outputs = envs.reset(seed=0, options={"reset_mask": mask})
        seen, rng = [], np.random.default_rng(0)
        for _ in range(200):
            if scribble:
                flat = [value for part in outputs for value in (part.values() if isinstance(part, dict) else [part])]
                for array in flat:
                    if isinstance(array, np.ndarray) and array.dtype != object and array.flags.writeable:
                        array[...] = 1
                mask[:] = False
            if mode == "Disabled" and envs.is_waiting:
                envs.reset(seed=1, options={"reset_mask": envs.over.copy()})
            outputs = envs.step(rng.uniform(-0.25, 0.25, (4, 2)))
            seen.append((outputs[0].copy(), outputs[2].copy()))
        flights.append(seen)
    for (a, over), (b, other) in zip(*flights):
        assert_array_equal(a, b)
        assert_array_equal(over, other)


def test_flights_continue_after_a_failed_reset():
    envs = Heli3DOFVectorEnv(2)
    with pytest.raises(ValueError, match="state"):
        envs.reset(options={"state": np.full(6, 50.0)})
    with pytest.raises(gym.error.ResetNeeded):
        envs.step(np.zeros((2, 2)))
    envs.reset(seed=0)
    with pytest.raises(ValueError, match="state"):
        envs.reset(options={"state": np.full(6, 50.0), "plant": "lab"})
    *_, info = envs.step(np.zeros((2, 2)))
    assert_allclose(info["time"], 0.02)


@pytest.mark.parametrize("seed", [np.int64(3), np.array([3, 4]), [3, 4], (3, 4)])
def test_seeds_may_be_numpy_numbers(seed):
    envs = Heli3DOFVectorEnv(np.int64(2), start_spread_deg=5.0)
    expected, _ = Heli3DOFVectorEnv(2, start_spread_deg=5.0).reset(seed=3)
    assert_array_equal(envs.reset(seed=seed)[0], expected)


def test_an_action_that_single_precision_cannot_hold_saturates_as_in_double():
    for dtype in ("float32", "float64"):
        envs = Heli3DOFVectorEnv(2, dtype=dtype)
        envs.reset(seed=0)
        *_, info = envs.step(np.array([[0.0, 0.0], [1e39, -1e300]]))
        assert_array_equal(info["voltage"][1], [12.0, 0.0])


@pytest.mark.parametrize("reset_mask", [[True, False], np.array([1, 0])])
def test_a_mask_that_is_no_boolean_array_is_a_type_error_as_in_gymnasium(reset_mask):
    with pytest.raises(TypeError, match="reset_mask"):
        Heli3DOFVectorEnv(2).reset(options={"reset_mask": reset_mask})


@pytest.mark.parametrize(
    "arguments",
    [
        {"options": {"state": np.full(6, 9.0)}},
        {"seed": 9, "options": {"state": np.full(6, 9.0)}},
        {"seed": 9, "options": {"state": np.full(6, 9.0), "plant": "nominal"}},
        {"options": {"plant": "moon"}},
        {"seed": [8, -1]},
    ],
    ids=str,
)
def test_a_refused_reset_changes_nothing(arguments):
    envs, untouched = (Heli3DOFVectorEnv(2, "lab", EitherReference(), start_spread_deg=3.0) for _ in range(2))
    for both in (envs, untouched):
        both.reset(seed=1)
    with pytest.raises(ValueError):
        envs.reset(**arguments)
    assert [envs.plant_of(i) for i in range(2)] == [untouched.plant_of(i) for i in range(2)]
    assert envs.np_random_seed == untouched.np_random_seed == (1, 2)
    actions = np.full((2, 2), 0.01)
    assert_array_equal(envs.step(actions)[0], untouched.step(actions)[0])
    assert_array_equal(envs.reset()[0], untouched.reset()[0])


def test_random_generators_are_those_of_single_environments():
    envs = gym.make_vec("Heli3DOF-v0", 3, plant="lab")
    apart = gym.make_vec("Heli3DOF-v0", 3, plant="lab", vectorization_mode="sync")
    for both in (envs, apart):
        both.reset(seed=5)
    assert envs.unwrapped.np_random_seed == apart.np_random_seed == (5, 6, 7)
    generators = tuple(np.random.default_rng(seed) for seed in range(3))
    envs.unwrapped.np_random = generators
    assert envs.unwrapped.np_random_seed == (-1, -1, -1)
    envs.reset()
    plants = [envs.unwrapped.plant_of(i) for i in range(3)]
    for i, env in enumerate(apart.envs):
        env.unwrapped.np_random = np.random.default_rng(i)
        env.reset()
        assert env.unwrapped.drawn_plant == plants[i]
    with pytest.raises(ValueError, match="np_random"):
        envs.unwrapped.np_random = generators[:2]


def test_each_helicopter_may_have_a_state_of_its_own_or_none_and_a_plant_of_its_own():
    envs = Heli3DOFVectorEnv(3, start_spread_deg=3.0)
    states = np.array([[0.1] * 6, [np.nan] * 6, [-0.2] * 6])
    free = envs.reset(seed=3)[1]["state"]
    _, info = envs.reset(seed=3, options={"state": states, "plant": ["lab", "nominal", Plant()]})
    assert_array_equal(info["state"], [states[0], free[1], states[2]])
    assert envs.plant_of(0).sensors is not None and envs.plant_of(1).sensors is None
    with pytest.raises(ValueError, match="state"):
        envs.reset(options={"state": np.full(6, np.nan)})
    with pytest.raises(ValueError, match="state"):
        envs.reset(options={"state": [[0.0] * 5 + [np.nan]] * 3})


def test_a_given_state_is_one_at_the_given_time_or_else_at_the_start():
    envs = Heli3DOFVectorEnv(2, random_start=True)
    reference, times = envs.reference_of(0), np.array([5.0, 2.0])
    states = reference(times)[0].T + 0.1
    _, info = envs.reset(seed=0, options={"state": states, "time": times})
    assert_array_equal(info["state"], states)
    assert_allclose(info["time"], times)
    with pytest.raises(ValueError, match="at the start"):
        envs.reset(options={"state": states})
    _, info = envs.reset(seed=0, options={"state": np.array([reference.x[:, 0] + 0.1, [np.nan] * 6])})
    assert info["time"][0] == 0.0 and info["time"][1] > 0.0


@pytest.mark.parametrize("plants", [["lab", "fleet"], ["fleet", "lab"]])
def test_helicopters_on_different_rigs_are_refused_because_they_share_an_amplifier(plants):
    with pytest.raises(ValueError, match=r"rigs .*'fleet'.*must be one"):
        Heli3DOFVectorEnv(2, plant=plants)


@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
def test_flights_end_at_the_most_steps_of_an_episode_as_with_gymnasiums_time_limit(mode):
    n, rng = 3, np.random.default_rng(0)
    arguments = {"plant": "lab", "random_start": True, "max_episode_steps": 50}
    together = gym.make_vec("Heli3DOF-v0", n, autoreset_mode=mode, **arguments)
    apart = gym.make_vec(
        "Heli3DOF-v0", n, vectorization_mode="sync", vector_kwargs={"autoreset_mode": AutoresetMode(mode)}, **arguments
    )
    assert together.spec.max_episode_steps == 50
    together.reset(seed=5), apart.reset(seed=5)
    cut = 0
    for _ in range(300):
        actions = rng.uniform(-0.1, 0.1, (n, 2))
        actual, expected = together.step(actions), apart.step(actions)
        for a, b in zip(actual[:4], expected[:4]):
            assert_allclose(a, b, rtol=0, atol=1e-6)
        assert_allclose(actual[4]["state"], expected[4]["state"], rtol=0, atol=1e-12)
        cut += int(actual[3].sum())
    assert cut > n


def test_vector_environments_are_copied_after_a_picture_was_drawn():
    pytest.importorskip("pygame")
    envs = Heli3DOFVectorEnv(2, render_mode="rgb_array")
    envs.reset(seed=0)
    pictures = envs.render()
    for other in (copy.deepcopy(envs), pickle.loads(pickle.dumps(envs))):
        assert_array_equal(other.render(), pictures)
        other.close()
    envs.close()


def test_a_helicopter_draws_no_more_beside_a_noisy_one():
    mixed = Heli3DOFVectorEnv(2, [Plant(), Plant(sensors=Sensors(noise=1e-3))], EitherReference())
    alone = Heli3DOFEnv(reference=EitherReference())
    mixed.reset(seed=0), alone.reset(seed=0)
    for _ in range(5):
        mixed.reset(), alone.reset()
        assert mixed.reference_of(0).duration == alone.reference.duration
    assert mixed.generators[0].random() == alone.np_random.random()


def test_no_flight_starts_beyond_the_pitch_limit():
    envs = Heli3DOFVectorEnv(300, start_spread_deg=5.0, random_start=True, pitch_limit=np.radians(50.0))
    for seed in range(3):
        _, info = envs.reset(seed=1000 * seed)
        assert np.abs(info["state"][:, 4]).max() <= np.radians(50.0)


def test_a_reference_that_all_fly_is_planned_again_once(monkeypatch):
    planned, replanned = [], on_rig.replanned
    monkeypatch.setattr(on_rig, "replanned", lambda *given: planned.append(1) or replanned(*given))
    Heli3DOFVectorEnv(20, "nominal", "travel-360", rig="quanser")
    assert len(planned) == 1
