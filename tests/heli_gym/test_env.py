"""Heli3DOF-v0: the border to Gymnasium, and the flight of equation (3) behind it."""

import copy
import hashlib
import inspect
import math
import pickle
import re
import subprocess
import sys
import warnings
from dataclasses import replace
from importlib.resources import files

import gymnasium as gym
import numpy as np
import pytest
from gymnasium.envs.registration import EnvSpec
from gymnasium.utils.env_checker import check_env
from hypothesis import given, settings
from hypothesis import strategies as st
from independent import EitherReference, equation_3, hover, inputs
from numpy.testing import assert_allclose, assert_array_equal
from scipy.integrate import solve_ivp

import heli_gym  # noqa: F401, registers Heli3DOF-v0
from heli_gym import HelicopterParameters, Trajectory
from heli_gym.baselines import ManeuverSampler, fly, make_policy
from heli_gym.env import REFERENCES, Heli3DOFEnv, find_reference
from heli_gym.plant import PLANTS, Plant, Push, Sensors
from heli_gym.validation import shown

REFERENCE = find_reference("travel-360")
VARIANTS = [{}, {"start_spread_deg": 5.0}, {"control_period": 0.03, "voltage_limits": (-1.0, 10.0), "pitch_limit": 0.9}]
RANDOM_MANEUVERS = Heli3DOFEnv(reference=ManeuverSampler())
CORNER = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0]  # rad and rad/s, as far from the default reference as a flight may start


def episode(env: gym.Env, seed: int, actions) -> list[tuple]:
    """(observation, reward, terminated, truncated, info) of the reset and of every step."""
    observation, info = env.reset(seed=seed)
    steps = [(observation, 0.0, False, False, info)]
    for action in actions:
        steps.append(env.step(action))
        if steps[-1][2] or steps[-1][3]:
            break
    return steps


def actions(seed: int, steps: int = 600, size: float = 0.1) -> np.ndarray:
    return np.random.default_rng(seed).uniform(-size, size, (steps, 2)).astype(np.float32)


def fingerprint(env: gym.Env) -> str:
    digest = hashlib.sha256()
    for observation, reward, terminated, truncated, info in episode(env, 3, actions(4)):
        digest.update(observation.tobytes() + info["state"].tobytes() + repr((reward, terminated, truncated)).encode())
    return digest.hexdigest()


def assert_same_flight(one: gym.Env, other: gym.Env) -> None:
    assert fingerprint(one) == fingerprint(other)


# Gymnasium's contract


@pytest.mark.parametrize("arguments", VARIANTS)
@pytest.mark.parametrize("checker", ["gymnasium.utils.env_checker", "stable_baselines3.common.env_checker"])
def test_the_checkers_are_content(checker, arguments):
    check = pytest.importorskip(checker).check_env
    env = gym.make("Heli3DOF-v0", **arguments)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check(env.unwrapped)


def test_a_step_returns_the_types_that_gymnasium_states():
    env = Heli3DOFEnv()
    for steps in (episode(env, 0, actions(0)), episode(env, 0, [(1.0, -1.0)] * 600)):
        for observation, reward, terminated, truncated, info in steps:
            assert observation.dtype == np.float32
            assert observation in env.observation_space
            assert [type(value) for value in (reward, terminated, truncated, info)] == [float, bool, bool, dict]


def test_observations_rewards_and_states_handed_out_are_not_changed_by_later_steps():
    env = Heli3DOFEnv()
    steps = episode(env, 0, actions(0, 20))
    before = copy.deepcopy(steps)
    for _ in range(20):
        env.step((0.01, -0.01))
    for now, then in zip(steps, before):
        assert_array_equal(now[0], then[0])
        assert_array_equal(now[4]["state"], then[4]["state"])


def test_changing_returned_values_does_not_change_the_flight():
    vandal, env = Heli3DOFEnv(), Heli3DOFEnv()
    observation, info = vandal.reset(seed=0)
    env.reset(seed=0)
    for _ in range(5):
        for array in (observation, info["state"], info["measurement"]):
            array[:] = 1e9
        observation, *_, info = vandal.step((0.01, -0.01))
        assert_array_equal(observation, env.step((0.01, -0.01))[0])


def test_changing_the_measurement_that_was_handed_out_does_not_change_the_state():
    env = Heli3DOFEnv()
    for info in (env.reset(seed=0)[1], env.step((0.01, -0.01))[4]):
        state = info["state"].copy()
        info["measurement"] += 1.0
        assert_array_equal(info["state"], state)


# Reproducibility


def test_the_same_seed_is_the_same_flight_bit_for_bit():
    env, other = (Heli3DOFEnv(start_spread_deg=5.0) for _ in range(2))
    assert_same_flight(env, other)
    assert_same_flight(env, other)  # after a flight too


def test_the_same_seed_is_the_same_flight_in_another_process():
    source = "\n".join(map(inspect.getsource, (episode, actions, fingerprint)))
    script = (
        f"import hashlib, gymnasium as gym, numpy as np\n{source}\n"
        "print(fingerprint(gym.make('heli_gym:Heli3DOF-v0', start_spread_deg=5.0)))"
    )
    child = subprocess.run([sys.executable, "-W", "error", "-c", script], capture_output=True, text=True)
    assert child.stderr == ""
    assert child.stdout.strip() == fingerprint(Heli3DOFEnv(start_spread_deg=5.0))


def test_starts_are_drawn_anew_within_the_spread_and_at_rest():
    env = Heli3DOFEnv(start_spread_deg=5.0)
    starts = np.array([env.reset(seed=seed)[1]["state"] for seed in range(200)])
    angles, rates = starts[:, 0::2], starts[:, 1::2]
    assert len({tuple(start) for start in starts}) == 200
    assert_array_equal(rates, 0.0)
    assert np.abs(angles).max() <= math.radians(5.0)
    # uniform on each axis: 200 draws come near both ends, and average to about zero
    assert (np.abs(angles.max(axis=0)) > math.radians(4.5)).all()
    assert (np.abs(angles.min(axis=0)) > math.radians(4.5)).all()
    assert np.abs(angles.mean(axis=0)).max() < math.radians(1.0)
    env.reset(seed=0)
    assert not np.array_equal(env.reset()[1]["state"], starts[0])


def test_without_a_spread_the_start_is_the_references():
    assert_array_equal(Heli3DOFEnv().reset(seed=1)[1]["state"], REFERENCE.x[:, 0])


def test_a_spec_survives_json_and_pickle():
    arguments = {"control_period": 0.01, "voltage_limits": (0.5, 11.5), "start_spread_deg": 4.0, "pitch_limit": 1.2}
    env = gym.make("heli_gym:Heli3DOF-v0", **arguments)
    for spec in (EnvSpec.from_json(env.spec.to_json()), pickle.loads(pickle.dumps(env.spec))):
        assert_same_flight(gym.make(spec), env)


def test_an_environment_is_copied_after_a_picture_was_drawn():
    pytest.importorskip("pygame")
    env = gym.make("Heli3DOF-v0", render_mode="rgb_array")
    env.reset(seed=0)
    picture = env.render()
    for other in (copy.deepcopy(env), pickle.loads(pickle.dumps(env.unwrapped))):
        assert_array_equal(other.render(), picture)
        other.close()
    env.close()


def test_an_environment_survives_pickle_and_copy_in_the_middle_of_a_flight():
    env = Heli3DOFEnv(start_spread_deg=5.0)
    episode(env, 0, actions(0, 50))
    copies = pickle.loads(pickle.dumps(env)), copy.deepcopy(env)
    onward = [env.step(action)[0] for action in actions(1, 20)]
    drawn_next = env.reset()[0]
    for other in copies:
        assert_array_equal([other.step(action)[0] for action in actions(1, 20)], onward)
        assert_array_equal(other.reset()[0], drawn_next)


@pytest.mark.parametrize(
    ("mode", "arguments"),
    [("sync", {}), ("async", {"context": "spawn"})],  # fresh processes, so that the spec has to carry everything
)
def test_vector_environments_fly_like_single_ones(mode, arguments):
    fleet = gym.make_vec(
        "heli_gym:Heli3DOF-v0", 2, vectorization_mode=mode, vector_kwargs=arguments, start_spread_deg=5.0
    )
    flown = actions(1, 40, size=1.0).reshape(20, 2, 2)
    singles = [episode(Heli3DOFEnv(start_spread_deg=5.0), 7 + n, flown[:, n]) for n in range(2)]
    try:
        observations, _ = fleet.reset(seed=7)
        assert_array_equal(observations, [single[0][0] for single in singles])
        for k, action in enumerate(flown, start=1):
            observations, rewards, terminated, truncated, info = fleet.step(action)
            assert_array_equal(observations, [single[k][0] for single in singles])
            assert_array_equal(rewards, [single[k][1] for single in singles])
            assert_array_equal(info["state"], [single[k][4]["state"] for single in singles])
            assert not (terminated | truncated).any()
    finally:
        fleet.close()


# What the docstring's tables say


def test_the_docstring_describes_every_entry_of_the_observation_and_every_argument():
    text = inspect.getdoc(Heli3DOFEnv)
    n = Heli3DOFEnv().observation_space.shape[0]
    assert f"`Box` of {n} float32 values" in text
    rows = re.findall(r"^\| (\d+)(?:-(\d+))? +\|", text.split("## Observation Space")[1].split("## Rewards")[0], re.M)
    assert [k for low, high in rows for k in range(int(low), int(high or low) + 1)] == list(range(n))
    described = re.findall(r"^- `(\w+)`:", text.split("## Arguments")[1].split("## Version")[0], re.M)
    assert described == list(inspect.signature(Heli3DOFEnv).parameters)


def packaged_samples() -> tuple[np.ndarray, np.ndarray]:
    """x (6, 2001) and u (2, 2001) of the packaged reference, 5 ms apart."""
    with np.load(str(files("heli_gym") / "references" / "travel-360.npz")) as data:
        assert_allclose(data["t"], np.linspace(0.0, 10.0, 2001), atol=1e-12)
        return data["x"], data["u"]


@pytest.mark.parametrize("step", [0, 1, 300, 470])
def test_each_entry_of_an_observation_agrees_with_the_table(step):
    x, u = packaged_samples()
    flight = episode(Heli3DOFEnv(start_spread_deg=5.0), 0, actions(2, step))
    observation, state = flight[step][0], flight[step][4]["state"]
    ahead = [min(4 * step + later, 2000) for later in (0, 20, 40, 80, 160)]
    voltage = flight[step][4]["voltage"] if step else u[:, 0]
    units = np.array([1.0, 1.0, 0.25, 0.5, 0.5, 2.0])
    expected = [*((state - x[:, 4 * step]) / units), *(voltage / 6.0 - 1.0)]
    for sample in ahead:
        from_now_on = (x[:, sample] - np.array([x[0, 4 * step], 0.0, 0.0, 0.0, 0.0, 0.0])) / units
        in_the_middle = u[:, min(sample + 2, 2000)]  # of the control period
        expected += [*(from_now_on if sample != ahead[0] else from_now_on[1:]), *(in_the_middle / 6.0 - 1.0)]
    expected.append(1.0 - 0.002 * step)
    assert_allclose(observation, expected, rtol=1e-6, atol=1e-6)


def test_info_holds_the_state_the_measurement_and_the_time():
    for k, (*_, info) in enumerate(episode(Heli3DOFEnv(), 0, actions(2, 30))):
        assert_array_equal(info["state"], info["measurement"])
        assert info["state"].shape == (6,)
        assert info["time"] == pytest.approx(0.02 * k)
        assert (info["voltage"] > 0.0).all() == (k > 0)


def test_the_keys_of_info_are_always_the_same_and_its_values_numbers():
    flight = episode(Heli3DOFEnv("lab"), 0, [(1.0, -1.0)] * 500)
    keys = {"state", "measurement", "time", "voltage", "cost", "is_success"}
    assert len(flight) > 2 and flight[-1][2]
    for *_, info in flight:
        assert set(info) == keys
        assert all(np.issubdtype(np.asarray(value).dtype, np.number) or type(value) is bool for value in info.values())
    assert_array_equal(flight[0][4]["voltage"], 0.0)
    assert flight[0][4]["cost"] == 0.0


def reward_by_the_docstring(error_deg, du, control_period):
    tolerances = np.array([3.0, 6.0, 3.0, 6.0, 6.0, 30.0])
    return control_period / (1.0 + ((error_deg / tolerances) ** 2).sum() + ((du / 6.0) ** 2).sum())


def test_rewards_and_costs_are_those_of_the_docstring():
    x, u = packaged_samples()
    env = Heli3DOFEnv(start_spread_deg=30.0)
    costs = 0.0
    for k, (_, reward, _, _, info) in enumerate(episode(env, 0, actions(5, size=1.5))):
        if k == 0:
            continue
        error, du = info["state"] - x[:, 4 * k], info["voltage"] - u[:, 4 * k - 2]
        assert reward == pytest.approx(reward_by_the_docstring(np.degrees(error), du, 0.02), rel=1e-6)
        excess = np.maximum(info["voltage"] - 11.0, 0.0) + np.maximum(1.0 - info["voltage"], 0.0)
        beyond = max(abs(np.degrees(info["state"][4])) - 50.0, 0.0)
        assert info["cost"] == pytest.approx(0.02 * (excess.sum() / 10.0 + beyond / 100.0), abs=1e-12)
        costs += info["cost"]
    assert costs > 0.0


# Actions


HOVER_VOLTAGE = math.sqrt(0.5 * 0.3946 / 0.6523 / 4.855e-3)  # by (2) and (3b)


@pytest.mark.parametrize("action", [(-1.0, 1.0), (0.0, 0.5), (0.25, -0.75), (1.0, 1.0)])
@pytest.mark.parametrize(
    ("arguments", "zero"),
    [
        ({}, HOVER_VOLTAGE),
        ({"voltage_limits": (1.0, 9.0)}, HOVER_VOLTAGE),
        ({"plant": "lab", "voltage_limits": (-24.0, 24.0)}, HOVER_VOLTAGE),
        ({"plant": Plant(HelicopterParameters(k_plus=4.0 * 4.855e-3))}, 0.5 * HOVER_VOLTAGE),
        ({"voltage_limits": (0.0, 7.0)}, 3.5),
    ],
    ids=str,
)
def test_actions_are_affine_in_the_voltages_on_either_side_of_hover(arguments, zero, action):
    env = Heli3DOFEnv(**arguments)
    low, high = env.voltage_limits
    env.reset(seed=0)
    voltage = env.step(action)[4]["voltage"]
    assert_allclose(voltage, np.interp(action, (-1.0, 0.0, 1.0), (low, zero, high)), rtol=1e-12, atol=1e-12)
    assert_allclose(env.to_voltage(action), voltage, rtol=1e-12, atol=1e-12)
    assert_allclose(env.to_action(voltage), action, atol=1e-12)


def test_at_voltages_within_the_amplifier_every_rig_of_the_fleet_stays_in_the_air():
    assert Heli3DOFEnv("fleet", "climb-7.5").rig.name == "fleet"
    for seed in range(10):
        draw = PLANTS["fleet"].draw(np.random.default_rng(seed))
        env = Heli3DOFEnv(draw, "climb-7.5", rig="fleet")
        assert_allclose(env.hover_voltage, 3.656, atol=0.01)
        trimmed = draw.hover_voltage * np.array(draw.rotors.gains) ** (-1.0 / draw.thrust_map.exponent)
        assert trimmed.max() < env.voltage_limits[1]
        flight = episode(env, seed, [env.to_action(trimmed)] * 250)
        assert flight[-1][3]
        elevation = np.array([info["state"][2] for *_, info in flight])
        assert -np.radians(60.0) < elevation.min() and elevation.max() < draw.table.elevation - np.radians(5.0)


def test_hands_off_an_untrained_agent_hovers():
    env = Heli3DOFEnv(reference=hover(5.0))
    *_, (_, _, _, truncated, info) = episode(env, 0, [(0.0, 0.0)] * 250)
    assert truncated and info["is_success"]
    assert_allclose(info["state"], 0.0, atol=1e-9)


@pytest.mark.parametrize(
    ("action", "voltage"),
    [
        ((-1, 1), (0.0, 12.0)),
        ((1.5, -7.0), (12.0, 0.0)),
        ((1e308, -1e308), (12.0, 0.0)),
        ((0.0, -0.5), (HOVER_VOLTAGE, 0.5 * HOVER_VOLTAGE)),
    ],
)
def test_the_amplifier_saturates(action, voltage):
    env = Heli3DOFEnv()
    env.reset()
    assert_allclose(env.step(action)[4]["voltage"], voltage, rtol=1e-15)


@pytest.mark.parametrize(
    "action",
    [
        (math.nan, 0.0),
        (0.0, math.inf),
        (0.0,),
        (0.0, 0.0, 0.0),
        0.0,
        [[0.0, 0.0]],
        None,
        [[0.0, 0.0], [0.0]],
        [10**400, 0.0],
        ["0.1", "0.2"],
        np.array([True, False]),
        np.array([0.1, 0.2j]),
        np.array(["0.1", "0.2"]),
        np.array([[0.1], [0.2]], np.float32),
    ],
    ids=repr,
)
def test_an_action_that_is_not_two_finite_numbers_is_named_and_changes_nothing(action):
    env, untouched = Heli3DOFEnv(), Heli3DOFEnv()
    for other in (env, untouched):
        episode(other, 0, actions(0, 5))
    with pytest.raises(ValueError, match="action = "):
        env.step(action)
    assert_array_equal(env.step((0.1, 0.2))[0], untouched.step((0.1, 0.2))[0])


# One observation space


@pytest.mark.parametrize(
    "arguments",
    [
        *({"reference": path.stem} for path in sorted(REFERENCES.glob("*.npz"))),
        {"plant": "lab", "control_period": 0.005},
        {"plant": "rigid", "pitch_limit": 1.5, "voltage_limits": (-24.0, 24.0)},
        {"reference": EitherReference()},
        {"reference": hover(0.01)},
    ],
    ids=str,
)
def test_the_observation_space_is_the_same_for_every_argument_and_can_be_rescaled(arguments):
    env = Heli3DOFEnv(**arguments)
    assert env.observation_space == Heli3DOFEnv().observation_space
    assert gym.make_vec("Heli3DOF-v0", 2, **arguments).single_observation_space == env.observation_space
    rescaled = gym.wrappers.RescaleObservation(env, np.float32(-1.0), np.float32(1.0))
    observation, _ = rescaled.reset(seed=0)
    assert np.isfinite(observation).all() and observation in rescaled.observation_space


@pytest.mark.parametrize("plant", ["nominal", "lab", "rigid"])
def test_observations_of_flights_that_follow_their_reference_are_of_order_one(plant):
    env = Heli3DOFEnv(plant, start_spread_deg=5.0)
    policy = make_policy("feedforward+tvlqr", env.reference)
    observation, info = env.reset(seed=0)
    observations, over = [observation], False
    while not over:
        observation, _, terminated, truncated, info = env.step(env.to_action(policy(info["time"], info["measurement"])))
        observations.append(observation)
        over = terminated or truncated
    assert 1.0 < np.abs(observations).max() < 4.0


def test_the_estimated_rates_of_coarse_encoders_stay_in_the_observation_space():
    coarse = Plant(sensors=Sensors(counts=(256,) * 3, rate_filter=1e-3))
    env = Heli3DOFEnv(coarse, control_period=1e-4)
    flight = episode(env, 0, [(0.3, -0.3)] * 10000)
    assert all(step[0] in env.observation_space for step in flight)
    assert max(np.abs(step[0]).max() for step in flight) == 10.0


def test_a_plant_of_one_episode_with_a_strong_push_stays_in_the_observation_space():
    env = Heli3DOFEnv(pitch_limit=1.5)
    env.reset(options={"plant": Plant(disturbances=(Push("travel", 50.0, 0.0, 10.0),))})
    over = False
    while not over:
        observation, _, terminated, truncated, _ = env.step((0.0, 0.0))
        over = terminated or truncated
        assert observation in env.observation_space
    assert observation[0] == 10.0


# The end of an episode


@pytest.mark.parametrize(("control_period", "steps"), [(0.001, 10000), (0.005, 2000), (0.02, 500), (0.03, 334)])
def test_a_flight_is_truncated_when_the_maneuver_is_over(control_period, steps):
    env = Heli3DOFEnv(control_period=control_period)
    flown = episode(env, 0, [(0.0, 0.0)] * (steps + 1))
    assert len(flown) == steps + 1
    assert (flown[-1][2], flown[-1][3]) == (False, True)
    assert not any(truncated or info["is_success"] for _, _, _, truncated, info in flown[:-1])
    assert flown[-1][4]["time"] == pytest.approx(steps * control_period)
    assert flown[-1][0][-1] == pytest.approx(0.0, abs=1e-6)  # no time remains


@pytest.mark.parametrize("pitch_limit", [0.9, math.radians(80.0), 1.5])
@pytest.mark.parametrize("action", [(1.0, -1.0), (-0.4, -0.2), (0.1, -0.2)])
def test_a_flight_is_terminated_exactly_when_the_pitch_leaves_its_limit(pitch_limit, action):
    flight = episode(Heli3DOFEnv(pitch_limit=pitch_limit), 0, [action] * 600)
    pitch = [abs(info["state"][4]) for *_, info in flight]
    assert max(pitch[:-1]) <= pitch_limit < pitch[-1]
    assert [terminated for _, _, terminated, _, _ in flight] == [*[False] * (len(flight) - 1), True]
    assert flight[-1][3] is False
    assert flight[-1][4]["is_success"] is False


def test_success_requires_the_whole_maneuver_with_an_end_within_tolerance():
    env = Heli3DOFEnv()
    policy = make_policy("feedforward+tvlqr", env.reference)
    _, info = env.reset(options={"state": [0.05, 0.0, -0.05, 0.0, 0.1, 0.0]})
    truncated = False
    while not truncated:
        assert info["is_success"] is False
        u = policy(info["time"], info["measurement"])
        *_, truncated, info = env.step(env.to_action(u))
    assert info["is_success"] is True
    assert episode(env, 0, [(0.0, 0.0)] * 500)[-1][4]["is_success"] is False


def test_a_crash_within_tolerance_is_no_success():
    env = Heli3DOFEnv(reference=hover(1.0), pitch_limit=0.01)
    *_, (_, _, terminated, _, info) = episode(env, 0, [(0.01, -0.01)] * 50)
    assert terminated
    assert (np.abs(np.degrees(info["state"])) < [3.0, 6.0, 3.0, 6.0, 6.0, 30.0]).all()
    assert info["is_success"] is False


def test_a_step_before_reset_or_after_the_end_is_refused():
    env = Heli3DOFEnv()
    with pytest.raises(gym.error.ResetNeeded):
        env.step((0.0, 0.0))
    for ending in ([(1.0, -1.0)] * 600, [(0.0, 0.0)] * 500):
        episode(env, 0, ending)
        with pytest.raises(gym.error.ResetNeeded):
            env.step((0.0, 0.0))
    env.reset()
    env.step((0.0, 0.0))


# Flight mechanics


def exact(x, u, duration):
    v = inputs(np.asarray(u))
    flight = solve_ivp(
        lambda t, x: equation_3(x, *v, lib=math), (0.0, duration), x, "DOP853", rtol=1e-13, atol=1e-14, max_step=0.05
    )
    return flight.y[:, -1]


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("control_period", [0.001, 0.02])
def test_states_are_those_of_equation_3(seed, control_period):
    rng = np.random.default_rng(seed)
    start = rng.uniform(-0.3, 0.3, 6)
    env = Heli3DOFEnv(control_period=control_period)
    env.reset(options={"state": start})
    for _ in range(3):  # three actions, each held for 0.2 s
        action = rng.uniform(-0.3, 0.1) + rng.uniform(-0.1, 0.1, 2)
        for _ in range(round(0.2 / control_period)):
            *_, info = env.step(action)
        start = exact(start, env.to_voltage(action), 0.2)
        assert_allclose(info["state"], start, rtol=0.0, atol=1e-8)


def test_the_integration_converges_with_order_four():
    start, action = np.array([0.1, 0.5, -0.2, 0.3, 0.4, -0.8]), np.array([0.05, -0.05])
    errors = []
    for control_period in (0.04, 0.02, 0.01):
        env = Heli3DOFEnv(control_period=control_period)
        env.reset(options={"state": start})
        for _ in range(round(0.8 / control_period)):
            *_, info = env.step(action)
        errors.append(np.abs(info["state"] - exact(start, env.to_voltage(action), 0.8)).max())
    assert_allclose(np.log2(np.divide(errors[:-1], errors[1:])), 4.0, atol=0.4)


def test_a_given_state_starts_the_maneuver_even_where_starts_are_random():
    env = Heli3DOFEnv(random_start=True)
    start = env.reference.x[:, 0] + 0.1
    for seed in range(3):
        _, info = env.reset(seed=seed, options={"state": start})
        assert info["time"] == 0.0
        assert_array_equal(info["state"], start)
    assert env.reset(seed=0)[1]["time"] > 0.0


def test_a_flight_may_start_at_a_given_state():
    observation, info = Heli3DOFEnv(start_spread_deg=5.0).reset(seed=0, options={"state": CORNER})
    assert_array_equal(info["state"], CORNER)
    assert_allclose(observation[:6], CORNER / np.array([1.0, 1.0, 0.25, 0.5, 0.5, 2.0]), rtol=1e-6)


wild = st.floats(allow_nan=False, allow_infinity=False) | st.sampled_from([-1.0, 1.0])


@settings(max_examples=30)
@given(
    st.sampled_from([0.01, 0.05]),
    st.lists(st.floats(-1.0, 1.0), min_size=6, max_size=6),
    st.lists(st.tuples(wild, wild), min_size=1, max_size=20),
)
def test_no_flight_leaves_the_observation_space(control_period, start, wild_actions):
    env = Heli3DOFEnv(control_period=control_period, pitch_limit=1.5)
    observation, _ = env.reset(options={"state": start})
    over = False
    while not over:
        for action in wild_actions:
            assert observation in env.observation_space
            observation, _, terminated, truncated, _ = env.step(action)
            over = terminated or truncated
            if over:
                break
    assert observation in env.observation_space


def test_no_flight_leaves_the_observation_space_when_the_last_period_outlasts_the_maneuver():
    env = Heli3DOFEnv(reference=hover(0.001), control_period=0.05)
    env.reset(options={"state": [1.0] * 6})
    assert env.step((1.0, -1.0))[0] in env.observation_space


def test_no_flight_leaves_the_observation_space_of_a_reference_that_starts_in_motion():
    rates = np.array([[0.0] * 3, [50.0, 0.0, 0.0], *[[0.0] * 3] * 4])
    moving = Trajectory(np.array([0.0, 0.01, 10.0]), rates, np.full((2, 3), 7.893))
    env = Heli3DOFEnv(reference=moving)
    flight = episode(env, 0, [(0.3, 0.3)] * 500)
    assert all(step[0] in env.observation_space for step in flight)


# Arguments


def test_a_reference_by_name_by_path_and_by_value_is_the_same_flight(tmp_path):
    path = tmp_path / "copy.npz"
    REFERENCE.save(path)
    for reference in (REFERENCE, str(path), path):
        assert_same_flight(Heli3DOFEnv(reference=reference), Heli3DOFEnv(reference="travel-360"))


def test_another_reference_is_followed():
    reference = hover(1.0, elevation=0.1)
    env = Heli3DOFEnv(reference=reference)
    flight = fly(env, make_policy("open-loop", reference))
    assert flight.duration == pytest.approx(1.0)
    assert_allclose(flight.x, np.tile(reference.x[:, :1], 51), atol=1e-9)


REFUSED = [
    ("plant", "helicopter"),
    ("plant", None),
    ("reference", "no-such-reference"),
    ("reference", "no-such-file.npz"),
    ("reference", None),
    ("control_period", 0.0),
    ("control_period", -0.02),
    ("control_period", math.nan),
    ("control_period", 0.0501),
    ("control_period", math.inf),
    ("voltage_limits", (12.0, 0.0)),
    ("voltage_limits", (6.0, 6.0)),
    ("voltage_limits", (0.0, math.inf)),
    ("voltage_limits", (math.nan, 12.0)),
    ("voltage_limits", (0.0, 6.0, 12.0)),
    ("voltage_limits", 12.0),
    ("pitch_limit", 0.5),  # the reference's pitch reaches 0.86
    ("pitch_limit", math.nan),
    ("pitch_limit", 1.6),
    ("start_spread_deg", -1.0),
    ("start_spread_deg", math.nan),
    ("start_spread_deg", 60.0),
    ("render_mode", "holographic"),
    ("control_period", 10**400),
    ("pitch_limit", True),
    ("voltage_limits", (0, 10**400)),
    ("voltage_limits", (0.0, 1e300)),
    ("random_start", 2),
    ("reference", "a" * 300),
    ("reference", Trajectory(np.array([0.0, 2e4]), np.zeros((6, 2)), np.full((2, 2), 7.0))),
]


@pytest.mark.parametrize(("name", "value"), REFUSED)
def test_a_bad_argument_is_named_with_its_value(name, value):
    with pytest.raises(ValueError, match=re.escape(f"{name} = {shown(value)}")):
        Heli3DOFEnv(**{name: value})


@pytest.mark.parametrize("name", ["frameskip", "colour"])
@pytest.mark.parametrize("make", [gym.make, gym.make_vec])
def test_an_unknown_argument_is_a_type_error_as_pythons_own(make, name):
    with pytest.raises(TypeError, match=f"got an unexpected keyword argument '{name}'"):
        make("Heli3DOF-v0", **{name: 1})


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("plant", ["nominal"]),
        ("control_period", "fast"),
        ("pitch_limit", "steep"),
        ("voltage_limits", ("low", "high")),
        ("start_spread_deg", "5"),
    ],
)
def test_an_argument_of_the_wrong_type_is_named_with_its_value(name, value):
    with pytest.raises((ValueError, TypeError), match=re.escape(f"{name} = {value!r}")):
        Heli3DOFEnv(**{name: value})


def test_a_reference_that_holds_no_trajectory_is_named(tmp_path):
    path = tmp_path / "something.npz"
    np.savez(path, numbers=np.zeros(3))
    with pytest.raises(ValueError, match=re.escape(repr(str(path)))):
        Heli3DOFEnv(reference=str(path))


@pytest.mark.parametrize(
    "options",
    [
        {"sate": [0.0] * 6},
        {"state": [0.0] * 6, "speed": 1.0},
        {"state": [0.0] * 5},
        {"state": [[0.0] * 6]},
        {"state": [[0.0] * 6, [0.0]]},
        5,
        {"state": [10**400, *[0.0] * 5]},
        {"plant": "moon"},
        {"state": [math.nan, *[0.0] * 5]},
        {"state": [1.001, *[0.0] * 5]},
        {"state": [*[0.0] * 5, -1.001]},
    ],
    ids=str,
)
def test_bad_options_are_named_and_change_nothing(options):
    env, untouched = (Heli3DOFEnv("lab", EitherReference(), start_spread_deg=3.0) for _ in range(2))
    for other in (env, untouched):
        other.reset(seed=1)
    for seed in (None, 2):
        with pytest.raises(ValueError, match=r"options|plant = .moon."):
            env.reset(seed=seed, options=options)
        assert (env.drawn_plant, env.np_random_seed) == (untouched.drawn_plant, 1)
        assert env.simulation.drawn_plant(0) == untouched.drawn_plant
        assert_array_equal(env.step((0.1, 0.2))[0], untouched.step((0.1, 0.2))[0])
    assert_array_equal(env.reset()[0], untouched.reset()[0])


@pytest.mark.parametrize("seed", [-1, 1.5, "one", [1]])
def test_bad_seeds_are_refused_in_gymnasiums_type_and_pythons(seed):
    env = Heli3DOFEnv(start_spread_deg=3.0)
    first = env.reset(seed=4)[0]
    for error in (ValueError, gym.error.Error):
        with pytest.raises(error, match="seed = "):
            env.reset(seed=seed)
    assert_array_equal(env.reset(seed=4)[0], first)


def test_options_of_none_have_no_effect():
    env = Heli3DOFEnv(start_spread_deg=3.0)
    first = env.reset(seed=4)[0]
    assert_array_equal(env.reset(seed=4, options={"state": None, "plant": None})[0], first)


@pytest.mark.parametrize(
    ("arguments", "steps"), [({}, 500), ({"control_period": 0.03}, 334), ({"reference": "travel-90-climb"}, 400)]
)
def test_the_spec_holds_the_steps_of_the_maneuver(arguments, steps):
    env = gym.make("Heli3DOF-v0", **arguments)
    assert env.spec.max_episode_steps == env.unwrapped.spec.max_episode_steps == steps
    assert len(episode(env, 0, [(0.0, 0.0)] * 600)) == 1 + steps
    assert gym.make_vec("Heli3DOF-v0", 2, **arguments).spec.max_episode_steps == steps
    aware = gym.wrappers.TimeAwareObservation(env, normalize_time=True)
    aware.reset()
    assert aware.step(np.zeros(2, np.float32))[0][-1] == pytest.approx(1.0 / steps)


def test_a_flight_may_be_limited_to_fewer_steps():
    env = gym.make("Heli3DOF-v0", max_episode_steps=50)
    assert env.spec.max_episode_steps == 50
    assert len(episode(env, 0, [(0.0, 0.0)] * 600)) == 51


def test_a_start_beyond_the_pitch_limit_is_refused():
    env = Heli3DOFEnv(pitch_limit=0.9)
    env.reset(options={"state": [0.0, 0.0, 0.0, 0.0, 0.89, 0.0]})
    with pytest.raises(ValueError, match="options"):
        env.reset(options={"state": [0.0, 0.0, 0.0, 0.0, 0.91, 0.0]})


# References that are drawn


def test_a_sampler_draws_another_reference_for_every_flight_and_the_same_for_the_same_seed():
    env = gym.make("Heli3DOF-v0", reference=EitherReference())
    with pytest.raises(gym.error.ResetNeeded, match="drawn"):
        _ = env.unwrapped.reference
    durations = []
    for seed in (0, *[None] * 9):
        observation, _ = env.reset(seed=seed)
        durations.append(env.unwrapped.reference.duration)
        units = [1.0, 0.25, 0.5, 0.5, 2.0]
        assert_allclose(observation[8:13], env.unwrapped.reference.x[1:, 0] / units, atol=1e-6)
        assert observation[47] == pytest.approx(durations[-1] / 10.0)
    rng = np.random.default_rng(0)
    assert durations == [EitherReference()(rng).duration for _ in range(10)] and len(set(durations)) == 2


def test_an_environment_with_a_sampler_passes_the_checker_and_is_pickled():
    env = Heli3DOFEnv("lab", EitherReference(), start_spread_deg=3.0)
    check_env(env, skip_render_check=True)
    env.reset(seed=4)
    other = pickle.loads(pickle.dumps(env))
    for action in np.random.default_rng(0).uniform(-0.1, 0.1, (700, 2)):
        (a, *_, over, _), (b, *_) = env.step(action), other.step(action)
        assert_array_equal(a, b)
        if over:
            a, b = env.reset()[0], other.reset()[0]
            assert_array_equal(a, b)


@given(seed=st.integers(0, 10_000))
@settings(max_examples=8, deadline=None)
def test_the_observations_of_random_maneuvers_are_within_the_space(seed):
    env = RANDOM_MANEUVERS
    observation, info = env.reset(seed=seed)
    policy = make_policy("feedforward+tvlqr", env.reference)
    over = False
    while not over:
        assert env.observation_space.contains(observation)
        u = policy(info["time"], info["measurement"])
        observation, _, terminated, over, info = env.step(env.to_action(u))
        assert not terminated
    assert np.abs(info["state"] - env.reference.x[:, -1])[::2].max() < 1e-2  # the nominal plant follows them


class Drawn:
    def __init__(self, value, duration=1.0):
        self.value, self.duration = value, duration

    def __call__(self, rng):
        return self.value


@pytest.mark.parametrize(
    ("sampler", "said"),
    [
        (Drawn("travel-360"), "drew 'travel-360'; must be a Trajectory"),
        (Drawn(REFERENCE), "drew one of 10 s, and its `duration` is 1 s"),
        (Drawn(replace(REFERENCE, x=3.0 * REFERENCE.x), 10.0), "pitch of"),
    ],
    ids=["no trajectory", "too long", "too steep"],
)
def test_reset_names_an_invalid_draw_of_a_sampler(sampler, said):
    env = Heli3DOFEnv(reference=sampler)
    with pytest.raises(ValueError, match=f"reference: .*{said}"):
        env.reset(seed=0)


@pytest.mark.parametrize("duration", [None, 0.0, math.inf, "long"])
def test_a_sampler_without_a_duration_is_refused(duration):
    with pytest.raises(ValueError, match=r"reference\.duration = "):
        Heli3DOFEnv(reference=Drawn(REFERENCE, duration))


def test_a_start_is_given_relative_to_the_reference_that_is_drawn():
    env = Heli3DOFEnv(reference=Drawn(find_reference("take-off"), 8.0))
    start = find_reference("take-off").x[:, 0] + 0.9
    _, info = env.reset(seed=0, options={"state": start})
    assert_array_equal(info["state"], start)
    with pytest.raises(ValueError, match="state"):
        env.reset(seed=0, options={"state": start + 0.2})
