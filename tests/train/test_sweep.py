"""`heli-sweep`: trials of studies, messages for invalid ones, and equality of a trial with a run of `heli-train`."""

import csv
import os
from dataclasses import replace
from pathlib import Path

import pytest

pytest.importorskip("stable_baselines3")

from rich.console import Console
from safetensors.numpy import load_file

from heli_gym.train import sweep, train

SMOKE = Path(__file__).parents[2] / "examples" / "sweep-smoke.toml"
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

[grid]
seed = [3, 4]
"""


def study(tmp_path, text):
    path = tmp_path / "study.toml"
    path.write_text(text)
    return path


def test_a_trial_for_every_combination(tmp_path):
    text = TINY.replace('algo = "ppo"\n', "") + 'algo = ["ppo", "td3"]\n'
    trials = sweep.read_study(study(tmp_path, text))
    assert [(trial.seed, trial.algo) for trial in trials] == [(3, "ppo"), (3, "td3"), (4, "ppo"), (4, "td3")]
    assert {trial.hidden for trial in trials} == {(8,)}


def test_the_example_is_a_study():
    trials = sweep.check_trials(sweep.read_study(SMOKE), sweep.Args(SMOKE, out=Path("out/never-made")))
    assert [trial.seed for trial in trials] == [0, 1, 2]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[settings", "must be TOML"),
        ("[setings]\nplant = 'lab'", "setings"),
        ("[settings]\nplent = 'lab'", "'plent' must be a setting"),
        ("[settings]\nout = 'x'", "'out' must be a setting"),
        ("[grid]\nseed = 3", "grid.seed = 3"),
        ("[grid]\nseed = []", "grid.seed"),
        ("[settings]\nseed = 1\n[grid]\nseed = [1, 2]", "not in both"),
        ("[grid]\nseed = [1, 1]", "trials 1 and 2 have the same"),
        ("[grid]\nsteps = [100, 200]", "trials 1 and 2 have the same"),
        ("[grid]\nseed = [1, -1]", "trial 2: seed = -1"),
        ("[grid]\nseed = ['a']", "seed = 'a'"),
        ("[settings]\nalgo = 'dqn'", "algo = 'dqn'"),
        ("[settings]\nplant = 'lunar'", "lunar"),
        (f"[grid]\nseed = {list(range(200))}\nsteps = {list(range(1, 200))}", "at most 10000"),
    ],
)
def test_bad_studies_are_refused_by_name_before_the_first_trial(tmp_path, monkeypatch, text, words):
    monkeypatch.setattr(sweep, "run_trial", lambda trial: pytest.fail("run"))
    path = study(tmp_path, text)
    with pytest.raises(SystemExit, match=words) as end:
        sweep.main(sweep.Args(path, out=tmp_path / "out"))
    assert end.value.code == 2
    assert os.listdir(tmp_path) == ["study.toml"]


def test_a_missing_study_is_status_1_and_bad_workers_are_named(tmp_path):
    with pytest.raises(SystemExit) as end:
        sweep.main(sweep.Args(tmp_path / "none.toml"))
    assert end.value.code == 1
    with pytest.raises(SystemExit, match="workers = 0"):
        sweep.main(sweep.Args(study(tmp_path, TINY), workers=0, out=tmp_path / "out"))


@pytest.mark.slow
def test_a_trial_ends_with_the_weights_of_a_single_run_and_a_study_is_resumed(tmp_path):
    path, out = study(tmp_path, TINY), tmp_path / "out"
    sweep.main(sweep.Args(path, out=out))
    with open(out / "trials.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["seed"], row["steps"]) for row in rows] == [("3", "256"), ("4", "256")]
    single = replace(sweep.read_study(path)[0], out=tmp_path / "single", progress=False)
    folder = train.train(single, Console(quiet=True))
    ours, theirs = load_file(Path(rows[0]["run"]) / "best.safetensors"), load_file(folder / "best.safetensors")
    assert {name: value.tobytes() for name, value in ours.items()} == {
        name: value.tobytes() for name, value in theirs.items()
    }
    with pytest.raises(SystemExit, match="--resume goes on"):
        sweep.main(sweep.Args(path, out=out))
    sweep.main(sweep.Args(path, out=out, resume=True))
