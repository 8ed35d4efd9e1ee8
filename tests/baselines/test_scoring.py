"""Scores of agents from names, files and functions, on common draws, without unpickling."""

import io
import pickle
import zipfile

import numpy as np
import pytest

from heli_gym.baselines import evaluate, fly, make_policy
from heli_gym.baselines.evaluation.agents import make_pilot, read_state_dict
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.plant import HELD_OUT_SEED

REFERENCE = find_reference("climb-7.5")


@pytest.fixture(scope="module")
def env():
    return Heli3DOFEnv("lab", "climb-7.5")


@pytest.fixture(scope="module")
def observations(env):
    return np.random.default_rng(0).uniform(-1.0, 1.0, (7, *env.observation_space.shape)).astype(np.float32)


def test_each_row_is_the_flight_of_its_seed():
    table = evaluate("kalman-lqr", "lab", episodes=3, reference="climb-7.5")
    env = Heli3DOFEnv("lab", "climb-7.5", start_spread_deg=5.0)
    for k, row in enumerate(table):
        assert row["seed"] == HELD_OUT_SEED + k
        flight = fly(env, make_policy("kalman-lqr", REFERENCE), seed=HELD_OUT_SEED + k)
        metrics = flight_metrics(flight, REFERENCE, env.voltage_limits, env.pitch_limit)
        assert row["rms_travel_deg"] == pytest.approx(metrics.rms_error_deg[0], rel=1e-6)
        assert (row["success"], row["crashed"]) == (metrics.success, metrics.crashed)


def test_a_function_scores_as_the_policy_that_it_calls():
    policy = make_policy("feedforward+tvlqr", REFERENCE)
    of_function = evaluate(lambda t, x: policy(t, x), "lab", episodes=2, reference="climb-7.5")
    of_name = evaluate("feedforward+tvlqr", "lab", episodes=2, reference="climb-7.5")
    np.testing.assert_allclose(of_function.column("rms_error_deg"), of_name.column("rms_error_deg"), rtol=1e-6)


def test_pandas_reads_the_table(tmp_path):
    pandas = pytest.importorskip("pandas")
    table = evaluate("zero", episodes=2, reference="climb-7.5")
    frame = table.to_pandas()
    assert list(frame["seed"]) == [HELD_OUT_SEED, HELD_OUT_SEED + 1]
    assert pandas.DataFrame(table).equals(frame)
    table.to_csv(tmp_path / "flights.csv")
    pandas.testing.assert_frame_equal(pandas.read_csv(tmp_path / "flights.csv"), frame)
    assert "FlightTable of 2 flights" in repr(table)


def test_a_users_module_makes_a_policy(tmp_path, monkeypatch):
    (tmp_path / "my_controllers.py").write_text(
        "from heli_gym.baselines import make_policy\n"
        "def make(reference, control_period):\n    return make_policy('lqi', reference, control_period)\n"
        "def bare():\n    return lambda t, measurement: (6.0, 6.0)\n"
    )
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.path", [str(tmp_path)])
    mine = evaluate("my_controllers:make", episodes=2, reference="climb-7.5")
    assert mine.rows == evaluate("lqi", episodes=2, reference="climb-7.5").rows
    assert not evaluate("my_controllers:bare", episodes=1, reference="climb-7.5")[0]["success"]
    with pytest.raises(ValueError, match="'my_controllers' has no 'none'"):
        evaluate("my_controllers:none")
    with pytest.raises(ValueError, match="there is no module 'no_such_module'"):
        evaluate("no_such_module:make")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"episodes": 0}, "episodes = 0"),
        ({"seed": -1}, "seed = -1"),
        ({"plant": "x"}, "plant = 'x'"),
        ({"policy": "foo"}, "name = 'foo'"),
        ({"policy": 3}, "policy = 3"),
        ({"policy": lambda t, x: 1.0}, "two finite voltages"),
    ],
)
def test_invalid_policies_and_arguments_are_named(arguments, words):
    with pytest.raises(ValueError, match=words):
        evaluate(**{"policy": "zero", "episodes": 1, "reference": "climb-7.5", **arguments})


@pytest.mark.parametrize(
    ("algorithm", "options"),
    [
        ("PPO", {}),
        ("A2C", {}),
        ("SAC", {"buffer_size": 10}),
        ("TD3", {"buffer_size": 10}),
        ("DDPG", {"buffer_size": 10}),
        ("TQC", {"buffer_size": 10}),
        ("PPO", {"policy_kwargs": {"activation_fn": "ReLU", "net_arch": [32, 16]}}),
        ("SAC", {"buffer_size": 10, "use_sde": True}),
    ],
)
def test_a_stable_baselines3_model_and_its_file_act_equally(tmp_path, env, observations, algorithm, options):
    sb3 = pytest.importorskip("stable_baselines3")
    import torch

    options = dict(options)
    if "policy_kwargs" in options:
        options["policy_kwargs"] = {**options["policy_kwargs"], "activation_fn": torch.nn.ReLU}
    library = pytest.importorskip("sb3_contrib") if algorithm == "TQC" else sb3
    model = getattr(library, algorithm)("MlpPolicy", env, device="cpu", seed=1, **options)
    model.save(tmp_path / "agent.zip")
    pilot = make_pilot(tmp_path / "agent.zip", REFERENCE)
    expected, _ = model.predict(observations, deterministic=True)
    np.testing.assert_allclose(pilot.act(observations), expected, atol=1e-6)
    if algorithm == "PPO" and not options:
        of_file = evaluate(tmp_path / "agent.zip", "lab", episodes=2, reference="climb-7.5")
        of_model = evaluate(model, "lab", episodes=2, reference="climb-7.5")
        np.testing.assert_allclose(of_file.column("rms_error_deg"), of_model.column("rms_error_deg"), rtol=1e-3)


@pytest.mark.parametrize(
    ("algorithm", "options", "last"),
    [
        ("PPO", {"policy_kwargs": {"squash_output": True}}, "action_net"),
        ("SAC", {"buffer_size": 10}, "actor.mu"),
        ("SAC", {"buffer_size": 10, "policy_kwargs": {"clip_mean": 0.5}}, "actor.mu"),
        ("SAC", {"buffer_size": 10, "policy_kwargs": {"clip_mean": 0.0}}, "actor.mu"),
    ],
)
def test_squashed_and_clipped_means_of_a_file_are_those_of_the_model(
    tmp_path, env, observations, algorithm, options, last
):
    torch, sb3 = pytest.importorskip("torch"), pytest.importorskip("stable_baselines3")
    model = getattr(sb3, algorithm)("MlpPolicy", env, device="cpu", seed=1, use_sde=True, **options)
    with torch.no_grad():
        for name, parameter in model.policy.named_parameters():
            if name.startswith(last):
                parameter *= 30.0
    model.save(tmp_path / "agent.zip")
    expected, _ = model.predict(observations, deterministic=True)
    np.testing.assert_allclose(make_pilot(tmp_path / "agent.zip", REFERENCE).act(observations), expected, atol=1e-5)


def test_a_model_with_a_memory_is_refused():
    class Recurrent:
        def predict(self, observation, state=None, deterministic=False):
            return np.zeros((len(observation), 2)), np.zeros(3)

    with pytest.raises(ValueError, match="Recurrent has a memory"):
        evaluate(Recurrent(), episodes=1, reference="climb-7.5")


def damaged(content: bytes) -> bytes:
    """A model's archive whose parameters are these bytes."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("policy.pth", content)
        archive.writestr("data", "{}")
    return file.getvalue()


class Touch:
    def __reduce__(self):
        return (open, ("touched", "w"))


def with_pickle(value) -> bytes:
    """Parameters, as PyTorch lays them out, whose table is any pickle."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("archive/data.pkl", pickle.dumps(value, protocol=2))
    return file.getvalue()


def test_a_model_that_would_run_code_is_refused_and_runs_nothing(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "agent.zip").write_bytes(damaged(with_pickle({"action_net.weight": Touch()})))
    with pytest.raises(ValueError, match=r"agent.zip.*it calls"):
        make_pilot("agent.zip", REFERENCE)
    assert not (tmp_path / "touched").exists()


def test_an_archive_without_its_beginning_is_refused_by_the_name_of_its_file(tmp_path):
    with zipfile.ZipFile(tmp_path / "whole.zip", "w") as archive:
        archive.writestr("policy.pth", bytes(100))
    (tmp_path / "cut.zip").write_bytes((tmp_path / "whole.zip").read_bytes()[10:])
    with pytest.raises(ValueError, match=r"cut\.zip': must be a model that Stable-Baselines3 saved"):
        make_pilot(tmp_path / "cut.zip", REFERENCE)


def test_mutations_of_a_model_are_named_errors_or_load_finite_numbers(tmp_path, env):
    sb3 = pytest.importorskip("stable_baselines3")
    model = sb3.PPO("MlpPolicy", env, device="cpu", policy_kwargs={"net_arch": [8]})
    model.save(tmp_path / "agent.zip")
    with zipfile.ZipFile(tmp_path / "agent.zip") as archive:
        parameters = archive.read("policy.pth")
    rng = np.random.default_rng(0)
    refused = 0
    for _ in range(150):
        data = bytearray(parameters)
        for _ in range(int(rng.integers(1, 8))):
            data[int(rng.integers(len(data)))] = int(rng.integers(256))
        (tmp_path / "mutated.zip").write_bytes(damaged(bytes(data[: int(rng.integers(len(data) // 2, len(data) + 1))])))
        try:
            pilot = make_pilot(tmp_path / "mutated.zip", REFERENCE)
        except ValueError as error:
            assert "mutated.zip" in str(error)
            refused += 1
        else:
            assert np.isfinite(pilot.act(np.zeros((1, *env.observation_space.shape)))).all()
    assert refused > 50


def test_a_tensor_larger_than_its_storage_is_refused():
    torch = pytest.importorskip("torch")
    file = io.BytesIO()
    torch.save({"a": torch.zeros(1).expand(10_000, 10_000)}, file)
    with pytest.raises(ValueError, match="larger than its storage"):
        read_state_dict(file.getvalue())


def test_an_onnx_network_acts_as_onnx_runtime_runs_it(tmp_path, env, observations):
    onnx = pytest.importorskip("onnx")
    pytest.importorskip("onnxruntime")
    width = env.observation_space.shape[0]
    weight = np.random.default_rng(1).standard_normal((2, width)).astype(np.float32)
    graph = onnx.helper.make_graph(
        [onnx.helper.make_node("Gemm", ["x", "w"], ["y"], transB=1), onnx.helper.make_node("Tanh", ["y"], ["z"])],
        "agent",
        [onnx.helper.make_tensor_value_info("x", onnx.TensorProto.FLOAT, ["N", width])],
        [onnx.helper.make_tensor_value_info("z", onnx.TensorProto.FLOAT, ["N", 2])],
        [onnx.numpy_helper.from_array(weight, "w")],
    )
    model = onnx.helper.make_model(graph, opset_imports=[onnx.helper.make_opsetid("", 17)], ir_version=8)
    onnx.save(model, tmp_path / "agent.onnx")
    pilot = make_pilot(str(tmp_path / "agent.onnx"), REFERENCE)
    np.testing.assert_allclose(pilot.act(observations), np.tanh(observations @ weight.T), atol=1e-5)
    (tmp_path / "damaged.onnx").write_bytes(b"no network")
    with pytest.raises(ValueError, match=r"damaged.onnx"):
        make_pilot(str(tmp_path / "damaged.onnx"), REFERENCE)
