"""Digests of the files behind names: another content, another digest; packaged parts have none."""

import sys
from dataclasses import replace

import pytest

from heli_gym.baselines.control.residual import LEARNED, load_learned, save_learned
from heli_gym.baselines.control.weights import KALMAN_LQR, LQI, TVLQR, store_weights
from heli_gym.baselines.evaluation.agents import make_pilot
from heli_gym.baselines.evaluation.digests import learned_digest, policy_digest, reference_digest, rig_digest
from heli_gym.env import find_reference
from heli_gym.rig import PAPER, find_rig
from heli_gym.trajectory import Trajectory

SHORT = find_reference("climb-7.5")


@pytest.fixture
def tuned(tmp_path, monkeypatch):
    """Empty folder of stored weights."""
    monkeypatch.setattr("heli_gym.baselines.control.weights.stored.TUNED", tmp_path / "tuned")
    (tmp_path / "tuned").mkdir()
    store_weights("kalman-lqr", "lab", KALMAN_LQR)
    store_weights("feedforward+tvlqr", "lab", TVLQR)


def test_the_digest_of_tuned_weights_changes_with_them_and_not_with_those_of_another_policy(tuned):
    first = policy_digest("kalman-lqr@lab", PAPER)
    store_weights("lqi", "lab", LQI)
    assert policy_digest("kalman-lqr@lab", PAPER) == policy_digest("kalman-lqr@lab+safe", PAPER) == first
    store_weights("kalman-lqr", "lab", replace(KALMAN_LQR, pitch=2.0 * KALMAN_LQR.pitch))
    assert policy_digest("kalman-lqr@lab", PAPER) != first


def test_the_digest_of_a_learned_policy_changes_with_either_file_and_with_the_weights_of_its_base(tuned, tmp_path):
    settings, network = load_learned(LEARNED / "lab")
    assert settings.base == "feedforward+tvlqr@lab"
    other = network._replace(bias_input=network.bias_input + 0.1)
    digests = []
    for own, weights in ((settings, network), (replace(settings, scale=1.0), network), (settings, other)):
        save_learned(tmp_path / "mine", own, weights)
        digests.append((learned_digest(tmp_path / "mine.json"), policy_digest(f"{tmp_path}/mine.json", PAPER)))
    assert len(set(digests)) == len({file for file, _ in digests}) == 3
    store_weights("feedforward+tvlqr", "lab", replace(TVLQR, travel=2.0 * TVLQR.travel))
    assert learned_digest(tmp_path / "mine.json") == digests[-1][0]
    assert policy_digest(f"{tmp_path}/mine.json", PAPER) != digests[-1][1]


def test_the_digest_of_an_own_function_is_that_of_its_module(tmp_path, monkeypatch):
    path = tmp_path / "digested_module.py"
    path.write_text("def make():\n    return lambda t, measurement: (8.0, 8.0)\n")
    monkeypatch.setattr(sys, "path", [str(tmp_path), *sys.path])
    make_pilot("digested_module:make", SHORT)
    first = policy_digest("digested_module:make", PAPER)
    path.write_text(path.read_text().replace("8.0, 8.0", "7.0, 8.0"))
    assert policy_digest("digested_module:make", PAPER) not in ("", first)


def test_a_reference_that_is_saved_again_has_the_same_digest_and_other_samples_another(tmp_path):
    files = [tmp_path / f"{k}.npz" for k in range(3)]
    for file, x in zip(files, (SHORT.x, SHORT.x, SHORT.x + 1e-9)):
        Trajectory(SHORT.t, x, SHORT.u, SHORT.limits).save(file)
    first, again, other = map(reference_digest, map(str, files))
    assert first == again != other


def test_the_digest_of_a_rig_changes_with_its_file(tmp_path):
    digests = []
    for name in ("ntnu", "quanser"):
        find_rig(name).save(tmp_path / "mine.toml")
        digests.append(rig_digest(str(tmp_path / "mine.toml")))
    assert digests[0] != digests[1]


def test_what_is_packaged_has_no_digest():
    assert {policy_digest("kalman-lqr", PAPER), policy_digest("residual", PAPER)} == {""}
    assert reference_digest("travel-360") == rig_digest("fleet") == ""
