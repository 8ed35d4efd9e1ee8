"""Ends of commands: one line and an exit status for every error."""

import io
import os
import subprocess
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path

import pytest

from heli_gym import cli
from heli_gym.cli import COMMANDS, command

ROOT = Path(__file__).parents[2]


def ended(error):
    """Status and line of a command in which an exception was raised."""
    with pytest.raises(SystemExit) as end, command("heli-x"):
        raise error
    return end.value.code, str(end.value)


@pytest.mark.parametrize(
    ("error", "status", "line"),
    [
        (ValueError("seed = -1: must be\n  at least 0"), 2, "heli-x: seed = -1: must be at least 0"),
        (OverflowError("too large"), 2, "heli-x: too large"),
        (PermissionError(13, "Permission denied", "/out"), 1, "heli-x: /out: Permission denied"),
        (OSError(28, "No space left on device"), 1, "heli-x: No space left on device"),
        (RuntimeError("the solver gave up"), 1, "heli-x: the solver gave up"),
        (MemoryError(), 1, "heli-x: MemoryError"),
        (KeyboardInterrupt(), 130, "heli-x: interrupted"),
        (KeyboardInterrupt("3 flights are in out"), 130, "heli-x: interrupted; 3 flights are in out"),
        (
            ImportError("No module named 'tyro'", name="tyro"),
            2,
            'tyro is not installed: `pip install "heli-gym[eval]"`',
        ),
        (ImportError("No module named 'pygame'", name="pygame.font"), 2, "heli-gym[render]"),
        (ImportError("No module named 'torch'", name="torch"), 2, "heli-gym[train]"),
        (ImportError("No module named 'foo'", name="foo"), 2, "heli-x: No module named 'foo'"),
    ],
)
def test_an_error_is_one_line_and_a_status(capsys, error, status, line):
    code, said = ended(error)
    assert code == status
    assert line in said
    assert capsys.readouterr().err == said + "\n"


def test_an_error_of_the_program_itself_shows_where_it_is():
    with pytest.raises(KeyError), command("heli-x"):
        raise KeyError("a fault")


def test_characters_that_a_stream_cannot_encode_are_replaced(monkeypatch):
    stream = io.TextIOWrapper(io.BytesIO(), encoding="ascii", errors="strict")
    monkeypatch.setattr(sys, "stdout", stream)
    with command("heli-x"):
        print("50° ± 2 µs")
    assert stream.buffer.getvalue() == b"50? ? 2 ?s\n"


def test_a_closed_standard_output_is_no_obstacle(monkeypatch):
    monkeypatch.setattr(sys, "stdout", None)
    with command("heli-x"):
        assert sys.stdout.isatty() is False
        print("somewhere")
    sys.stdout.close()


@dataclass
class Settings:
    """Settings of a test."""

    number: int = 0  # of things


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (
            ["--number", "x"],
            "heli-x: Error parsing --number: invalid literal for int() with base 10: 'x'; see heli-x --help",
        ),
        (["--nombre", "1"], "heli-x: Unrecognized options: --nombre"),
        (["--number"], "heli-x: "),
    ],
)
def test_arguments_that_are_refused_are_one_line(monkeypatch, capsys, arguments, line):
    monkeypatch.setattr(sys, "argv", ["heli-x", *arguments])
    with pytest.raises(SystemExit) as end:
        cli.parse(Settings, "heli-x")
    assert end.value.code == 2
    said = capsys.readouterr().err
    assert said.startswith(line) and arguments[0] in said
    assert said.count("\n") == 1


def test_every_script_of_the_package_is_a_command_of_the_table():
    scripts = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["scripts"]
    assert set(scripts) == set(COMMANDS)
    for name, target in scripts.items():
        assert target == f"heli_gym_commands:{name[5:].replace('-', '_')}"


INTERRUPTED = """
import sys
module = sys.argv.pop()
class Interruption:
    def find_spec(name, *_):
        if name == module:
            raise KeyboardInterrupt
sys.meta_path.insert(0, Interruption)
import heli_gym_commands
heli_gym_commands.plan()
"""


@pytest.mark.parametrize("module", ["heli_gym", "numpy", "heli_gym.baselines.commands.plan_maneuver", "tyro"])
def test_ctrl_c_during_the_imports_of_a_command_is_one_line(module):
    child = subprocess.run([sys.executable, "-c", INTERRUPTED, module], capture_output=True, text=True, cwd=ROOT)
    assert (child.returncode, child.stderr) == (130, "heli-plan: interrupted\n")


@pytest.mark.parametrize("program", COMMANDS)
def test_every_command_prints_its_version_without_loading_anything(monkeypatch, capsys, program):
    monkeypatch.setattr(sys, "argv", [program, "--version"])
    monkeypatch.setattr(cli.importlib, "import_module", lambda name: pytest.fail(name))
    with pytest.raises(SystemExit) as end:
        cli.run(program)
    assert end.value.code == 0
    assert capsys.readouterr().out.startswith(f"{program} 0.")


def child(program, *arguments, shell_suffix="", block=(), **environment):
    """A command in a process of its own, started by a shell, with some packages missing."""
    code = (
        f"import sys; sys.argv[0] = {program!r};"
        f"sys.modules.update(dict.fromkeys({list(block)!r}));"
        f"from heli_gym import cli; cli.run({program!r})"
    )
    return subprocess.run(
        ["bash", "-c", f'"$@" {shell_suffix}', "bash", sys.executable, "-c", code, *map(str, arguments)],
        capture_output=True,
        text=True,
        env={**os.environ, **environment},
    )


def test_without_an_extra_a_command_names_it():
    done = child("heli-plan", block=("tyro",))
    assert done.returncode == 2
    assert done.stderr == 'heli-plan: tyro is not installed: `pip install "heli-gym[eval]"` brings it\n'


@pytest.mark.parametrize("suffix", ["", ">&-", ">/dev/full", "| true"])
def test_plan_is_saved_even_if_standard_output_fails(tmp_path, suffix):
    arguments = ("--method", "flat", "--duration", "30", "--no-figure", "--out", tmp_path / "plan.npz")
    done = child("heli-plan", *arguments, shell_suffix=suffix, PYTHONIOENCODING="ascii")
    assert (tmp_path / "plan.npz").is_file()
    assert "Traceback" not in done.stderr
    assert done.stderr.count("\n") <= 1
    if suffix == ">/dev/full":
        assert done.returncode == 1
        assert done.stderr == "heli-plan: No space left on device\n"
    else:
        assert done.returncode == 0
    assert os.listdir(tmp_path) == ["plan.npz"]
