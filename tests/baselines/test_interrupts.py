"""Ctrl-C in the middle of a command: status 130, one line, and what was done is kept."""

import importlib
import importlib.util
import json
import sys

import pytest

from heli_gym import cli
from heli_gym.baselines.commands import evaluate, tune

NEEDED = {"heli-results": "torch", "heli-compare-planners": "casadi"}


def run(monkeypatch, capsys, folder, program, arguments):
    """Status of a command run in a folder, its output, and its only line on standard error."""
    monkeypatch.chdir(folder)
    monkeypatch.setattr(sys, "argv", [program, *arguments])
    with pytest.raises(SystemExit) as end:
        cli.run(program)
    said = capsys.readouterr()
    lines = [line for line in said.err.splitlines() if "compiling" not in line]
    assert len(lines) == 1, said.err
    return end.value.code, said.out, lines[0]


class InterruptedAt:
    """Function that calls another one, and is interrupted at a certain call."""

    def __init__(self, function, call):
        self.function, self.left = function, call

    def __call__(self, *arguments, **options):
        self.left -= 1
        if self.left == 0:
            raise KeyboardInterrupt
        return self.function(*arguments, **options)


def test_evaluate_writes_the_flights_until_the_interrupt(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(evaluate, "fly_many", InterruptedAt(evaluate.fly_many, 2))
    arguments = [
        "--policies",
        "zero",
        "middle-voltage",
        "--episodes",
        "2",
        "--plant",
        "lab",
        "--reference",
        "climb-7.5",
    ]
    status, _, line = run(monkeypatch, capsys, tmp_path, "heli-evaluate", [*arguments, "--no-figures"])
    results = json.loads((tmp_path / "out" / "results.json").read_text())
    assert status == 130
    assert line == "heli-evaluate: interrupted; the 2 flights so far are in out/results.json"
    assert results["state"] == "interrupted"
    assert [(flight["policy"], flight["seed"] % 2) for flight in results["flights"]] == [("zero", 0), ("zero", 1)]


def test_evaluate_interrupted_before_the_first_flight_writes_nothing(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(evaluate, "fly_many", InterruptedAt(evaluate.fly_many, 1))
    arguments = ["--policies", "zero", "--episodes", "2", "--plant", "lab", "--no-figures"]
    status, _, line = run(monkeypatch, capsys, tmp_path, "heli-evaluate", arguments)
    assert (status, line) == (130, "heli-evaluate: interrupted")
    assert not (tmp_path / "out").exists()


def test_tune_prints_the_best_weights_until_the_interrupt_and_stores_none(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(tune, "returns", InterruptedAt(tune.returns, 8))
    monkeypatch.setattr("heli_gym.baselines.control.weights.stored.TUNED", tmp_path / "tuned")
    arguments = ["--policy", "lqi", "--plants", "lab", "--draws", "1", "--candidates", "30", "--population", "5"]
    status, out, line = run(
        monkeypatch, capsys, tmp_path, "heli-tune", [*arguments, "--store", "--reference", "climb-7.5"]
    )
    assert (status, line) == (130, "heli-tune: interrupted; the best weights so far are printed, none stored")
    assert "travel = " in out and "elevation_integral = " in out
    assert not (tmp_path / "tuned").exists() or not any((tmp_path / "tuned").iterdir())


@pytest.mark.parametrize(
    ("program", "interrupted", "arguments"),
    [
        ("heli-plan", "plan", ["--out", "plan.npz"]),
        ("heli-make-references", "solve_reference", ["--out", "references"]),
        ("heli-export", "make_policy", ["travel-360"]),
        ("heli-film", "make_policy", ["--policies", "zero"]),
        ("heli-leaderboard", "flyable", ["--plants", "lab", "--policies", "zero"]),
        ("heli-compare-planners", "find_rig", []),
        ("heli-results", "reference_for", []),
    ],
)
def test_other_commands_end_with_one_line(monkeypatch, capsys, tmp_path, program, interrupted, arguments):
    if not importlib.util.find_spec(NEEDED.get(program, "numpy")):
        pytest.skip(f"{NEEDED[program]} is not installed")
    module = importlib.import_module(cli.COMMANDS[program])
    monkeypatch.setattr(module, interrupted, InterruptedAt(getattr(module, interrupted), 1))
    status, _, line = run(monkeypatch, capsys, tmp_path, program, arguments)
    assert (status, line) == (130, f"{program}: interrupted")
