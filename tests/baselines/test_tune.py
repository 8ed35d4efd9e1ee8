"""Tuner: search, flights, and equal budgets of all policies."""

import json
from dataclasses import astuple
from typing import get_args, get_type_hints

import numpy as np
import pytest
from numpy.testing import assert_allclose

from heli_gym.baselines import fly, make_policy
from heli_gym.baselines.commands import tune
from heli_gym.baselines.control.weights import TVLQR, WEIGHTS, stored_weights
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.plant import HELD_OUT_SEED
from heli_gym.vector_env import Heli3DOFVectorEnv

REFERENCE = find_reference("climb-7.5")


def test_every_policy_with_weights_can_be_tuned():
    assert set(get_args(get_type_hints(tune.Args)["policy"])) == set(WEIGHTS)


@pytest.mark.parametrize("name", WEIGHTS)
def test_all_weights_but_that_on_the_thrust_sum_are_searched_and_those_in_use_are_within(name):
    weights = WEIGHTS[name]
    names = tune.search_names(weights)
    assert set(vars(weights)) - set(names) <= {"thrust_sum"}
    for weight in names:
        low, high = tune.search_range(weights, weight)
        assert low < np.log10(getattr(weights, weight)) < high


@pytest.mark.parametrize("name", WEIGHTS)
def test_weights_follow_from_their_decades(name):
    weights = WEIGHTS[name]
    decades = np.log10([getattr(weights, weight) for weight in tune.search_names(weights)])
    assert_allclose(astuple(tune.with_decades(weights, decades)), astuple(weights))


@pytest.mark.parametrize("plant", ["nominal", "lab"])
def test_the_returns_are_those_of_single_flights(plant):
    policy = make_policy("kalman-lqr", REFERENCE)
    together = tune.returns(Heli3DOFVectorEnv(3, plant, REFERENCE, start_spread_deg=5.0), policy, 7)
    env = Heli3DOFEnv(plant, REFERENCE, start_spread_deg=5.0)
    for k in range(3):
        flight = fly(env, policy, seed=7 + k)
        alone = flight_metrics(flight, REFERENCE, AMPLIFIER_LIMITS).episode_return
        assert together[k] == pytest.approx(alone, rel=1e-6)


def test_a_flight_that_ends_early_earns_no_more():
    class FullThrottleOfOne:
        def reset(self, rng):
            pass

        def __call__(self, t, measurement):
            return np.array([[12.0], [0.0]]) + np.zeros(measurement.shape[1])

    envs = Heli3DOFVectorEnv(2, "nominal", REFERENCE)
    assert tune.returns(envs, FullThrottleOfOne(), 0).max() < 1.0  # it turns over within a second


def test_a_flight_that_ends_early_is_charged_to_the_end_so_that_a_crash_never_pays():
    envs = Heli3DOFVectorEnv(2, "nominal", REFERENCE)
    crashed = tune.returns(envs, FullThrottleOfOne(), 0, "tracking")
    flown = tune.returns(envs, make_policy("hover-lqr", REFERENCE), 0, "tracking")
    assert crashed.max() < -1.0 < flown.min()  # 5 s at more than 0.5 per second, but for the first second


@pytest.mark.parametrize("name", WEIGHTS)
def test_the_budget_is_the_same_for_all_and_only_better_weights_replace_those_in_use(name, monkeypatch, capsys):
    flown = []

    def worse_and_worse(envs, policy, seed, objective):
        flown.append(policy)
        return np.full(2, -float(len(flown)))

    monkeypatch.setattr(tune, "returns", worse_and_worse)
    tune.main(tune.Args(policy=name, reference="climb-7.5", draws=2, candidates=24, population=8))
    assert len(flown) == 2 * (24 + 4)  # and the judgement: two sets of weights on two sets of draws
    printed = capsys.readouterr().out
    assert all(f"{weight} = {value:.3g}\n" in printed for weight, value in vars(WEIGHTS[name]).items())


@pytest.mark.parametrize(("candidates", "flown"), [(8, 8), (15, 8), (16, 16)])
def test_evolution_never_flies_more_candidates_than_its_budget(candidates, flown, tmp_path, monkeypatch):
    monkeypatch.setattr(tune, "returns", lambda envs, policy, seed, objective: np.zeros(2))
    small = {"policy": "flatness", "reference": "climb-7.5", "draws": 2, "population": 8}
    tune.main(tune.Args(**small, candidates=candidates, study=tmp_path / "study.json"))
    assert len(json.loads((tmp_path / "study.json").read_text())["candidates"]) == flown


def test_no_search_flies_the_draws_of_evaluations():
    tune.check(tune.Args(seed=HELD_OUT_SEED - 64, draws=32))
    for seed in (HELD_OUT_SEED - 63, HELD_OUT_SEED, -1):
        with pytest.raises(ValueError, match=f"seed = {seed}: must be at least 0 and, with draws = 32, at most"):
            tune.check(tune.Args(seed=seed, draws=32))


@pytest.mark.parametrize("method", ["evolution", "tpe"])
def test_a_study_repeats_and_its_best_candidate_is_stored(method, tmp_path, monkeypatch):
    pytest.importorskip("optuna")

    def nearer_is_better(envs, policy, seed, objective):  # the best travel gain is 2, of all others any
        return np.full(2, -(np.log(policy.gains.travel / 2.0) ** 2))

    monkeypatch.setattr(tune, "returns", nearer_is_better)
    monkeypatch.setattr("heli_gym.baselines.control.weights.stored.TUNED", tmp_path)
    small = {"policy": "flatness", "plants": ("lab",), "reference": "climb-7.5", "draws": 2, "population": 8}
    files = [tmp_path / "one" / "study.json", tmp_path / "two" / "study.json"]
    for file in files:
        file.parent.mkdir()
        tune.main(tune.Args(**small, method=method, candidates=48, store=True, study=file))
    one, two = (json.loads(file.read_text()) for file in files)
    assert one["candidates"] == two["candidates"]
    assert len(one["candidates"]) == 48
    assert one["candidates"][0][1:] == pytest.approx(list(one["in_use"].values()))
    best = max(one["candidates"])
    assert best[0] > one["candidates"][0][0]
    assert stored_weights("flatness", "lab").travel == pytest.approx(best[1], rel=1e-3)
    assert best[1] == pytest.approx(2.0, rel=0.2)


def test_weights_that_were_found_are_printed_even_if_they_cannot_be_written(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(tune, "returns", lambda envs, policy, seed, objective: np.zeros(2))
    monkeypatch.setattr(tune, "write_study", lambda *_: (_ for _ in ()).throw(OSError(28, "No space left on device")))
    small = {"policy": "flatness", "reference": "climb-7.5", "draws": 2, "candidates": 8, "population": 8}
    with pytest.raises(SystemExit):
        tune.main(tune.Args(**small, study=tmp_path / "study.json"))
    printed = capsys.readouterr()
    assert f"travel = {WEIGHTS['flatness'].travel:.3g}\n" in printed.out
    assert "No space left on device" in printed.err


class FullThrottleOfOne:
    def reset(self, rng):
        pass

    def __call__(self, t, measurement):
        return np.array([[12.0], [0.0]]) + np.zeros(measurement.shape[1])


@pytest.mark.parametrize(
    ("action", "same"), [((0.0, 0.0), lambda: make_policy("lag-lqr", REFERENCE)), ((1.0, -1.0), FullThrottleOfOne)]
)
def test_the_tracking_return_of_an_agent_is_that_of_the_policy_that_it_flies_crash_or_not(action, same):
    pytest.importorskip("stable_baselines3")
    from heli_gym.baselines.control.residual import ResidualPolicy
    from heli_gym.train.vec_env import ResidualVecEnv

    expected = tune.returns(Heli3DOFVectorEnv(2, "lab", REFERENCE), same(), 0, objective="tracking")
    policy = ResidualPolicy(make_policy("lag-lqr", REFERENCE), REFERENCE, None, 12.0)
    vec = ResidualVecEnv(Heli3DOFVectorEnv(2, "lab", REFERENCE, autoreset_mode="SameStep"), policy, spread=False)
    vec.seed(0)
    vec.reset()
    total, over = np.zeros(2), np.zeros(2, bool)
    while not over.all():
        _, rewards, done, _ = vec.step(np.tile(np.float32(action), (2, 1)))
        total += np.where(over, 0.0, 0.02 * rewards)
        over |= done
    assert_allclose(total, expected, rtol=1e-5)
    assert (total < -1.0).all() == (action != (0.0, 0.0))


def test_an_agent_is_charged_for_a_crash_at_its_own_discount():
    pytest.importorskip("stable_baselines3")
    from heli_gym.baselines.control.residual import ResidualPolicy
    from heli_gym.train.vec_env import ResidualVecEnv

    charges = []
    for discount in (1.0, 0.99):
        policy = ResidualPolicy(make_policy("lag-lqr", REFERENCE), REFERENCE, None, 12.0)
        envs = Heli3DOFVectorEnv(2, "lab", REFERENCE, autoreset_mode="SameStep")
        charges.append(ResidualVecEnv(envs, policy, discount=discount).crash_charge(1.6, REFERENCE.duration - 2.0))
    assert charges[0] > 0.0
    assert charges[1] / charges[0] == pytest.approx(sum(0.99**k for k in range(1, 101)) / 100)  # 2 s are 100 periods


def test_weights_are_stored_for_one_plant_only(tmp_path, monkeypatch):
    with pytest.raises(SystemExit, match="heli-tune: plants = "):
        tune.main(tune.Args(store=True))
    monkeypatch.setattr(tune, "returns", lambda envs, policy, seed, objective: np.zeros(2))
    monkeypatch.setattr("heli_gym.baselines.control.weights.stored.TUNED", tmp_path)
    tune.main(tune.Args(plants=("rigid",), store=True, reference="climb-7.5", draws=2, candidates=8, population=8))
    assert vars(stored_weights("feedforward+tvlqr", "rigid")).keys() == vars(TVLQR).keys()


@pytest.mark.slow
@pytest.mark.parametrize("method", ["evolution", "tpe"])
def test_any_number_of_processes_finds_the_same_weights(method, tmp_path):
    if method == "tpe":
        pytest.importorskip("optuna")
    small = {"policy": "lqi", "reference": "climb-7.5", "draws": 2, "candidates": 16, "population": 8}
    found = []
    for workers in (2, 3):
        file = tmp_path / f"{workers}.json"
        tune.main(tune.Args(**small, method=method, workers=workers, study=file))
        found.append(json.loads(file.read_text())["candidates"])
    assert found[0] == found[1]
