import numpy as np
import pytest
from numpy.testing import assert_allclose

pytest.importorskip("onnx")

from onnx import load
from onnx.reference import ReferenceEvaluator

from heli_gym.baselines.control.residual import LEARNED, Network, RecurrentNetwork, load_learned
from heli_gym.train.export_onnx import Args, main, onnx_model


@pytest.mark.parametrize("tanh_output", [False, True])
def test_the_exported_network_agrees_with_numpy(tanh_output):
    rng = np.random.default_rng(0)
    shapes = ((8, 5), (4, 8), (2, 4))
    network = Network(
        tuple(rng.standard_normal(shape) for shape in shapes),
        tuple(rng.standard_normal(shape[0]) for shape in shapes),
        tanh_output,
    )
    features = rng.standard_normal((20, 5)).astype(np.float32)
    (actions,) = ReferenceEvaluator(onnx_model(network)).run(None, {"features": features})
    assert_allclose(actions, network(features.T.astype(float)).T, atol=1e-5)


def test_the_exported_recurrent_network_agrees_with_numpy_over_many_steps():
    rng = np.random.default_rng(0)
    shapes = ((12, 7), (12, 4), (12,), (12,))
    head = Network((rng.standard_normal((2, 4)),), (rng.standard_normal(2),), True)
    network = RecurrentNetwork(*map(rng.standard_normal, shapes), head)
    session = ReferenceEvaluator(onnx_model(network))
    hidden, exported = np.zeros((4, 20)), np.zeros((20, 4), np.float32)
    for _ in range(20):
        features = rng.standard_normal((20, 7)).astype(np.float32)
        actions, exported = session.run(["actions", "next_hidden"], {"features": features, "hidden": exported})
        expected, hidden = network(features.T.astype(float), hidden)
        assert_allclose(actions, expected.T, atol=1e-5)


@pytest.mark.parametrize("plant", ["lab", "rigid"])
def test_the_policies_of_the_package_can_be_exported(tmp_path, plant):
    main(Args(LEARNED / f"{plant}.json", tmp_path / "one.onnx"))
    settings, network = load_learned(LEARNED / plant)
    features = np.random.default_rng(0).uniform(-2.0, 2.0, (50, settings.features)).astype(np.float32)
    inputs, arguments = {"features": features}, [features.T.astype(float)]
    if settings.recurrent:
        inputs["hidden"] = np.random.default_rng(1).uniform(-1.0, 1.0, (50, settings.recurrent)).astype(np.float32)
        arguments.append(inputs["hidden"].T.astype(float))
    expected = network(*arguments)
    (actions,) = ReferenceEvaluator(load(tmp_path / "one.onnx")).run(["actions"], inputs)
    assert_allclose(actions, (expected[0] if settings.recurrent else expected).T, atol=1e-5)


def test_an_invalid_policy_is_named(tmp_path):
    with pytest.raises(SystemExit, match=r"none\.json"):
        main(Args(tmp_path / "none.json", tmp_path / "one.onnx"))
