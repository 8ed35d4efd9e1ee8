import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("rich")

from numpy.testing import assert_array_equal
from rich.console import Console

from heli_gym.baselines import fly, make_policy
from heli_gym.baselines.control.residual import load_learned, save_learned
from heli_gym.baselines.evaluation.statistics import improvement, interquartile_mean
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.plant import Plant, Push, find_plant
from heli_gym.train import results
from heli_gym.train.oracle import EFFORT, NoOptimum, Oracle
from heli_gym.train.results import Args, compare, table_of
from heli_gym.vector_env import Heli3DOFVectorEnv

SMALL = Args(policies=("feedforward+tvlqr",), against="feedforward+tvlqr", reference="climb-7.5")
RESULTS = Path(__file__).parents[2] / "results"


def test_every_policy_flies_the_same_draws_and_the_table_agrees_with_the_flights(tmp_path):
    args = Args(
        policies=("feedforward+tvlqr", "kalman-lqr"),
        against="feedforward+tvlqr",
        reference="climb-7.5",
        episodes=6,
        out=tmp_path,
    )
    found = compare(args, Console(quiet=True))
    assert {name: values.shape for name, values in found.items()} == {
        "feedforward+tvlqr": (len(results.METRICS), 1, 6),
        "kalman-lqr": (len(results.METRICS), 1, 6),
    }
    _, rows = table_of(args, found)
    json.dumps(rows)
    assert rows["feedforward+tvlqr"]["travel improvement"]["share"] == 0.0
    assert rows["kalman-lqr"]["elevation"]["iqm"] == interquartile_mean(found["kalman-lqr"][1])
    results.draw_profiles(tmp_path / "profiles.png", args, found)
    assert (tmp_path / "profiles.png").read_bytes()[:4] == b"\x89PNG"


def test_an_earlier_table_and_its_profiles_are_listed_before_they_are_replaced(tmp_path, capsys):
    names = [str(tmp_path / name) for name in ("lab.json", "lab-profiles.png")]
    for name in names:
        Path(name).touch()
    results.run(replace(SMALL, episodes=2, out=tmp_path))
    assert f"heli-results: replaces {', '.join(names)} of an earlier run\n" in capsys.readouterr().err


def test_a_method_is_flown_once_for_each_of_its_seeds(tmp_path):
    seeds = [RESULTS / f"lab/{stage}/0/best" for stage in ("first-stage", "residual")]
    for seed, path in enumerate(seeds):
        save_learned(tmp_path / f"mine/{seed}/best", *load_learned(path))
    args = Args(policies=("kalman-lqr",), against="kalman-lqr", methods=(tmp_path / "mine",), episodes=3, out=tmp_path)
    found = compare(args, Console(quiet=True))["mine"]
    assert found.shape == (len(results.METRICS), 2, 3)
    envs = Heli3DOFVectorEnv(3, "lab", start_spread_deg=results.START_SPREAD_DEG)
    assert_array_equal(
        found[:, 1], results.policy_metrics(envs, make_policy(f"{seeds[1]}.json", envs.reference_of(0)), args.seed)
    )


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ({"methods": (Path("nowhere"),)}, "nowhere"),
        ({"methods": (RESULTS / "lab/residual", RESULTS / "rigid/residual")}, "two are called 'residual'"),
        ({"episodes": 1}, "episodes"),
        ({"against": "zero"}, "against"),
        ({"oracle": -1}, "oracle"),
        ({"plant": "x"}, "plant"),
        ({"plant": "nominal", "oracle": 1}, "plant: the lag"),
        ({"policies": ("feedforward+tvlqr@PLANT", "foo")}, "name = 'foo'"),
    ],
)
def test_bad_settings_are_named_before_anything_is_flown(tmp_path, monkeypatch, change, name):
    monkeypatch.setattr(results, "fly_many", lambda *args: pytest.fail("flown"))
    with pytest.raises(ValueError, match=name):
        compare(Args(out=tmp_path, **change), Console(quiet=True))


def test_a_draw_without_optimum_is_left_out_of_the_oracles_row_and_no_other(tmp_path, monkeypatch, capsys):
    args = replace(SMALL, episodes=4, oracle=3, out=tmp_path)
    asked = []

    def policy(self, plant, x, u, control_period):
        asked.append(plant)
        if len(asked) == 2:
            raise NoOptimum("no optimal voltages for this one")
        return make_policy("kalman-lqr", find_reference("climb-7.5"))

    monkeypatch.setattr(Oracle, "policy", policy)
    found = compare(args, Console())
    assert f"seed {args.seed + 1}, left out of the oracle's row: no optimal" in " ".join(
        capsys.readouterr().out.split()
    )
    _, rows = table_of(args, found)
    assert (rows["oracle"]["draws"], rows["feedforward+tvlqr"]["draws"]) == (2, 4)
    kept = found["oracle"][:, :, [0, 2]]
    assert np.isfinite(kept).all()
    assert rows["oracle"]["travel"]["iqm"] == interquartile_mean(kept[0])
    assert rows["oracle"]["travel improvement"] == improvement(kept[0], found["feedforward+tvlqr"][0][:, [0, 2]])
    results.draw_profiles(tmp_path / "profiles.png", args, found)


def test_without_any_optimum_the_oracle_has_no_row(tmp_path, monkeypatch):
    def policy(*args):
        raise NoOptimum("none")

    monkeypatch.setattr(Oracle, "policy", policy)
    args = replace(SMALL, episodes=2, oracle=1, out=tmp_path)
    assert set(compare(args, Console(quiet=True))) == {"feedforward+tvlqr"}


def test_two_processes_fly_the_oracle_as_one_does_and_its_flights_are_flown_once(tmp_path, monkeypatch):
    args = replace(SMALL, episodes=2, oracle=2, workers=2, out=tmp_path)
    twice = compare(args, Console(quiet=True))["oracle"]
    once = compare(replace(args, workers=1, out=tmp_path / "one"), Console(quiet=True))["oracle"]
    assert_array_equal(twice, once)
    monkeypatch.setattr(Oracle, "policy", None)
    assert_array_equal(compare(args, Console(quiet=True))["oracle"], once)
    with pytest.raises(TypeError):  # another reference, another flight
        compare(replace(args, reference="climb-15", workers=1), Console(quiet=True))


@pytest.mark.parametrize("damage", [{"flights": None}, {"flights": {"2147483648": [1.0]}}, {"settings": {}}, {}])
def test_damaged_flights_of_the_oracle_are_flown_again(tmp_path, monkeypatch, damage):
    monkeypatch.setattr(Oracle, "policy", lambda *args: make_policy("kalman-lqr", find_reference("climb-7.5")))
    args = replace(SMALL, episodes=2, oracle=1, out=tmp_path)
    first = compare(args, Console(quiet=True))["oracle"]
    path = tmp_path / "lab-oracle.json"
    stored = json.loads(path.read_text())
    path.write_text(json.dumps({**stored, **damage} if damage else {}))
    assert_array_equal(compare(args, Console(quiet=True))["oracle"], first)
    assert json.loads(path.read_text()) == stored


def delayed(name):
    """The plant of this name with a delay of one control period of 0.05 s."""
    plant = find_plant(name)
    return replace(plant, rotors=replace(plant.rotors, delay=0.05))


def test_a_solver_that_gives_up_says_so():
    env = Heli3DOFEnv(delayed("lab"), "climb-7.5", 0.05)
    oracle = Oracle(env.plant, env.reference, env.control_period, env.voltage_limits, env.pitch_limit)
    env.reset(seed=0)
    with pytest.raises(NoOptimum, match=r"no optimal voltages for .*: Invalid_Number_Detected"):
        oracle.policy(env.drawn_plant, np.full(6, np.nan), env.reference.u[:, 0], env.control_period)


@pytest.mark.slow
@pytest.mark.parametrize("plant", ["lab", "rigid"])
def test_the_oracle_flies_its_plan_and_no_policy_is_better(plant):
    env = Heli3DOFEnv(delayed(plant), "climb-7.5", 0.05, start_spread_deg=5.0)
    reference = env.reference
    oracle = Oracle(env.plant, reference, env.control_period, env.voltage_limits, env.pitch_limit)
    _, info = env.reset(seed=5)
    policy = oracle.policy(env.drawn_plant, info["state"], reference.u[:, 0], env.control_period)

    def cost(flight):
        degrees = np.degrees(flight.x[[0, 2], 1:] - oracle.x_ref[[0, 2], 1 : flight.x.shape[1]])
        return (degrees**2).sum() + EFFORT * ((flight.u[:, :-1] - oracle.u_ref) ** 2).sum()

    flight = fly(env, policy, seed=5)
    assert cost(flight) == pytest.approx(float(oracle.found["f"]), rel=1e-6)  # its model is the environment's
    for name in ("feedforward+tvlqr", "kalman-lqr"):
        assert cost(flight) < cost(fly(env, make_policy(name, reference, env.control_period), seed=5))


def test_the_oracle_refuses_plants_that_its_problem_leaves_out():
    env = Heli3DOFEnv("lab", "climb-7.5")
    with pytest.raises(ValueError, match="disturbances"):
        Oracle(Plant(disturbances=(Push("pitch", 1.0, 1.0),)), env.reference, 0.02, (0.0, 12.0), 1.4)
