"""Invalid input of every command: one line, no traceback, before any flight or file."""

import importlib.util
import os
import re
import sys

import numpy as np
import pytest

from heli_gym import cli
from heli_gym.env import find_reference

OUT_IS_A_FILE = ["--out", "FILE"]
NAMES_NO_PLANT = ["--plant", "lunar"]

# by command: arguments, and words of the line that refuses them; FILE is an existing text file, FOLDER a folder
REFUSED = {
    "heli-plan": [
        (["--duration", "-1"], "duration"),
        (["--duration", "0"], "duration"),
        (["--duration", "nan"], "duration"),
        (["--duration", "inf"], "duration"),
        (["--duration", "soon"], "duration"),
        (["--duration", "0.5"], "no plan|duration"),
        (["--travel-deg", "nan"], "travel_deg"),
        (["--elevation-deg", "inf"], "elevation_deg"),
        (["--elevation-deg", "90"], "elevation_deg"),
        (["--start-elevation-deg", "-80"], "start_elevation_deg"),
        (["--pitch-limit-deg", "0"], "pitch_limit_deg"),
        (["--pitch-limit-deg", "91"], "pitch_limit_deg"),
        (["--u-min", "12"], "u_min"),
        (["--u-min", "nan"], "u_min"),
        (["--u-max", "inf"], "u_max"),
        (["--method", "magic"], "method"),
        (["--fastest", "--reserve", "2"], "reserve"),
        (["--reserve", "0.1"], "reserve"),
        (["--time-limit", "-1"], "time_limit"),
        (["--out", "plan.txt"], "out"),
        (["--out", "FILE/plan.npz"], "out"),
        (["--out"], "out"),
        (["--no-such-option"], "no-such-option"),
        (["positional"], "positional"),
    ],
    "heli-evaluate": [
        (NAMES_NO_PLANT, "plant = 'lunar'"),
        (["--policies"], "polic"),
        (["--policies", "zero", "zero"], "policies"),
        (["--policies", "foo"], "foo"),
        (["--policies", "none.json"], "none.json"),
        (["--policies", "FILE"], "name|polic"),
        (["--reference", "nowhere"], "nowhere"),
        (["--reference", "none.npz"], "none.npz"),
        (["--episodes", "0"], "episodes"),
        (["--episodes", "many"], "episodes"),
        (["--episodes", "1000000000"], "episodes"),
        (["--seed", "-1"], "seed"),
        (["--control-period", "0"], "control_period"),
        (["--control-period", "nan"], "control_period"),
        (["--control-period", "100"], "control_period"),
        (["--start-spread-deg", "-1"], "start_spread_deg"),
        (["--start-spread-deg", "90"], "start_spread_deg"),
        (OUT_IS_A_FILE, "out"),
        (["--report", "report.txt"], "report"),
        (["--report", "FOLDER"], "report"),
        (["--report", "FILE/report.html"], "report"),
    ],
    "heli-tune": [
        (["--plants", "x"], "plant"),
        (["--plants"], "plants"),
        (["--plants", "lab", "rigid", "--store"], "plants"),
        (["--plants", "x", "--store"], "plant"),
        (["--policy", "zero"], "policy"),
        (["--draws", "0"], "draws"),
        (["--draws", "1000000000"], "draws"),
        (["--candidates", "1000000000"], "candidates"),
        (["--candidates", "4", "--population", "2"], "population"),
        (["--candidates", "0"], "candidates"),
        (["--population", "1"], "population"),
        (["--seed", "-1"], "seed"),
        (["--objective", "fame"], "objective"),
        (["--reference", "nowhere"], "nowhere"),
        (["--study", "FOLDER"], "study = 'FOLDER': must be a file"),
    ],
    "heli-film": [
        (NAMES_NO_PLANT, "plant"),
        (["--frame-time", "1e300"], "frame_time"),
        (["--policies", "foo"], "foo"),
        (["--policies"], "polic"),
        (["--policies", "zero", "zero"], "policies"),
        (["--seed", "-1"], "seed"),
        (["--width", "-8"], "width"),
        (["--width", "0"], "width"),
        (["--frame-time", "0"], "frame_time"),
        (["--frame-time", "nan"], "frame_time"),
        (["--out", "film.mp4"], "out"),
        (["--out", "FILE/film.gif"], "out"),
        (["--reference", "nowhere"], "nowhere"),
    ],
    "heli-demo": [
        (["--out", "page.txt", "--no-open"], "out"),
        (["--out", "FILE/page.html", "--no-open"], "out"),
        (["--rig", "lunar", "--no-open"], "lunar"),
        (["--rig", "nowhere.toml", "--no-open"], "nowhere.toml"),
        (["--solve"], "solve"),
    ],
    "heli-leaderboard": [
        (["--plants", "lunar"], "plant = 'lunar'"),
        (["--plants"], "plants"),
        (["--policies", "foo"], "foo"),
        (["--policy", "foo"], "foo"),
        (["--policies", "none.zip"], "none.zip"),
        (["--policies", "FILE:make"], "FILE"),
        (["--policies", "no_such_module:make"], "no_such_module"),
        (["--references", "nowhere"], "nowhere"),
        (["--episodes", "1"], "episodes"),
        (["--workers", "0"], "workers"),
        (["--batch", "0"], "batch"),
        (["--seed", "-1"], "seed"),
        (OUT_IS_A_FILE, "out"),
    ],
    "heli-log": [
        ([], "log|LOG|required|Missing"),
        (["none.csv"], "none.csv"),
        (["FILE"], "FILE"),
        (["none.csv", "--out", "picture.txt"], "out"),
        (["none.csv", "--u-min", "5", "--u-max", "1"], "u_min"),
        (["none.csv", "--out", "FILE/picture.png"], "out"),
    ],
    "heli-export": [
        ([], "PLAN|required|Missing"),
        (["nowhere"], "nowhere"),
        (["FILE"], "FILE"),
        (["travel-360", "--policy", "foo"], "foo"),
        (["travel-360", "--format", "vhdl"], "format"),
        (["travel-360", "--control-period", "0"], "control_period"),
        (["travel-360", "--rig", "lunar"], "lunar"),
        (["travel-360", "--rig", "ntnu"], "ntnu"),
        (["travel-360", *OUT_IS_A_FILE], "out"),
        (["travel-360", "--format", "csv", "--policy", "residual"], "policy = 'residual'"),
    ],
    "heli-identify": [
        ([], "logs"),
        (["none.csv"], "none.csv"),
        (["FILE"], "FILE"),
        (["simulated", "--rig", "lunar"], "lunar"),
        (["simulated", "--fit-share", "2"], "fit_share"),
        (["simulated", "--sample-time", "0"], "sample_time"),
        (["simulated", "--duration", "5"], "duration"),
        (["simulated", "--mapping", "none.toml"], "none.toml"),
        (["simulated", "--out", "rig.txt"], "out"),
        (["simulated", "--out", "FILE/rig.toml"], "out"),
        (["simulated", "--figures", "FILE"], "figures"),
        (["--design", "none.csv"], "logs"),
        (["--design", "--duration", "0"], "duration"),
    ],
    "heli-make-references": [(OUT_IS_A_FILE, "out"), (["--out", "FILE/x"], "out"), (["x"], "x")],
    "heli-compare-planners": [
        (OUT_IS_A_FILE, "out"),
        (["--parts", "everything"], "parts"),
        (["--parts"], "parts"),
        (["--draws", "0"], "draws"),
        (["--maneuvers", "0"], "maneuvers"),
        (["--fastest", "-1"], "fastest"),
        (["--seed", "-1"], "seed"),
    ],
    "heli-play": [
        (NAMES_NO_PLANT, "plant"),
        (["--seed", "-1"], "seed"),
        (["--reference", "nowhere"], "nowhere"),
        (["--reference", "FILE"], "FILE|reference"),
        (["--seed", "x"], "seed"),
        (["--rig"], "rig"),
        (["positional"], "positional"),
    ],
    "heli-results": [
        (NAMES_NO_PLANT, "plant"),
        (["--episodes", "1000000000"], "episodes"),
        (["--policies", "foo"], "foo|against"),
        (["--episodes", "1"], "episodes"),
        (["--seed", "-1"], "seed"),
        (["--oracle", "-1"], "oracle"),
        (["--against", "zero"], "against"),
        (["--methods", "nowhere"], "nowhere"),
        (["--reference", "nowhere"], "nowhere"),
        (OUT_IS_A_FILE, "out"),
    ],
    "heli-sweep": [
        ([], "study|STUDY|Missing|required"),
        (["none.toml"], "none.toml"),
        (["FILE"], "must be TOML"),
        (["FILE", "--engine", "cloud"], "engine"),
    ],
    "heli-train": [
        (NAMES_NO_PLANT, "plant"),
        (["--steps", "0"], "steps"),
        (["--envs", "0"], "envs"),
        (["--seed", "-1"], "seed"),
        (["--base", "foo"], "base"),
        (["--algo", "a2c"], "algo"),
        (["--chunk", "100", "--rollout", "64"], "chunk"),
        (["--reference", "nowhere"], "nowhere"),
        (OUT_IS_A_FILE, "out"),
    ],
    "heli-export-onnx": [
        (["--policy", "none.json"], "none"),
        (["--policy", "FILE"], "FILE"),
        (["--out", "FILE/x.onnx"], "out"),
        (["--out", "FOLDER"], "out"),
    ],
}
CASES = [(program, arguments, words) for program, cases in REFUSED.items() for arguments, words in cases]
NEEDS = {
    "heli-results": "torch",
    "heli-train": "stable_baselines3",
    "heli-sweep": "stable_baselines3",
    "heli-export-onnx": "onnx",
    "heli-play": "pygame",
}


def test_the_cases_are_of_every_command():
    assert REFUSED.keys() == cli.COMMANDS.keys()


@pytest.fixture
def place(tmp_path, monkeypatch):
    """An empty folder with a file and a folder in it, that the commands run in."""
    (tmp_path / "FILE").write_text("precious")
    (tmp_path / "FOLDER").mkdir()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    return tmp_path


def run(monkeypatch, program, arguments):
    """The status of a command, run in this process."""
    if not importlib.util.find_spec(NEEDS.get(program, "numpy")):
        pytest.skip(f"{NEEDS[program]} is not installed")
    monkeypatch.setattr(sys, "argv", [program, *map(str, arguments)])
    with pytest.raises(SystemExit) as end:
        cli.run(program)
    return end.value.code


@pytest.mark.parametrize(
    ("program", "arguments", "words"), CASES, ids=[" ".join((case[0], *case[1])) for case in CASES]
)
def test_invalid_input_is_refused_in_one_line_and_leaves_nothing(place, monkeypatch, capsys, program, arguments, words):
    status = run(monkeypatch, program, arguments)
    said = capsys.readouterr().err
    status_of_the_system = said.endswith(("No such file or directory\n", "Not a directory\n", "Is a directory\n"))
    assert status == (1 if status_of_the_system else 2), said
    assert said.startswith(f"{program}: ")
    assert said.count("\n") == 1, said
    assert re.search(words, said.removeprefix(f"{program}: ")), said
    assert sorted(os.listdir(place)) == ["FILE", "FOLDER"]
    assert (place / "FILE").read_text() == "precious"


WRITERS = {
    "heli-plan": (["--out", "{}/plan.npz"]),
    "heli-evaluate": (["--policies", "zero", "--episodes", "1", "--out", "{}"]),
    "heli-film": (["--policies", "zero", "--out", "{}/film.gif"]),
    "heli-demo": (["--no-open", "--out", "{}/page.html"]),
    "heli-make-references": (["--out", "{}"]),
    "heli-compare-planners": (["--out", "{}"]),
    "heli-results": (["--out", "{}"]),
    "heli-train": (["--out", "{}"]),
    "heli-leaderboard": (["--out", "{}"]),
    "heli-export": (["travel-360", "--out", "{}"]),
    "heli-export-onnx": (["--out", "{}/x.onnx"]),
    "heli-identify": (["simulated", "--out", "{}/rig.toml"]),
    "heli-log": (["simulated", "--out", "{}/a.png"]),
    "heli-tune": (["--study", "{}/study.json"]),
}


@pytest.mark.parametrize("program", WRITERS)
def test_a_folder_that_the_system_denies_is_said_at_once_with_status_1(place, monkeypatch, capsys, program):
    """/proc takes no files, not even root's."""
    arguments = [argument.format("/proc/self/results") for argument in WRITERS[program]]
    status = run(monkeypatch, program, arguments)
    said = capsys.readouterr()
    assert (status, said.out) == (1, "")
    assert said.err.startswith(f"{program}: /proc/self/results")
    assert said.err.count("\n") == 1
    assert sorted(os.listdir(place)) == ["FILE", "FOLDER"]


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="the system has no full device")
def test_a_full_disk_is_said_by_the_name_of_the_file(place, monkeypatch, capsys):
    assert run(monkeypatch, "heli-export-onnx", ["--out", "/dev/full"]) == 1
    assert capsys.readouterr().err == "heli-export-onnx: /dev/full: No space left on device\n"


PLAN = ["--travel-deg", "0", "--elevation-deg", "-5", "--duration", "5"]
REPLACED = {
    "heli-plan": ([*PLAN, "--figure", "--out", "a.npz"], ["a.npz", "a.png"]),
    "heli-demo": (["--no-open", "--out", "page"], ["page/index.html"]),
    "heli-log": (["simulated", "--rig", "paper", "--out", "a.png"], ["a.png", "a-replay.png"]),
    "heli-identify": (["--design", "--rig", "ntnu", "--duration", "10", "--out", "a.csv"], ["a.csv", "a.npz"]),
    "heli-make-references": (["--out", "."], ["climb-15.npz", "take-off.npz"]),
    "heli-compare-planners": (["--parts", "trade-off", "--out", "."], ["trade-off.csv", "planning.png"]),
    "heli-tune": (["--draws", "1", "--candidates", "5", "--population", "5", "--study", "a.json"], ["a.json"]),
}


@pytest.mark.parametrize("program", REPLACED)
def test_every_earlier_result_that_a_command_replaces_is_listed(place, monkeypatch, capsys, program):
    commands = "heli_gym.baselines.commands"
    made = find_reference("climb-7.5")
    monkeypatch.setattr(f"{commands}.make_references.solve_reference", lambda name: made)
    monkeypatch.setattr(f"{commands}.compare_planners.PARTS", {"trade-off": lambda *_: None})
    monkeypatch.setattr(f"{commands}.tune.returns", lambda *_: np.zeros(1))
    arguments, names = REPLACED[program]
    monkeypatch.setattr(sys, "argv", [program, *arguments])
    for name in names:
        (place / name).parent.mkdir(exist_ok=True)
        (place / name).touch()
    cli.run(program)
    [line] = [line for line in capsys.readouterr().err.splitlines() if "replaces" in line]
    assert line == f"{program}: replaces {', '.join(names)} of an earlier run"


def test_a_reference_that_is_no_trajectory_is_named(place, monkeypatch, capsys):
    np.savez(place / "other.npz", a=np.zeros(3))
    (place / "cut.npz").write_bytes((place / "other.npz").read_bytes()[:100])
    for name in ("other.npz", "cut.npz"):
        assert run(monkeypatch, "heli-evaluate", ["--policies", "zero", "--reference", name]) == 2
        assert name in capsys.readouterr().err
