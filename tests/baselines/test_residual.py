import copy
import json
import pickle
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym.baselines import fly, make_policy
from heli_gym.baselines.control.residual import (
    FEATURE_GROUPS,
    LEARNED,
    Learned,
    Network,
    ResidualPolicy,
    learned_policy,
    load_learned,
    save_learned,
)
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.baselines.evaluation.rollout import fly_many
from heli_gym.env import Heli3DOFEnv, find_reference, reference_for
from heli_gym.plant import HELD_OUT_SEED
from heli_gym.vector_env import Heli3DOFVectorEnv

REFERENCE = find_reference("travel-360")
SHORT = find_reference("climb-7.5")
START = SHORT.x[:, 0]
VALIDATION_SEED = HELD_OUT_SEED // 2
RESULTS = Path(__file__).parents[2] / "results"


def network(features, seed=0, tanh_output=False):
    rng = np.random.default_rng(seed)
    sizes = (features, 16, 8, 2)
    weights = [0.3 * rng.standard_normal((rows, columns)) for columns, rows in pairwise(sizes)]
    return Network(tuple(weights), tuple(0.1 * rng.standard_normal(len(w)) for w in weights), tanh_output)


def nothing(features):
    return np.zeros((2, *features.shape[1:]))


def features_of(base):
    policy = ResidualPolicy(make_policy(base, SHORT), SHORT, None, 1.0)
    return len(policy.observe(0.0, START)[1])


@pytest.mark.parametrize("base", ["feedforward+tvlqr", "kalman-lqr", "lag-lqi"])
@pytest.mark.parametrize(("correction", "scale"), [(nothing, 2.0), (lambda features: np.ones((2,)), 0.0)])
def test_without_a_correction_or_with_scale_zero_the_base_is_flown_bit_for_bit(base, correction, scale):
    env = Heli3DOFEnv("lab", SHORT, start_spread_deg=5.0)
    expected = fly(env, make_policy(base, SHORT), seed=3)
    flight = fly(env, ResidualPolicy(make_policy(base, SHORT), SHORT, correction, scale), seed=3)
    assert_array_equal(flight.x, expected.x)
    assert_array_equal(flight.u, expected.u)


def test_a_correction_is_the_scaled_action_on_top_of_the_base_and_no_larger_than_the_scale():
    policy = ResidualPolicy(make_policy("feedforward+tvlqr", SHORT), SHORT, lambda features: np.array([0.5, -7.0]), 0.4)
    base = make_policy("feedforward+tvlqr", SHORT)
    policy.reset(np.random.default_rng(0))
    measurement = SHORT.x[:, 0] + 0.01
    assert_allclose(policy(0.0, measurement) - base(0.0, measurement), [0.2, -0.4], atol=1e-12)


@pytest.mark.parametrize("base", ["feedforward+tvlqr", "lqi", "kalman-lqr"])
def test_many_at_once_fly_as_if_alone(base):
    def policy():
        return ResidualPolicy(make_policy(base, SHORT), SHORT, network(features_of(base)), 1.0)

    together = fly_many(Heli3DOFVectorEnv(3, "lab", SHORT, start_spread_deg=5.0), policy(), seed=7)
    env = Heli3DOFEnv("lab", SHORT, start_spread_deg=5.0)
    for k, flight in enumerate(together):
        alone = fly(env, policy(), seed=7 + k)
        assert_allclose(flight.x, alone.x, atol=1e-9)


@pytest.mark.parametrize("base", ["feedforward+tvlqr", "kalman-lqr"])
def test_a_reset_forgets_the_last_flight_and_without_one_it_is_remembered(base):
    rng = np.random.default_rng(0)
    measurements = (SHORT.x[:, [0]] + 0.01 * rng.standard_normal((6, 20))).T
    policy = ResidualPolicy(make_policy(base, SHORT), SHORT, network(features_of(base)), 1.0)
    first, remembering = ([policy(0.02 * k, m) for k, m in enumerate(measurements)] for _ in range(2))
    policy.reset(rng)
    again = [policy(0.02 * k, m) for k, m in enumerate(measurements)]
    assert_array_equal(again, first)
    assert np.abs(np.array(remembering) - first).max() > 1e-6


@pytest.mark.parametrize(
    ("name", "plant", "folder"),
    [
        ("lab", "lab", "lab/residual"),
        ("rigid", "rigid", "rigid/residual"),
        ("fleet", "fleet", "fleet/residual"),
        ("any", "lab", "any-maneuver"),
    ],
)
def test_the_policies_of_the_package_are_those_of_the_first_seed(name, plant, folder):
    (settings, shipped), (other, first) = (load_learned(path) for path in (LEARNED / name, RESULTS / folder / "0/best"))
    assert settings == other and settings.plant == plant
    for a, b in zip((*shipped[:4], *shipped.head.weights), (*first[:4], *first.head.weights)):
        assert_array_equal(a, b)


def test_on_the_fleets_rig_the_correction_is_the_fleets_and_helps():
    reference = reference_for("travel-360", "fleet")
    envs = Heli3DOFVectorEnv(8, "fleet", reference, start_spread_deg=5.0, rig="fleet")
    policy = make_policy("residual", reference)
    assert policy.network.size == 64 and policy.scale == 10.4

    def travel_error(policy):
        flights = fly_many(envs, policy, VALIDATION_SEED)
        return np.mean([flight_metrics(f, reference, envs.voltage_limits).rms_error_deg[0] for f in flights])

    assert travel_error(policy) < 0.5 * travel_error(policy.base)


def test_a_recurrent_policy_flies_many_as_it_flies_each_and_forgets_at_a_reset():
    policy = make_policy("residual", REFERENCE)
    together = fly_many(Heli3DOFVectorEnv(3, "lab", start_spread_deg=5.0), policy, seed=7)
    env = Heli3DOFEnv("lab", start_spread_deg=5.0)
    for k, flight in enumerate(together):
        assert_allclose(fly(env, policy, seed=7 + k).x, flight.x, atol=1e-6)


@pytest.mark.parametrize("rig", ["paper", "fleet"])
def test_the_step_of_one_helicopter_is_that_of_many_even_far_from_the_reference(rig):
    rng = np.random.default_rng(0)
    alone, together = (make_policy("residual", reference_for("travel-360", rig)) for _ in range(2))
    for k in range(30):
        measurement = together.x[:, k] + rng.standard_normal(6) * (2.0 if k < 10 else 0.05)
        u, both = alone(0.02 * k, measurement), together(0.02 * k, measurement[:, None])
        assert_allclose(u, both[:, 0], atol=1e-11)
    assert alone.single_step is not None and together.single_step is None
    assert np.isnan(alone(0.6, np.full(6, np.nan))).all()


def test_a_correction_has_authority_where_the_base_saturates():
    base, measurement = make_policy("feedforward+tvlqr", SHORT), START + np.array([0.0, 0.0, 1.0, 0.0, 0.0, 0.0])
    assert base(0.0, measurement).max() > 12.0
    least = np.clip(base(0.0, measurement), 0.0, 12.0) - 12.0

    def voltages(law):
        return ResidualPolicy(base, SHORT, lambda features: -np.ones(2), 12.0, law=law)(0.0, measurement)

    assert_allclose(voltages("saturated"), least, atol=1e-12)  # at most zero: any voltage is within reach
    assert_allclose(voltages("sum"), base(0.0, measurement) - 12.0, atol=1e-12)
    assert voltages("sum").max() > 0.0
    with pytest.raises(ValueError, match="law = 'none'"):
        voltages("none")


def test_a_network_sees_the_groups_that_it_is_shown_and_each_of_them_counts():
    def shown(*feature_groups):
        policy = ResidualPolicy(make_policy("kalman-lqr", SHORT), SHORT, None, 1.0, feature_groups=feature_groups)
        return policy.observe(0.0, START)[1]

    parts = [shown(group) for group in FEATURE_GROUPS]
    assert all(len(part) for part in parts)
    assert_array_equal(np.concatenate(parts), shown(*FEATURE_GROUPS))


def test_a_learned_policy_survives_the_disk_and_is_flown_from_there(tmp_path):
    feature_groups = ("error", "estimate")
    count = len(
        ResidualPolicy(make_policy("kalman-lqr", SHORT), SHORT, None, 1.0, feature_groups=feature_groups).observe(
            0.0, START
        )[1]
    )
    settings = Learned("kalman-lqr", 1.5, "climb-7.5", "lab", 0.02, count, (16, 8), False, feature_groups)
    save_learned(tmp_path / "one", settings, network(count))
    again, loaded = load_learned(tmp_path / "one")
    assert again == settings
    features = np.random.default_rng(1).standard_normal((count, 5))
    assert_allclose(loaded(features), network(count)(features), atol=1e-6)

    env = Heli3DOFEnv("lab", SHORT)
    policy = ResidualPolicy(make_policy("kalman-lqr", SHORT), SHORT, loaded, 1.5, feature_groups=feature_groups)
    by_path = make_policy(str(tmp_path / "one.json"), SHORT)
    assert_array_equal(fly(env, policy, seed=0).x, fly(env, by_path, seed=0).x)


@pytest.mark.parametrize("damage", ["weights", "missing", "json", "field"])
def test_a_damaged_policy_is_refused_by_its_path(tmp_path, damage):
    path = tmp_path / "one"
    save_learned(path, Learned("zero", 1.0, "climb-7.5", "lab", 0.02, 4, (16, 8), True), network(4, tanh_output=True))
    if damage == "weights":
        data = bytearray(path.with_suffix(".safetensors").read_bytes())
        data[-1] ^= 1
        path.with_suffix(".safetensors").write_bytes(data)
    elif damage == "missing":
        path.with_suffix(".safetensors").unlink()
    elif damage == "json":
        path.with_suffix(".json").write_text("{")
    else:
        described = json.loads(path.with_suffix(".json").read_text())
        del described["scale"]
        path.with_suffix(".json").write_text(json.dumps(described))
    with pytest.raises(ValueError, match="one"):
        learned_policy(path, SHORT, 0.02, None, make_policy)


def test_bad_settings_are_named(tmp_path):
    with pytest.raises(ValueError, match="scale = -1"):
        ResidualPolicy(make_policy("zero", SHORT), SHORT, nothing, -1.0)
    with pytest.raises(ValueError, match=r"feature_groups = .*'moon'"):
        ResidualPolicy(make_policy("zero", SHORT), SHORT, nothing, 1.0, feature_groups=("error", "moon"))
    save_learned(tmp_path / "one", Learned("zero", 1.0, "climb-7.5", "lab", 0.02, 4, (16, 8), False), network(4))
    with pytest.raises(ValueError, match=r"control_period = 0\.01"):
        make_policy(str(tmp_path / "one.json"), SHORT, 0.01)


@pytest.mark.parametrize(
    ("setting", "value"),
    [
        ("base", "residual"),
        ("base", "one.json"),
        ("base", 3),
        ("hidden", [16]),
        ("hidden", [16, 9]),
        ("hidden", [16, "8"]),
        ("scale", "3"),
        ("scale", -1.0),
        ("scale", float("nan")),
        ("features", 5),
        ("control_period", 0.0),
        ("law", "moon"),
        ("feature_groups", ["moon"]),
        ("ahead", [-1.0]),
        ("tanh_output", 1),
    ],
)
@pytest.mark.parametrize("has_digest", [True, False])
def test_settings_that_were_changed_or_make_no_sense_are_refused(tmp_path, setting, value, has_digest):
    path = tmp_path / "one"
    save_learned(path, Learned("zero", 1.0, "climb-7.5", "lab", 0.02, 4, (16, 8), True), network(4, tanh_output=True))
    described = json.loads(path.with_suffix(".json").read_text())
    described[setting] = value
    if not has_digest:
        del described["settings_sha256"]
    path.with_suffix(".json").write_text(json.dumps(described))
    with pytest.raises(ValueError, match="one"):
        load_learned(path)


def test_deep_nesting_is_refused(tmp_path):
    (tmp_path / "one.json").write_text("[" * 100_000)
    (tmp_path / "one.safetensors").write_bytes(b"")
    with pytest.raises(ValueError, match="no learned policy"):
        load_learned(tmp_path / "one")


def test_weights_that_are_not_finite_are_refused(tmp_path):
    bad = network(4)
    bad.weights[1][0, 0] = np.nan
    save_learned(tmp_path / "one", Learned("zero", 1.0, "climb-7.5", "lab", 0.02, 4, (16, 8), False), bad)
    with pytest.raises(ValueError, match=r"1\.weight: must hold finite numbers"):
        load_learned(tmp_path / "one")


@pytest.mark.parametrize("base", ["feedforward+tvlqr", "kalman-lqr"])
def test_before_the_start_of_the_reference_its_first_sample_counts(base):
    alone, together = (ResidualPolicy(make_policy(base, SHORT), SHORT, nothing, 1.0) for _ in range(2))
    start = START + 0.01
    assert_array_equal(alone(-0.02, start), make_policy(base, SHORT)(0.0, start))
    u = together(np.array([-0.5, 0.0]), np.stack((start, start), axis=1))
    assert_array_equal(u[:, 0], u[:, 1])
    assert_array_equal(make_policy("residual", SHORT)(-0.02, start), make_policy("residual", SHORT)(0.0, start))


@pytest.mark.parametrize("duplicate", [copy.deepcopy, lambda policy: pickle.loads(pickle.dumps(policy))])
def test_a_copy_of_a_learned_policy_flies_on_as_the_policy_itself(duplicate):
    policy = make_policy("residual", SHORT)
    for k in range(20):
        policy(0.02 * k, SHORT.x[:, k] + 0.01)
    other = duplicate(policy)
    for k in range(20, 40):
        assert_array_equal(other(0.02 * k, SHORT.x[:, k] - 0.01), policy(0.02 * k, SHORT.x[:, k] - 0.01))
