"""Shared entry and exit of all commands: argument parsing, exit status, and one line instead of a traceback.

Exit status 0: success. 1: failure of the operating system or of a solver. 2: invalid input. 130: Ctrl-C.
"""

import contextlib
import importlib
import io
import os
import re
import sys
from collections.abc import Iterator
from importlib import metadata
from itertools import groupby
from pathlib import Path
from typing import NoReturn, TypeVar

Args = TypeVar("Args")

COMMANDS = {
    "heli-compare-planners": "heli_gym.baselines.commands.compare_planners",
    "heli-demo": "heli_gym.baselines.commands.demo",
    "heli-evaluate": "heli_gym.baselines.commands.evaluate",
    "heli-export": "heli_gym.baselines.commands.export",
    "heli-export-onnx": "heli_gym.train.export_onnx",
    "heli-film": "heli_gym.baselines.commands.film",
    "heli-identify": "heli_gym.baselines.commands.identify",
    "heli-leaderboard": "heli_gym.baselines.commands.leaderboard",
    "heli-log": "heli_gym.baselines.commands.log",
    "heli-make-references": "heli_gym.baselines.commands.make_references",
    "heli-plan": "heli_gym.baselines.commands.plan_maneuver",
    "heli-play": "heli_gym.play",
    "heli-results": "heli_gym.train.results",
    "heli-sweep": "heli_gym.train.sweep",
    "heli-train": "heli_gym.train.train",
    "heli-tune": "heli_gym.baselines.commands.tune",
}
IMPORTED_AS = {"pygame-ce": "pygame"}  # distributions with another module name


class CommandError(SystemExit):
    """End of a command with an exit status, raised after its line has been printed on standard error."""

    def __init__(self, line: str, status: int) -> None:
        super().__init__(line)
        self.code = status


def run(program: str) -> None:
    """Run a command; a missing extra ends it with one line."""
    with command(program):
        print_version(program, sys.argv[1:])
        importlib.import_module(COMMANDS[program]).main()


@contextlib.contextmanager
def command(program: str) -> Iterator[None]:
    """Context of a command: turn an exception in it into one line on standard error and an exit status.

    Raises `CommandError`, a SystemExit: status 2 for ValueError and missing packages, 1 for OSError, RuntimeError and
    MemoryError, 130 for KeyboardInterrupt, whose argument, if any, is printed as the reason.
    """
    prepare_output()
    try:
        yield
        flush_output()
    except BrokenPipeError:  # the reader of the output has closed it, as `head` does
        discard_output()
        raise CommandError(f"{program}: broken pipe", 1) from None
    except KeyboardInterrupt as error:
        end(program, "; ".join(("interrupted", *map(str, error.args))), 130)
    except ImportError as error:
        end(program, missing_package(error), 2)
    except OSError as error:
        if error.filename is None:
            discard_output()  # most likely it was standard output that failed
        end(program, describe(error), 1)
    except (ValueError, ArithmeticError) as error:
        end(program, str(error), 2)
    except (RuntimeError, MemoryError) as error:
        end(program, str(error) or type(error).__name__, 2 if is_input_error(error) else 1)
    except Exception as error:
        if not is_input_error(error):
            raise
        end(program, str(error), 2)


def is_input_error(error: Exception) -> bool:
    """Whether an exception other than ValueError means bad input: a maneuver, a missing library, a damaged file."""
    return type(error).__name__ in ("InfeasibleManeuver", "DependencyNotInstalled", "SafetensorError", "BadZipFile")


def end(program: str, reason: str, status: int) -> NoReturn:
    """Print the reason in one line on standard error, then raise CommandError with the status."""
    line = f"{program}: {' '.join(reason.split())}"
    try:
        flush_output()
    except OSError:
        discard_output()
    with contextlib.suppress(OSError, ValueError, AttributeError):
        print(line, file=sys.stderr, flush=True)
    raise CommandError(line, status) from None


def describe(error: OSError) -> str:
    """The file name and the operating system's message."""
    reason = error.strerror or str(error)
    return reason if error.filename is None else f"{os.fsdecode(error.filename)}: {reason}"


def missing_package(error: ImportError) -> str:
    """Message that names the missing package and the extra that installs it."""
    module = (error.name or "").partition(".")[0]
    for requirement in metadata.requires("heli-gym") or ():
        name, _, condition = requirement.partition(";")
        distribution = re.split(r"[^\w.-]", name.strip())[0].lower()
        extra = re.search(r"extra == ['\"](\w+)['\"]", condition)
        if extra and IMPORTED_AS.get(distribution, distribution.replace("-", "_")) == module:
            return f'{module} is not installed: `pip install "heli-gym[{extra[1]}]"` brings it'
    return str(error)


def parse(arguments: type[Args], program: str, description: str | None = None) -> Args:
    """Parse the command line with tyro; `--version` and invalid arguments end the command."""
    tyro = importlib.import_module("tyro")  # optional dependency
    print_version(program, sys.argv[1:])
    complaint = io.StringIO()
    try:
        with contextlib.redirect_stderr(complaint):
            return tyro.cli(arguments, prog=program, description=description)
    except SystemExit as error:
        if error.code != 2:
            raise
        lines = [line.strip("│╭╮╰╯─|+-— ") for line in complaint.getvalue().splitlines()]
        # tyro prints a box: title, optional rule, reason, and after another rule the allowed values
        parts = [" ".join(part) for rule, part in groupby(lines[1:], lambda line: not line) if not rule]
        end(program, f"{parts[0] if parts else 'bad arguments'}; see {program} --help", 2)


def print_version(program: str, arguments: list[str]) -> None:
    """Print the version and end the command if the only argument is `--version`."""
    if "--version" in arguments:
        print(f"{program} {metadata.version('heli-gym')}")
        flush_output()
        raise SystemExit(0)


def prepare_output() -> None:
    """Make standard output writable: discard it if it is closed; replace characters that it cannot encode."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115
        elif isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")


def flush_output() -> None:
    """Flush standard output, so that a full disk or a closed pipe is noticed while it can still be reported."""
    if sys.stdout is not None:
        sys.stdout.flush()


def discard_output() -> None:
    """Redirect standard output to the null device, so that Python's flush at exit does not fail again."""
    with contextlib.suppress(OSError, ValueError, AttributeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def announce_replaced(program: str, *paths: Path) -> None:
    """List on standard error the existing files that the command will replace; a device or a pipe is none."""
    earlier = [str(path) for path in paths if path.is_file() or path.is_dir()]
    if earlier:
        with contextlib.suppress(OSError, ValueError, AttributeError):
            print(f"{program}: replaces {', '.join(earlier)} of an earlier run", file=sys.stderr, flush=True)
