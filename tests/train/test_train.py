import json
import logging
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

torch = pytest.importorskip("torch")
pytest.importorskip("stable_baselines3")

from numpy.testing import assert_allclose, assert_array_equal  # noqa: E402
from rich.console import Console  # noqa: E402
from stable_baselines3 import PPO  # noqa: E402

from heli_gym.baselines import make_policy  # noqa: E402
from heli_gym.baselines.control.residual import LEARNED, ResidualPolicy, load_learned, save_learned  # noqa: E402
from heli_gym.baselines.control.residual.step import SINGLE_GROUPS  # noqa: E402
from heli_gym.baselines.control.weights import KALMAN_LQR, TVLQR, store_weights  # noqa: E402
from heli_gym.baselines.evaluation.metrics import flight_metrics  # noqa: E402
from heli_gym.baselines.evaluation.rollout import fly_many  # noqa: E402
from heli_gym.env import find_reference  # noqa: E402
from heli_gym.train.checkpoint import last_checkpoint, read_checkpoint, save_checkpoint  # noqa: E402
from heli_gym.train.flight_gradient import LANES  # noqa: E402
from heli_gym.train.results import Args as ResultsArgs  # noqa: E402
from heli_gym.train.results import policies  # noqa: E402
from heli_gym.train.train import (  # noqa: E402
    VALIDATION_SEED,
    Args,
    check,
    check_begun,
    make_agent,
    network_of,
    run_folder,
    score,
    settings_and_files,
    settings_of,
    train,
    with_defaults,
)
from heli_gym.train.vec_env import HeliVecEnv, ResidualVecEnv  # noqa: E402
from heli_gym.vector_env import Heli3DOFVectorEnv  # noqa: E402

SHORT = find_reference("climb-7.5")
SMALL = with_defaults(
    Args(
        algo="ppo",
        base="kalman-lqr@lab",
        scale=3.0,
        reference="climb-7.5",
        steps=4 * 32 * 8,
        envs=8,
        chunk=32,
        rollout=16,
        batch=64,
        epochs=2,
        validation=4,
        progress=False,
    )
)
SMALL_APG = Args(reference="climb-7.5", steps=4 * 250 * LANES, chunk=250, cell=8, validation=4, progress=False)


def helicopters(n=4, base="kalman-lqr", **kwargs):
    envs = Heli3DOFVectorEnv(n, "lab", SHORT, start_spread_deg=5.0, autoreset_mode="SameStep")
    return ResidualVecEnv(envs, ResidualPolicy(make_policy(base, SHORT), SHORT, None, 1.0), **kwargs)


@pytest.mark.parametrize("base", ["kalman-lqr", "feedforward+tvlqr"])
def test_an_agent_that_does_nothing_flies_the_base_and_sees_its_features_across_restarts(base):
    vec = helicopters(base=base)
    vec.seed(0)
    vec.reset()
    for _ in range(400):  # more than an episode, and the first ones start at different times
        features, _, done, infos = vec.step(np.zeros((4, 2), np.float32))
        assert np.isfinite(features).all() and features.shape == (4, vec.n_actor_features)
        for i in np.flatnonzero(done):
            assert infos[i]["terminal_observation"].shape == (vec.n_actor_features,)
            alone = ResidualPolicy(make_policy(base, SHORT), SHORT, None, 1.0)
            expected = alone.observe(0.0, vec.info["measurement"][i])[1]
            assert_allclose(features[i], expected, atol=1e-6)
    last = vec.info["state"].T - vec.reference_at(vec.info["time"])
    assert np.abs(last).max() < 1.0


def test_flights_start_spread_over_the_maneuver():
    vec = helicopters(5)
    vec.reset()
    assert_allclose(vec.info["time"], SHORT.duration * np.arange(5) / 5, atol=0.02)


def test_the_critics_inputs_do_not_reach_the_actor():
    vec = helicopters(privileged=True)
    agent = make_agent(SMALL, vec)
    observation = torch.zeros((1, vec.observation_space.shape[0]))
    changed = observation.clone()
    changed[:, vec.n_actor_features :] = 3.0
    with torch.no_grad():
        mean = agent.policy.get_distribution(observation).distribution.mean
        assert torch.equal(mean, agent.policy.get_distribution(changed).distribution.mean)
        assert not torch.equal(agent.policy.predict_values(observation), agent.policy.predict_values(changed))


@pytest.mark.parametrize("algo", ["ppo", "sac", "td3", "tqc"])
def test_the_network_for_numpy_is_the_agents(algo):
    vec = helicopters(privileged=algo == "ppo")
    agent = make_agent(replace(SMALL, algo=algo, buffer=1000), vec)
    observations = np.random.default_rng(0).uniform(-2, 2, (50, vec.observation_space.shape[0])).astype(np.float32)
    expected, _ = agent.predict(observations, deterministic=True)
    actual = np.clip(network_of(agent)(observations[:, : vec.n_actor_features].T.astype(float)).T, -1.0, 1.0)
    assert_allclose(actual, expected, atol=1e-6)
    assert np.abs(actual).max() < 0.1  # the agent starts from the base policy


def test_td3_explores_and_its_target_begins_as_the_actor():
    vec = helicopters(privileged=False)
    agent = make_agent(replace(SMALL, algo="td3", buffer=1000), vec)
    assert_allclose(agent.action_noise()[0], 0.0, atol=6.0 * np.exp(SMALL.log_std))
    assert np.any(agent.action_noise())
    observations = torch.as_tensor(np.random.default_rng(0).uniform(-2, 2, (5, vec.observation_space.shape[0])))
    with torch.no_grad():
        assert torch.equal(agent.actor(observations.float()), agent.actor_target(observations.float()))


def test_the_recurrent_network_for_numpy_is_that_of_recurrent_ppo_over_a_flight():
    vec = helicopters(n=3)
    agent = make_agent(replace(SMALL, algo="recurrent-ppo", cell=8), vec)
    network, hidden, state = network_of(agent), np.zeros((8, 3)), None
    rng = np.random.default_rng(0)
    for _ in range(20):
        observations = rng.uniform(-2, 2, (3, vec.observation_space.shape[0])).astype(np.float32)
        expected, state = agent.predict(observations, state, deterministic=True)
        actual, hidden = network(observations.T.astype(float), hidden)
        assert_allclose(actual.T, expected, atol=1e-6)
    assert np.abs(actual).max() < 0.1  # the agent starts from the base policy


def test_the_adapter_wants_the_autoreset_mode_of_stable_baselines():
    with pytest.raises(ValueError, match="SameStep"):
        HeliVecEnv(Heli3DOFVectorEnv(2))


def test_stable_baselines_learns_on_the_plain_adapter():
    vec = HeliVecEnv(Heli3DOFVectorEnv(4, autoreset_mode="SameStep"))
    PPO("MlpPolicy", vec, n_steps=16, batch_size=32, n_epochs=1, device="cpu").learn(64)


def without_time(path):
    return [{**row, "seconds": None} for row in json.loads(path.read_text())]


@pytest.mark.parametrize(
    "args",
    [
        SMALL,
        pytest.param(replace(SMALL, algo="recurrent-ppo", cell=8), marks=pytest.mark.slow),
        pytest.param(replace(SMALL, algo="sac", buffer=2000), marks=pytest.mark.slow),
        SMALL_APG,
    ],
    ids=lambda args: args.algo,
)
def test_an_interrupted_run_goes_on_to_the_same_weights(tmp_path, args):
    console = Console(quiet=True)
    whole = train(replace(args, out=tmp_path / "whole"), console)
    parts = replace(args, out=tmp_path / "parts")
    train(parts, console, stop_after=2)
    train(replace(parts, resume=True), console)
    folder = run_folder(with_defaults(parts))
    a, b = (last_checkpoint(f / "checkpoints")["parameters"]["policy"] for f in (whole, folder))
    assert a.keys() == b.keys()
    for name in a:
        assert torch.equal(a[name], b[name]), name
    assert without_time(whole / "history.json") == without_time(folder / "history.json")
    settings, network = load_learned(folder / "best")
    first = network.weight_input if settings.recurrent else network.weights[0]
    assert settings.features == first.shape[1]
    assert sorted(p.suffix for p in (folder / "checkpoints").iterdir()) == [".safetensors"] * 2 + [".sha256"] * 2


def test_a_damaged_checkpoint_is_named_and_the_one_before_it_used(tmp_path, caplog):
    for number in range(3):
        save_checkpoint(tmp_path, number, {"number": number, "nested": {0: [torch.full((2,), float(number)), None]}})
    assert len(list(tmp_path.glob("*.safetensors"))) == 2
    state = read_checkpoint(tmp_path / "000002.safetensors")
    assert state["number"] == 2 and state["nested"][0][1] is None
    assert_array_equal(state["nested"][0][0].numpy(), [2.0, 2.0])
    path = tmp_path / "000002.safetensors"
    path.write_bytes(path.read_bytes()[:-4])
    with caplog.at_level(logging.WARNING):
        assert last_checkpoint(tmp_path)["number"] == 1
    assert "000002.safetensors" in caplog.text


def test_there_is_nothing_to_go_on_from_in_an_empty_folder(tmp_path):
    assert last_checkpoint(tmp_path) is None


def test_a_run_is_never_overwritten_and_goes_on_with_its_own_settings_only(tmp_path):
    args, console = replace(SMALL, out=tmp_path, steps=2 * 32 * 8), Console(quiet=True)
    folder = train(args, console)
    before = (folder / "history.json").read_text()
    with pytest.raises(ValueError, match=r"out: .* holds a run already; --resume"):
        train(args, console)
    with pytest.raises(ValueError, match=r"scale = 1\.0: the run in .* was begun with 3\.0"):
        train(replace(args, resume=True, scale=1.0), console)
    train(replace(args, resume=True), console)
    assert (folder / "history.json").read_text() == before


def test_the_base_has_tuned_weights_only_where_some_are_stored_for_it_and_not_for_another_policy(tmp_path, monkeypatch):
    monkeypatch.setattr("heli_gym.baselines.control.weights.stored.TUNED", tmp_path)
    store_weights("kalman-lqr", "lab", KALMAN_LQR)
    assert with_defaults(Args()).base == "feedforward+tvlqr"
    assert policies(ResultsArgs(policies=("feedforward+tvlqr@PLANT", "kalman-lqr@PLANT"))) == (
        "feedforward+tvlqr",
        "kalman-lqr@lab",
    )
    store_weights("feedforward+tvlqr", "lab", TVLQR)
    assert with_defaults(Args()).base == "feedforward+tvlqr@lab"


def test_a_run_goes_on_with_the_first_network_that_it_was_begun_with_only(tmp_path):
    settings, network = load_learned(LEARNED / "lab")
    save_learned(tmp_path / "first", settings, network)
    args = with_defaults(replace(SMALL_APG, init=tmp_path / "first.json", resume=True))
    stored = tmp_path / "settings.json"
    stored.write_text(json.dumps(settings_and_files(args)))
    assert check_begun(args, tmp_path)
    save_learned(tmp_path / "first", settings, network._replace(bias_input=network.bias_input + 0.1))
    with pytest.raises(ValueError, match=r"init = .*first\.json': has changed since the run in .* was begun"):
        check_begun(args, tmp_path)
    stored.write_text(json.dumps(settings_of(args)))  # of a run without digests
    assert check_begun(args, tmp_path)


def test_a_second_process_is_kept_out_of_the_folder_of_a_run_at_work(tmp_path):
    args, console = replace(SMALL, out=tmp_path, steps=2 * 32 * 8), Console(quiet=True)
    refused = []

    def disturb(number):
        before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
        with pytest.raises(ValueError, match=r"out: another heli-train is at work in .*lab"):
            train(replace(args, resume=True), console)
        assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == before
        refused.append(number)

    folder = train(args, console, after_chunk=disturb)
    assert refused == [1, 2]
    assert train(replace(args, resume=True), console) == folder  # the end of the run freed it


def test_a_network_that_crashes_early_is_never_the_best():
    row = {"success": 0.0, "rms_error_deg": [1.0, 1.0, 1.0], "flown": 2.0, "cost": 0.0}
    poor = {"success": 0.0, "rms_error_deg": [40.0, 10.0, 9.0], "flown": 5.0, "cost": 5.0}
    assert score(SMALL, row) < score(SMALL, poor)


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ({"steps": 0}, "steps"),
        ({"gamma": 2.0}, "gamma = 2.0: must be 0 to 1"),
        ({"hold": -5}, "hold = -5: must be 1 to"),
        ({"hidden": (64, 0)}, "hidden = "),
        ({"batch": 1}, "batch = 1: must be 2 to"),
        ({"hidden": (10**9,)}, "hidden = .*1 to 16 layers, each of 1 to 4096 neurons"),
        ({"hidden": (8,) * 17}, "hidden = "),
        ({"cell": 10**6}, "cell = 1000000: must be 1 to 4096"),
        ({"validation": 10**9}, "validation = "),
        ({"rollout": 10**6, "chunk": 10**6, "envs": 20}, "rollout = 1000000: must be 1 to 500000 with envs = 20"),
        ({"algo": "recurrent-ppo", "rollout": 10**6, "envs": 20}, "rollout = 1000000: must be 1 to 500000 with envs"),
        ({"scale": -1.0}, "scale = -1.0: must be 1e-06 to 1000"),
        ({"scale": float("inf")}, "scale = inf"),
        ({"cost_weight": -1.0}, "cost_weight = -1.0: must be 0 to"),
        ({"elevation_weight": -1e-9}, "elevation_weight = "),
        ({"pitch_penalty": float("inf")}, "pitch_penalty = inf"),
        ({"max_grad_norm": 0.0}, "max_grad_norm = 0.0"),
        ({"learning_rate": 1e300}, "learning_rate = 1e"),
        ({"log_std": 100.0}, "log_std = 100.0"),
        ({"learning_rate": float("nan")}, "learning_rate = nan"),
        ({"algo": "apg"}, "envs: must be 128 helicopters"),
        (
            {"algo": "apg", "plant": "nominal", "envs": LANES, "feature_groups": SINGLE_GROUPS, "base": "open-loop"},
            "plant: must have",
        ),
        ({"base": "moon"}, "base"),
        ({"seed": -1}, "seed"),
        ({"chunk": 33}, "chunk"),
        ({"steps": 1001 * 32 * 8}, "steps = .* 1001 chunks"),  # the thousand and first would fly the next seed's draws
        ({"seed": 2097, "envs": 512, "steps": 153 * 32 * 512}, "seed = 2097: with 153 chunks of 512 draws"),
        ({"feature_groups": ("moon",)}, "feature_groups"),
        ({"plant": "moon"}, "plant"),
        ({"out": Path(__file__)}, "out"),
    ],
)
def test_bad_settings_are_named(tmp_path, change, name):
    with pytest.raises(ValueError, match=name):
        train(replace(SMALL, **{"out": tmp_path, **change}), Console(quiet=True))
    assert not list(tmp_path.iterdir())


def test_a_run_with_damaged_settings_or_checkpoints_is_named_and_not_begun_anew(tmp_path):
    args = replace(SMALL, out=tmp_path, steps=2 * 32 * 8, resume=True)
    folder = train(args, Console(quiet=True))
    settings = (folder / "settings.json").read_text()
    (folder / "settings.json").write_text("[]")
    with pytest.raises(ValueError, match=r"settings\.json: must be a JSON object"):
        train(args, Console(quiet=True))
    (folder / "settings.json").write_text(settings)
    for path in (folder / "checkpoints").glob("*.safetensors"):
        path.write_bytes(b"damaged")
    with pytest.raises(ValueError, match="all 2 checkpoints are damaged; remove"):
        train(args, Console(quiet=True))


def test_the_seeds_of_training_may_reach_up_to_those_of_the_validation(tmp_path):
    chunks = VALIDATION_SEED // 512 - 2097 * 1000  # so that the last helicopter's seed is the last before
    check(replace(SMALL, out=tmp_path, seed=2097, envs=512, steps=chunks * 32 * 512))
    check(replace(SMALL, out=tmp_path, steps=1000 * 32 * 8))


def test_a_history_starts_with_the_base_alone(tmp_path):
    args = replace(SMALL, out=tmp_path, steps=1)
    history = json.loads((train(args, Console(quiet=True)) / "history.json").read_text())
    envs = Heli3DOFVectorEnv(args.validation, "lab", SHORT, start_spread_deg=5.0)
    flights = fly_many(envs, make_policy("kalman-lqr@lab", SHORT), VALIDATION_SEED)
    rms = np.mean([flight_metrics(flight, SHORT, envs.voltage_limits).rms_error_deg for flight in flights], axis=0)
    assert len(history) == 2 and history[0]["steps"] == 0
    assert_allclose(history[0]["rms_error_deg"], rms, rtol=1e-12)
