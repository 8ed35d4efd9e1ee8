"""`heli-sweep STUDY.toml`: many training runs of `heli-train` in parallel processes on this machine.

A study has settings of `heli-train` under `[settings]`, and lists of values under `[grid]`: every combination is a
trial.

    [settings]
    plant = "lab"
    steps = 100_000

    [grid]
    seed = [0, 1, 2]
    algo = ["ppo", "td3"]

Every trial has checkpoints: after a kill, the same command with --resume continues and gives the same weights. The
folder holds `trials.csv`, with one row per trial, and the runs for `heli-results --methods`.
"""

import csv
import io
import json
import subprocess
import sys
import tomllib
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, fields, replace
from itertools import product
from pathlib import Path
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

import tyro
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

from heli_gym.cli import command, parse
from heli_gym.plant import find_plant
from heli_gym.storage import atomic_write, check_folder
from heli_gym.train import train

MOST_TRIALS = 10_000
OURS = ("out", "resume", "progress")  # settings that the sweep sets itself


@dataclass
class Args:
    """Run all trials of a study."""

    study: Annotated[Path, tyro.conf.Positional]  # .toml file
    engine: Literal["local"] = "local"  # runs the trials in processes on this machine
    workers: int = 1  # number of parallel trials
    out: Path = Path("out/sweep")
    resume: bool = False  # continue the study in this folder


def read_study(path: Path) -> list[train.Args]:
    """Trials of a study file. Raises ValueError that names the error in it, OSError for an unreadable file."""
    try:
        study = tomllib.loads(path.read_text())
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ValueError(f"study = {str(path)!r}: must be TOML: {error}") from error
    settings, grid = study.pop("settings", {}), study.pop("grid", {})
    if study:
        raise ValueError(f"study: {', '.join(study)}: must be within [settings] or [grid]")
    if not (isinstance(settings, dict) and isinstance(grid, dict)):
        raise ValueError("study: settings and grid must be tables")
    known = {field.name for field in fields(train.Args)} - set(OURS)
    for name in (*settings, *grid):
        if name not in known:
            raise ValueError(f"study: {name!r} must be a setting of heli-train: {', '.join(sorted(known))}")
    both = set(settings) & set(grid)
    if both:
        raise ValueError(f"study: {', '.join(sorted(both))}: must be in [settings] or in [grid], not in both")
    for name, values in grid.items():
        if not isinstance(values, list) or not values:
            raise ValueError(f"study: grid.{name} = {values!r}: must be a list of values")
    trials = []
    combinations = list(product(*grid.values()))
    if len(combinations) > MOST_TRIALS:
        raise ValueError(f"study: {len(combinations)} trials: must be at most {MOST_TRIALS}")
    for combination in combinations:
        values = {**settings, **dict(zip(grid, combination))}
        plain = to_settings(values)
        try:
            trials.append(train.Args(**plain))
        except TypeError as error:
            raise ValueError(f"study: {error}") from error
    return trials


def check_trials(trials: Sequence[train.Args], args: Args) -> list[train.CompleteArgs]:
    """Trials with their folders, after the checks of `heli-train`. Raises ValueError for the first invalid one."""
    if args.workers < 1:
        raise ValueError(f"workers = {args.workers}: must be at least 1")
    check_folder("out", args.out)
    placed: list[train.CompleteArgs] = []
    folders: dict[Path, int] = {}
    for number, trial in enumerate(trials, 1):
        try:
            check_types(trial)
            own = train.with_defaults(replace(trial, out=args.out / "runs", resume=True, progress=False))
            find_plant(own.plant)
            train.check(own)
            train.references_of(own)
            folder = train.run_folder(own)
        except (ValueError, TypeError) as error:
            raise ValueError(f"study, trial {number}: {error}") from error
        placed.append(own)
        if folder in folders:
            raise ValueError(
                f"study: trials {folders[folder]} and {number} have the same plant, method and seed, and so the same "
                "folder; they must differ in one of these"
            )
        folders[folder] = number
        if folder.exists() and not args.resume:
            raise ValueError(f"out: {folder} holds a run already; --resume goes on with it")
    return placed


def to_settings(values: dict[str, Any]) -> dict[str, Any]:
    """Convert values of TOML or JSON to types of the settings: lists to tuples, names of paths to Path."""
    hints = get_type_hints(train.Args)
    paths = {name for name, hint in hints.items() if hint is Path or Path in get_args(hint)}
    return {
        name: tuple(value) if isinstance(value, list) else Path(value) if name in paths and value else value
        for name, value in values.items()
    }


def check_types(trial: train.Args) -> None:
    """Raise ValueError for a value of another type than its setting."""
    hints = get_type_hints(train.Args)
    for name, value in vars(trial).items():
        kinds = get_args(hints[name]) if get_origin(hints[name]) in (UnionType, Union) else (hints[name],)
        if not any(has_type(value, kind) for kind in kinds):
            raise ValueError(
                f"{name} = {value!r}: must be {' or '.join(getattr(k, '__name__', str(k)) for k in kinds)}"
            )


def has_type(value: Any, kind: Any) -> bool:
    """Whether a value has the type of a setting."""
    if get_origin(kind) is Literal:
        return value in get_args(kind)
    if get_origin(kind) is tuple:
        return isinstance(value, tuple) and all(has_type(part, get_args(kind)[0]) for part in value)
    if kind is float:
        return isinstance(value, float | int) and not isinstance(value, bool)
    return isinstance(value, kind) and (kind is bool or not isinstance(value, bool))


def run_trial(trial: train.Args) -> int:
    """Run a trial in its own process, and return the exit status."""
    order = json.dumps({field.name: getattr(trial, field.name) for field in fields(trial)}, default=str)
    return subprocess.run([sys.executable, "-m", "heli_gym.train.sweep", order], stdout=subprocess.DEVNULL).returncode


def row_of(trial: train.CompleteArgs) -> dict[str, Any]:
    """Row of a trial: main settings, and validation after its last chunk."""
    folder = train.run_folder(trial)
    path = folder / "history.json"
    history = json.loads(path.read_text()) if path.is_file() else []
    last = history[-1] if history else {}
    row = {"plant": trial.plant, "algo": trial.algo, "seed": trial.seed, "run": str(folder)}
    travel, elevation, *_ = last.get("rms_error_deg", (None, None))
    return row | {
        "steps": last.get("steps"),
        "rms_travel_deg": travel,
        "rms_elevation_deg": elevation,
        "episode_return": last.get("episode_return"),
        "success": last.get("success"),
    }


def write_rows(path: Path, trials: Sequence[train.CompleteArgs]) -> list[dict[str, Any]]:
    """Write trials.csv, atomically, and return its rows."""
    rows, text = [row_of(trial) for trial in trials], io.StringIO()
    writer = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    with atomic_write(path) as file:
        file.write(text.getvalue().encode())
    return rows


def run(args: Args) -> None:
    """Run the trials, and write and print one table."""
    trials = check_trials(read_study(args.study), args)
    console = Console()
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        TimeRemainingColumn(),
    )
    failed = 0
    try:
        with Progress(*columns, console=console) as progress, ThreadPoolExecutor(args.workers) as pool:
            bar = progress.add_task("trials", total=len(trials))
            futures = {pool.submit(run_trial, trial): trial for trial in trials}
            try:
                for future in as_completed(futures):
                    failed += future.result() != 0
                    progress.update(bar, advance=1)
            except KeyboardInterrupt:
                pool.shutdown(wait=False, cancel_futures=True)
                raise
    except KeyboardInterrupt:
        write_rows(args.out / "trials.csv", trials)
        raise KeyboardInterrupt(f"the trials so far are in {args.out}; --resume goes on") from None
    write_rows(args.out / "trials.csv", trials)
    console.print(f"trials: {args.out / 'trials.csv'}\nruns: {args.out / 'runs'}, for heli-results --methods")
    if failed:
        raise RuntimeError(f"{failed} of {len(trials)} trials failed; --resume tries them again")


def main(args: Args | None = None) -> None:
    """Run the command `heli-sweep`."""
    with command("heli-sweep"):
        run(args or parse(Args, "heli-sweep", __doc__))


def train_one(order: str) -> None:
    """Train one trial, given its settings as JSON."""
    train.train(train.Args(**to_settings(json.loads(order))), Console(quiet=True))


if __name__ == "__main__":
    with command("heli-sweep: trial"):
        train_one(sys.argv[1])
