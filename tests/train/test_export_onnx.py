import numpy as np
import pytest
from numpy.testing import assert_allclose

pytest.importorskip("onnx")

from onnx import load
from onnx.reference import ReferenceEvaluator

from heli_gym.baselines.control.residual import LEARNED, Network, load_learned
from heli_gym.train.export_onnx import Args, main, onnx_model


@pytest.mark.parametrize("tanh_output", [False, True])
def test_the_exported_network_computes_what_numpy_computes(tanh_output):
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


@pytest.mark.parametrize("plant", ["lab", "rigid"])
def test_the_policies_of_the_package_can_be_exported(tmp_path, plant):
    main(Args(LEARNED / f"{plant}.json", tmp_path / "one.onnx"))
    settings, network = load_learned(LEARNED / plant)
    features = np.random.default_rng(0).uniform(-2.0, 2.0, (50, settings.features)).astype(np.float32)
    (actions,) = ReferenceEvaluator(load(tmp_path / "one.onnx")).run(None, {"features": features})
    assert_allclose(actions, network(features.T.astype(float)).T, atol=1e-5)


def test_what_is_no_policy_is_named(tmp_path):
    with pytest.raises(SystemExit, match=r"none\.json"):
        main(Args(tmp_path / "none.json", tmp_path / "one.onnx"))
