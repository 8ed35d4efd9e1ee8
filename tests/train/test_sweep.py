"""`heli-sweep`: trials equal single runs of `heli-train`, also after losses of processes and of the command itself."""

import csv
import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from hashlib import sha256

import pytest

pytest.importorskip("stable_baselines3")

from rich.console import Console

from heli_gym.train import store as stores
from heli_gym.train import sweep, train
from heli_gym.train.store import Store
from heli_gym.train.study import read_study, trials_of

TINY = """
[settings]
plant = "lab"
reference = "climb-7.5"
algo = "ppo"
steps = 512
envs = 4
chunk = 64
rollout = 64
batch = 64
validation = 2
hidden = [8]
"""
SEEDS = TINY + "[grid]\nseed = [3, 4]\n"
SEARCH = f"""{SEEDS}
[search]
trials = 3
batch = 2
metric = "rms_travel_deg"
[search.space]
learning_rate = {{ low = 1e-4, high = 1e-2, log = true }}
"""


def study(tmp_path, text=SEEDS):
    path = tmp_path / "study.toml"
    path.write_text(text)
    return path


def args(path, out, **options):
    return sweep.Args(path, **{"out": str(out), "workers": 1, **options})


def weights(store):
    """Digests of the weights of all trials, by folder."""
    return {record["run"]: record["weights_sha256"] for record in sweep.read_records(store).values()}


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    """Digests of the weights that `heli-train` gives, by folder of the trial."""
    folder = tmp_path_factory.mktemp("single")
    digests = {}
    for trial in trials_of(read_study(study(folder))):
        single = train.train(replace(trial.args, out=folder, resume=False), Console(quiet=True))
        digests[trial.folder] = sha256((single / "best.safetensors").read_bytes()).hexdigest()
    return digests


@pytest.fixture(scope="module")
def swept(tmp_path_factory):
    """Folder of a finished study."""
    folder = tmp_path_factory.mktemp("swept")
    sweep.main(args(study(folder), folder / "out"))
    return folder


def test_a_trial_ends_with_the_weights_of_a_single_run(swept, undisturbed):
    assert weights(Store(str(swept / "out"))) == undisturbed
    for folder, digest in undisturbed.items():
        assert sha256((swept / "out" / folder / "best.safetensors").read_bytes()).hexdigest() == digest
        assert {"best.json", "history.json", "settings.json"} <= set(os.listdir(swept / "out" / folder))


def test_the_tables_hold_every_trial_and_the_means_over_seeds(swept):
    with open(swept / "out" / "trials.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["plant"], row["seed"], row["steps"]) for row in rows] == [("lab", "3", "512"), ("lab", "4", "512")]
    with open(swept / "out" / "summary.csv", newline="") as file:
        (summary,) = csv.DictReader(file)
    assert summary["seeds"] == "2"
    values = [float(row["rms_travel_deg"]) for row in rows]
    assert float(summary["rms_travel_deg"]) == pytest.approx(sum(values) / 2)
    assert min(values) <= float(summary["rms_travel_deg_low"]) <= float(summary["rms_travel_deg_high"]) <= max(values)


def test_the_state_of_a_study_is_json(swept):
    record = json.loads(next((swept / "out" / "trials").iterdir()).read_text())
    history = json.loads((swept / "out" / record["run"] / "history.json").read_text())
    assert [record["rms_travel_deg"], record["rms_elevation_deg"]] in [row["rms_error_deg"][:2] for row in history[1:]]
    assert json.loads((swept / "out" / "study.json").read_text())["grid"] == {"seed": [3, 4]}
    assert not (swept / "out" / "unfinished").exists() or not list((swept / "out" / "unfinished").rglob("*.tar"))


def test_a_finished_study_is_refused_and_resumed_without_a_trial(swept, monkeypatch, capsys):
    with pytest.raises(SystemExit, match="--resume goes on"):
        sweep.main(args(swept / "study.toml", swept / "out"))
    monkeypatch.setattr(train, "train", lambda *_, **__: pytest.fail("trained again"))
    before = (swept / "out" / "trials.csv").read_bytes()
    sweep.main(args(swept / "study.toml", swept / "out", resume=True))
    assert (swept / "out" / "trials.csv").read_bytes() == before
    assert "2 of 2" in capsys.readouterr().out


def test_other_settings_do_not_replace_a_trial(swept, tmp_path):
    path = study(tmp_path, SEEDS.replace("steps = 512", "steps = 256"))
    begun = (swept / "out" / "study.json").read_bytes()
    with pytest.raises(SystemExit, match="/3 holds a trial with other settings") as end:
        sweep.main(args(path, swept / "out", resume=True))
    assert end.value.code == 2
    assert (swept / "out" / "study.json").read_bytes() == begun


def test_a_url_of_fsspec_holds_the_same_study(tmp_path, undisturbed):
    sweep.main(args(study(tmp_path, SEEDS.replace("[3, 4]", "[4]")), "memory://sweep/a"))
    store = Store("memory://sweep/a")
    assert weights(store) == {name: digest for name, digest in undisturbed.items() if name.endswith("/4")}
    assert store.read("summary.csv") is not None


class Killed(BaseException):
    """Ends a trial anywhere, like a kill."""


def test_a_trial_continues_from_its_last_checkpoint_with_the_same_weights(tmp_path, monkeypatch, undisturbed):
    path, out, chunks = study(tmp_path, SEEDS.replace("[3, 4]", "[3]")), tmp_path / "out", []
    learn = train.learn

    def counted(settings, agent, helicopters, number, total):
        chunks.append(number)
        if chunks == [0]:
            raise Killed
        learn(settings, agent, helicopters, number, total)

    original_save = sweep.Checkpoints.save

    def killed_after_the_first(self, number):
        original_save(self, number)
        raise Killed

    with monkeypatch.context() as patch:
        patch.setattr(sweep.Checkpoints, "save", killed_after_the_first)
        with pytest.raises(Killed):
            sweep.main(args(path, out, checkpoint_seconds=0.0))
    assert len(list((out / "unfinished").rglob("000001.tar"))) == 1
    chunks.append(-1)
    monkeypatch.setattr(train, "learn", counted)
    sweep.main(args(path, out, checkpoint_seconds=0.0, resume=True))
    assert chunks == [-1, 1]
    assert weights(Store(str(out))) == {name: d for name, d in undisturbed.items() if name.endswith("/3")}
    assert not list((out / "unfinished").rglob("*.tar"))


def test_a_trial_that_fails_is_named_and_tried_again(tmp_path, monkeypatch):
    path, out, original = study(tmp_path), tmp_path / "out", train.train

    def diverge(settings, console, after_chunk):
        if settings.seed == 3:
            raise ValueError("the agent has diverged")
        return original(settings, console, after_chunk=after_chunk)

    with monkeypatch.context() as patch:
        patch.setattr(train, "train", diverge)
        words = r"1 of 2 trials failed, the first one in .*/3: the agent has diverged"
        with pytest.raises(SystemExit, match=words) as end:
            sweep.main(args(path, out))
    assert end.value.code == 1
    assert len(weights(Store(str(out)))) == 1
    sweep.main(args(path, out, resume=True))
    assert len(weights(Store(str(out)))) == 2


def test_a_search_trains_its_candidates_with_every_seed_and_says_the_best(tmp_path, capsys):
    pytest.importorskip("optuna")
    path, out = study(tmp_path, SEARCH), tmp_path / "out"
    sweep.main(args(path, out))
    records = sweep.read_records(Store(str(out))).values()
    means = {}
    for record in records:
        means.setdefault(record["values"]["learning_rate"], []).append(record["rms_travel_deg"])
    assert [len(values) for values in means.values()] == [2, 2, 2]
    rate, value = min(means.items(), key=lambda item: sum(item[1]))
    assert f"best: {{'learning_rate': {rate}}}, mean rms_travel_deg {sum(value) / 2:.4g}" in capsys.readouterr().out
    # a lost trial is trained again, and the search proposes what it has proposed before
    before = weights(Store(str(out)))
    next((out / "trials").iterdir()).unlink()
    sweep.main(args(path, out, resume=True))
    assert weights(Store(str(out))) == before


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"workers": 0}, "workers = 0"),
        ({"engine": "ray", "address": "127.0.0.1:9"}, "address = '127.0.0.1:9'"),
        ({"address": "auto"}, "address = 'auto'"),
        ({"checkpoint_seconds": -1.0}, "checkpoint_seconds = -1"),
        ({"checkpoint_seconds": float("inf")}, "checkpoint_seconds = inf"),
        ({"out": "nonsense://x"}, "out = 'nonsense://x'"),
        ({"out": "memory://x", "workers": 2}, "out = 'memory://x': must be storage that all workers share"),
    ],
)
def test_an_impossible_sweep_is_refused_by_name_before_the_first_trial(tmp_path, monkeypatch, options, words):
    if options.get("engine") == "ray":
        pytest.importorskip("ray")
    monkeypatch.setattr(sweep, "run_trial", lambda order: pytest.fail("run"))
    with pytest.raises(SystemExit, match=words) as end:
        sweep.main(args(study(tmp_path), **{"out": tmp_path / "out", **options}))
    assert end.value.code == 2
    assert os.listdir(tmp_path) == ["study.toml"]


def test_a_full_disk_is_refused_before_the_first_trial(tmp_path, monkeypatch):
    def full(name, path):
        raise OSError(28, "No space left on device", str(path))

    monkeypatch.setattr(sweep, "run_trial", lambda order: pytest.fail("run"))
    monkeypatch.setattr(stores, "check_folder", full)
    with pytest.raises(SystemExit, match="No space left on device") as end:
        sweep.main(args(study(tmp_path), tmp_path / "out"))
    assert end.value.code == 1


def test_a_missing_study_is_status_1(tmp_path):
    with pytest.raises(SystemExit) as end:
        sweep.main(args(tmp_path / "none.toml", tmp_path / "out"))
    assert end.value.code == 1


def test_two_sweeps_do_not_run_the_same_study(tmp_path):
    store = Store(str(tmp_path))
    with sweep.locked_study(store), pytest.raises(ValueError, match="another heli-sweep"), sweep.locked_study(store):
        pass
    with sweep.locked_study(store):
        pass


@pytest.mark.slow
def test_killed_with_its_workers_at_any_moment_the_command_continues_and_loses_nothing(tmp_path, undisturbed):
    path = study(tmp_path)
    code = "from heli_gym import cli\nif __name__ == '__main__':\n    cli.run('heli-sweep')\n"
    (tmp_path / "start.py").write_text(code)
    order = [sys.executable, str(tmp_path / "start.py"), str(path), "--out", str(tmp_path / "out"), "--workers", "2"]
    order += ["--checkpoint-seconds", "0", "--resume"]
    for seconds in (6.0, 12.0):
        child = subprocess.Popen(order, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(seconds)
        child.send_signal(signal.SIGKILL)
        child.wait()
    child = subprocess.run(order, capture_output=True, text=True)
    assert child.returncode == 0, child.stderr
    assert weights(Store(str(tmp_path / "out"))) == undisturbed
