"""Bad invocations of every command: status 1 or 2, one line, no traceback, and nothing changed in the folder."""

import collections
import contextlib
import dataclasses
import hashlib
import importlib
import io
import os
import random
import re
import resource
import signal
import sys
import tempfile
import typing
from pathlib import Path
from types import UnionType
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

from heli_gym import cli

EACH, SHARE = 100, 1.0
CPU_SECONDS = 3  # after which an invocation counts as accepted
NUMBERS = ("x", "", "nan", "inf", "-inf", "-1", "0", "1e300", "-1e300", "1e-300", "9" * 400, "1,5", "0x10", "٣x", "--1")
WORDS = (
    "",
    "x",
    "nowhere",
    "FILE",
    "FOLDER",
    "none.json",
    "none.npz",
    "../..",
    "a\nb",
    "ä" * 300,
    "@",
    "lqi@",
    "+safe",
    "'",
)
PATHS = (
    "FILE/x",
    "FILE/x.npz",
    "FILE/x.html",
    "FILE/x.toml",
    "FILE/x.csv",
    "FILE/x.png",
    "FOLDER",
    "/proc/self/x",
    "/proc/self/x.npz",
    "/proc/self/x.html",
    "/proc/self/x.toml",
    "/proc/self/x.json",
    "/proc/self/x.png",
    "/proc/self/x.gif",
    "/proc/self/x.onnx",
    "/dev/full",
    "/dev/full/x",
    "",
    "x" * 300,
    "x" * 300 + ".npz",
    "empty.npz",
    "empty.json",
    "empty.toml",
    "empty.csv",
    "binary.npz",
    "binary.json",
    "binary.toml",
    "binary.csv",
    "binary.mat",
    "binary.zip",
    "list.json",
    "nested.json",
    "nested.toml",
    "nan.json",
    "huge.npz",
    "loop",
    "FOLDER.npz",
    "FOLDER.json",
    "FOLDER.toml",
    "surrogate\udcff.npz",
)
POSITIONAL = {
    "heli-log": ["log.csv"],
    "heli-sweep": ["none.toml"],
    "heli-export": ["travel-360"],
    "heli-identify": ["log.csv"],
}
EXTRA = (["--no-such-option"], ["--seed=1", "--seed"], ["x", "y", "z", "--"], ["--=1"], ["-"], ["--out"], ["\u202e"])


def options_of(program: str) -> dict[str, Any]:
    """Options and their types, from the command's dataclass `Args`."""
    module = importlib.import_module(cli.COMMANDS[program])
    if not hasattr(module, "Args"):
        return {"plant": str, "reference": str, "rig": str, "seed": int}
    hints = get_type_hints(module.Args, include_extras=True)
    return {field.name: hints[field.name] for field in dataclasses.fields(module.Args)}


def kinds_of(hint: Any) -> list[Any]:
    """Plain types in a type hint."""
    if get_origin(hint) is typing.Annotated:
        return kinds_of(get_args(hint)[0])
    if get_origin(hint) in (UnionType, Union, tuple):
        return [kind for part in get_args(hint) if part is not Ellipsis for kind in kinds_of(part)]
    return [hint]


def invocations(program: str, count: int, rng: random.Random) -> list[list[str]]:
    """Arguments of bad invocations: each option in turn with odd values, then odd arguments."""
    cases: list[list[str]] = []
    options = options_of(program)
    for name, hint in options.items():
        flag = "--" + name.replace("_", "-")
        kinds = kinds_of(hint)
        is_list = get_origin(hint) is tuple or (
            get_origin(hint) is typing.Annotated and get_origin(get_args(hint)[0]) is tuple
        )
        is_positional = "Positional" in repr(hint) or name in ("plan", "log", "logs", "study")
        values: tuple[str, ...] = ("x",)
        if Path in kinds:
            values = PATHS
        elif int in kinds or float in kinds:
            values = NUMBERS
        elif str in kinds:
            values = WORDS + PATHS[-20:]
        elif any(get_origin(kind) is Literal for kind in kinds):
            values = ("x", "", "lqi", "-1", "PNG")
        base = [] if is_positional else POSITIONAL.get(program, [])
        cases += [[*base, *([] if is_positional else [flag]), value] for value in values]
        cases.append([*base, flag])
        if is_list:
            cases += [[*base, flag, "zero", "zero"], [*base, flag, "x", "y"]]
    cases += [list(extra) for extra in EXTRA]
    rng.shuffle(cases)
    while len(cases) < 2 * count:  # two odd options at once
        cases.append(rng.choice(cases[: len(cases)]) + rng.choice(cases)[-2:])
    return cases


def furnish(folder: Path) -> None:
    """Files of earlier results, and damaged ones."""
    (folder / "FILE").write_text("precious")
    for name in ("FOLDER", "FOLDER.npz", "FOLDER.json", "FOLDER.toml"):
        (folder / name).mkdir()
    for suffix in ("npz", "json", "toml", "csv"):
        (folder / f"empty.{suffix}").write_bytes(b"")
    noise = random.Random(1).randbytes(3000)
    for suffix in ("npz", "json", "toml", "csv", "mat", "zip"):
        (folder / f"binary.{suffix}").write_bytes(noise)
    (folder / "list.json").write_text("[]")
    (folder / "nan.json").write_text('{"lqi": NaN, "sha256": NaN}')
    (folder / "nested.json").write_text("[" * 100_000)
    (folder / "nested.toml").write_text("a = " + "[" * 100_000)
    (folder / "huge.npz").write_bytes(b"PK\x03\x04" + noise)
    (folder / "loop").symlink_to("loop")
    t = "\n".join(f"{0.02 * k:.2f},0,0,0,6,6" for k in range(100))
    (folder / "log.csv").write_text(f"t,travel,elevation,pitch,u_front,u_back\n{t}\n")
    (folder / "out").mkdir()
    (folder / "out" / "results.json").write_text('{"precious": 1}')


def contents(folder: Path) -> dict[str, str]:
    """Digests of all files."""
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else "folder"
        for path in folder.rglob("*")
        if path.name != "loop"
    }


def run(program: str, arguments: list[str], folder: Path, closed: bool = False) -> tuple[int | None, str, str]:
    """Status, standard output and error of a command in a forked process; None for one that went on."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        pid = os.fork()
        if pid == 0:
            os.setpgid(0, 0)
            resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS + 1))
            os.chdir(folder)
            os.dup2(out.fileno(), 1)
            os.dup2(err.fileno(), 2)
            os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
            sys.stdout = None if closed else io.TextIOWrapper(io.FileIO(1, "w", closefd=False), "utf-8")  # type: ignore
            sys.stderr = io.TextIOWrapper(io.FileIO(2, "w", closefd=False), "utf-8")
            sys.argv = [program, *arguments]
            status = 99
            try:
                cli.run(program)
                status = 0
            except SystemExit as end:
                status = end.code if isinstance(end.code, int) else 0 if end.code is None else 1
            except BaseException:
                import traceback

                traceback.print_exc()
            with contextlib.suppress(Exception):
                sys.stderr.flush()
                sys.stdout.flush()
            os._exit(status)
        status: int | None = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
        if status in (-signal.SIGXCPU, -signal.SIGKILL):
            status = None
        with contextlib.suppress(OSError):
            os.killpg(pid, signal.SIGKILL)  # its workers
        out.seek(0), err.seek(0)
        return status, out.read().decode("utf-8", "replace"), err.read().decode("utf-8", "replace")


def is_accepted(status: int | None, said: str) -> bool:
    """Whether an invocation was not bad after all; the limit of CPU time may also end the worker of a sweep."""
    return status in (0, None) or "its process was lost" in said


def names_cause(arguments: list[str], said: str) -> bool:
    """Whether a line names an option, or a value, of the arguments, as words of their own."""
    words = [argument.lstrip("-").partition("=")[0] for argument in arguments]
    words += [part for argument in arguments if argument.startswith("/") for part in Path(argument).parts[2:]]
    plain = [word for word in words if word and word.isascii() and word.isprintable()]
    # the 0 of "at least 0" is no name
    plain = [word for word in plain if not re.fullmatch(r"[\d.,]+", word)] or plain
    names = [name for word in plain for name in (word, word.replace("-", "_"))]
    beginnings = [word[:8] for word in plain if len(word) > 20]  # long values are shortened
    return (
        not plain
        or "Missing" in said
        or "Unrecognized" in said
        or any(re.search(rf"(?<!\w){re.escape(name)}(?!\w)", said) for name in names)
        or any(beginning in said for beginning in beginnings)
    )


def judge(program: str, arguments: list[str], status: int | None, said: str, before: dict, after: dict) -> str:
    """Fault of a refusal, or an empty string."""
    if "Traceback" in said:
        return "traceback: " + said.strip().splitlines()[-1]
    if status not in (1, 2):
        return f"status {status}"
    said = "".join(line for line in said.splitlines(keepends=True) if "of an earlier run" not in line)
    if not said.startswith(f"{program}: ") or said.count("\n") != 1:
        return f"not one line: {said[:200]!r}"
    if not names_cause(arguments, said.removeprefix(f"{program}: ")):
        return f"names neither option nor value: {said[:200]!r}"
    if before != after:
        changed = sorted(set(before.items()) ^ set(after.items()))
        return f"changed {[name for name, _ in changed][:4]}"
    return ""


def main(quick: bool, seed: int, only: str) -> int:
    """Run the part."""
    os.environ["SDL_VIDEODRIVER"] = "dummy"
    os.environ.setdefault("MPLBACKEND", "agg")
    bad = 0
    programs = [only] if only else list(cli.COMMANDS)
    for program in programs:
        rng = random.Random(f"{seed}{program}")
        try:
            importlib.import_module(cli.COMMANDS[program])
        except ImportError as error:
            print(f"{program}: left out: {error}")
            continue
        refused, accepted, statuses = 0, [], collections.Counter()
        wanted = 4 if quick else int(SHARE * EACH)
        for arguments in invocations(program, EACH, rng):
            if refused == wanted or len(accepted) > EACH // 2:
                break
            with tempfile.TemporaryDirectory() as place:
                folder = Path(place)
                furnish(folder)
                before = contents(folder)
                status, _, said = run(program, arguments, folder, closed=rng.random() < 0.1)
                if is_accepted(status, said) and "Traceback" not in said:
                    accepted.append(" ".join(arguments))
                    continue
                refused += 1
                statuses[status] += 1
                fault = judge(program, arguments, status, said, before, contents(folder))
                if fault:
                    bad += 1
                    print(f"    {program} {arguments}: {fault}"[:300])
        counts = ", ".join(f"{n} with status {status}" for status, n in sorted(statuses.items()))
        print(f"{program}: {refused} refused: {counts}; {len(accepted)} accepted")
        if accepted and not quick:
            print(f"    accepted: {'; '.join(text[:60].replace(chr(10), ' ') for text in accepted)}"[:1500])
        sys.stdout.flush()
    print(f"{bad} faults")
    return int(bad > 0)
