"""Studies: a trial for every combination, searches by Optuna, and errors by name."""

import json
import tomllib
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

import pytest

pytest.importorskip("stable_baselines3")

from heli_gym.baselines.control.residual import LEARNED, load_learned, save_learned
from heli_gym.env import find_reference
from heli_gym.rig import PAPER
from heli_gym.train import train
from heli_gym.train.study import Proposals, Search, Trial, check_distinct, corners, read_study, to_settings, trials_of
from heli_gym.trajectory import Trajectory

EXAMPLES = Path(__file__).parents[2] / "examples"
TINY = """
[settings]
plant = "lab"
reference = "climb-7.5"
algo = "ppo"
steps = 256
envs = 4
chunk = 64
rollout = 64
batch = 64
validation = 2
hidden = [8]
"""
SEARCH = """
[search]
trials = 5
batch = 2
[search.space]
learning_rate = { low = 1e-4, high = 1e-2, log = true }
epochs = { low = 1, high = 9, step = 2 }
objective = ["tracking", "environment"]
"""


def study(tmp_path, text):
    path = tmp_path / "study.toml"
    path.write_text(text)
    return read_study(path)


def test_there_is_a_trial_for_every_combination(tmp_path):
    text = TINY.replace('algo = "ppo"\n', "") + '[grid]\nseed = [3, 4]\nalgo = ["ppo", "td3"]\nlearning_rate = [0.1]\n'
    trials = trials_of(study(tmp_path, text))
    assert [(trial.args.seed, trial.args.algo) for trial in trials] == [(3, "ppo"), (3, "td3"), (4, "ppo"), (4, "td3")]
    assert {trial.args.hidden for trial in trials} == {(8,)}
    assert trials[1].folder == "runs/lab/td3-feedforward+tvlqr@lab,learning_rate=0.1/3"
    assert len({trial.key for trial in trials}) == 4


def test_a_trial_has_the_settings_of_a_single_run(tmp_path):
    trial = trials_of(study(tmp_path, f"{TINY}[grid]\nseed = [3]\n"))[0]
    settings = {"plant": "lab", "reference": "climb-7.5", "algo": "ppo", "steps": 256, "envs": 4, "chunk": 64}
    settings |= {"rollout": 64, "batch": 64, "validation": 2, "hidden": (8,), "seed": 3}
    assert train.settings_of(trial.args) == train.settings_of(train.with_defaults(train.Args(**settings)))


def test_names_in_braces_stand_for_the_values_of_the_trial(tmp_path):
    (tmp_path / "3.json").touch()
    text = f'[settings]\ninit = "{tmp_path}/{{seed}}.json"\n[grid]\nseed = [3]\n'
    (trial,) = trials_of(study(tmp_path, text))
    assert trial.args.init == tmp_path / "3.json"
    with pytest.raises(ValueError, match=r"trial 1: init = .*4\.json"):
        trials_of(study(tmp_path, text.replace("[3]", "[4]")))


def test_the_key_of_a_trial_changes_with_the_contents_of_its_files_and_without_files_is_that_of_its_settings(tmp_path):
    (plain,) = trials_of(study(tmp_path, f"{TINY}[grid]\nseed = [3]\n"))
    settings = json.dumps(train.settings_of(plain.args), sort_keys=True)
    assert plain.key == sha256(settings.encode()).hexdigest()[:16]
    init, plan, rig = tmp_path / "best", tmp_path / "plan.npz", tmp_path / "rig.toml"
    found = find_reference("climb-7.5")
    text = f'[settings]\ninit = "{init}.json"\nreference = "{plan}"\nrig = "{rig}"\n[grid]\nseed = [3]\n'

    def key_of(scale, share, lag):
        save_learned(init, replace(load_learned(LEARNED / "lab")[0], scale=scale), load_learned(LEARNED / "lab")[1])
        Trajectory(found.t, share * found.x, found.u, found.limits).save(plan)
        replace(PAPER, lag=lag).save(rig)
        return Trial(train.with_defaults(train.Args(**to_settings(tomllib.loads(text)["settings"]))), {}, "").key

    first = key_of(3.0, 1.0, 0.1)
    assert key_of(3.0, 1.0, 0.1) == first
    assert len({first, key_of(2.0, 1.0, 0.1), key_of(3.0, 0.5, 0.1), key_of(3.0, 1.0, 0.2)}) == 4


@pytest.mark.parametrize(("name", "number"), [("sweep-smoke", 3), ("sweep-search", 2)])
def test_the_examples_are_studies(name, number):
    example = read_study(EXAMPLES / f"{name}.toml")
    candidates = [None] if example.search is None else list(corners(example))
    for candidate in candidates:
        trials = trials_of(example, candidate)
        check_distinct(trials)
        assert len(trials) == number


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[settings", "must be TOML"),
        ("[setings]\nplant = 'lab'", "setings"),
        ("settings = 3", "must be tables"),
        ("[settings]\nplent = 'lab'", "'plent' must be a setting"),
        ("[settings]\nout = 'x'", "'out' must be a setting"),
        ("[grid]\nseed = 3", "grid.seed = 3"),
        ("[grid]\nseed = []", "grid.seed"),
        ("[settings]\nseed = 1\n[grid]\nseed = [1, 2]", "not in both"),
        ("[grid]\nseed = [1, 1]", "trials 1 and 2 have the same"),
        ("[grid]\nseed = [1, -1]", "trial 2: seed = -1"),
        ("[grid]\nseed = ['a']", "seed = 'a'"),
        ("[settings]\nalgo = 'dqn'", "algo = 'dqn'"),
        ("[settings]\nplant = 'lunar'", "lunar"),
        ("[settings]\nrig = 'lunar'", "lunar"),
        ("[settings]\nreference = 'lunar'", "lunar"),
        ("[settings]\ninit = 'none.json'", "init = 'none.json'"),
        ("[settings]\nmode = 'scratch'", "mode = 'scratch'"),
        (f"[grid]\nseed = {list(range(200))}\nsteps = {list(range(1, 200))}", "at most 10000"),
        ("[search]\ntrials = 3", "search must have trials, and a space"),
        ("[search]\ntrials = 3\nspaces = 1", "search.spaces must be one of"),
        (SEARCH.replace("trials = 5", "trials = 0"), "search.trials = 0"),
        (SEARCH.replace("batch = 2", "batch = 'a'"), "search.batch = 'a'"),
        (SEARCH.replace("batch = 2", "metric = 'luck'"), "search.metric = 'luck'"),
        (SEARCH.replace("learning_rate", "learning_rat"), "'learning_rat' must be a setting"),
        (SEARCH.replace("low = 1e-4, ", ""), "learning_rate .*must be a list of choices, or a range"),
        (SEARCH.replace("low = 1e-4", "low = -1e-4"), "learning_rate .*low must be positive with log"),
        (SEARCH.replace("low = 1e-4", "low = 1"), "learning_rate .*low must be less than high"),
        (SEARCH.replace("low = 1e-4", "low = nan"), "learning_rate .*low must be less than high"),
        (SEARCH.replace("low = 1e-4", "low = 'a'"), "learning_rate .*must be numbers"),
        (SEARCH.replace("log = true", "log = 1"), "learning_rate .*log must be true or false"),
        (SEARCH.replace("low = 1,", "low = -1,"), "epochs = -1: must be 1 to 1000"),
        (SEARCH.replace('"environment"', '"luck"'), "objective = 'luck'"),
        (f"[grid]\nepochs = [1]\n{SEARCH}", "'epochs': must be in one of"),
    ],
)
def test_an_error_of_a_study_is_named(tmp_path, text, words):
    with pytest.raises(ValueError, match=words):
        found = study(tmp_path, text)
        for candidate in corners(found) if found.search else [None]:
            check_distinct(trials_of(found, candidate))


@pytest.mark.parametrize("text", ["[settings", "[setings]", "[settings]\nplent = 'lab'", "[search]\ntrials = 3"])
def test_an_error_of_a_study_names_its_file(tmp_path, text):
    with pytest.raises(ValueError, match=r"^study = '.*/study\.toml': "):
        study(tmp_path, text)


def test_proposals_depend_on_the_values_of_earlier_candidates_only():
    pytest.importorskip("optuna")
    space = {"learning_rate": {"low": 1e-4, "high": 1e-2, "log": True}, "epochs": {"low": 1, "high": 9, "step": 2}}
    search = Search(trials=23, space={**space, "objective": ["tracking", "environment"]}, metric="cost")

    def follow(values):
        proposals, found = Proposals(search), []
        while batch := proposals.propose():
            found += batch
            proposals.learn([values(candidate) for candidate in batch])
        return found, proposals.best()

    first, best = follow(lambda candidate: abs(candidate["learning_rate"] - 1e-3))
    again, _ = follow(lambda candidate: abs(candidate["learning_rate"] - 1e-3))
    other, _ = follow(lambda candidate: -candidate["learning_rate"])
    assert first == again and len(first) == 23
    assert first[:4] == other[:4] and first != other
    assert best == min(((c, abs(c["learning_rate"] - 1e-3)) for c in first), key=lambda pair: pair[1])
    assert {c["epochs"] for c in first} <= {1, 3, 5, 7, 9} and all(isinstance(c["epochs"], int) for c in first)
    failed, best = follow(lambda candidate: None)
    assert len(failed) == 23 and best is None
