"""`heli-sweep STUDY.toml`: many training runs of `heli-train`, in processes of this machine or on a Ray cluster.

A study has settings of `heli-train` under `[settings]`, and lists of values under `[grid]`, whose combinations are the
trials; with `[search]`, Optuna proposes values. `heli_gym.train.study` describes the format.

Each trial ends with the weights that `heli-train` gives for its settings, byte for byte. Trials store checkpoints:
after the loss of a process, of a machine, or of this command (--resume), they continue. The folder, or URL of fsspec,
holds

    study.json                the study
    trials/KEY.json           one record per finished trial, with the SHA-256 of its weights
    runs/PLANT/METHOD/SEED/   networks and histories, for `heli-results --methods runs/PLANT/*`
    unfinished/KEY/           the last checkpoint of each trial in progress
    trials.csv                one row per trial
    summary.csv               means over seeds, with intervals
"""

import json
import os
import platform
import sys
import tarfile
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import chdir, contextmanager, nullcontext, suppress
from dataclasses import dataclass, field
from datetime import timedelta
from hashlib import sha256
from itertools import islice
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import tyro
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

from heli_gym.baselines.evaluation.engine import Engine, EngineName, check_engine, open_engine
from heli_gym.baselines.evaluation.statistics import with_interval
from heli_gym.cli import command, parse
from heli_gym.storage import to_csv, try_lock
from heli_gym.train import train
from heli_gym.train.store import Store, scratch_folder
from heli_gym.train.study import (
    MOST_TRIALS,
    Proposals,
    Study,
    Trial,
    check_distinct,
    corners,
    read_study,
    to_settings,
    trials_of,
)
from heli_gym.validation import require

POLL = 2.0  # s between two looks at the checkpoints
PROBES = 8  # tasks that look for the storage from the workers of a cluster
MEASURED = ("rms_travel_deg", "rms_elevation_deg", "cost", "episode_return", "success")


def cores() -> int:
    """Number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@dataclass
class Args:
    """Run all trials of a study."""

    study: Annotated[Path, tyro.conf.Positional]  # .toml file
    engine: EngineName = "local"  # processes of this machine, or Ray
    address: str | None = None  # Ray cluster, HOST:PORT or auto; by default one is started on this machine
    workers: int = field(default_factory=cores)  # number of parallel trials on this machine
    out: str = "out/sweep"  # folder, or URL of fsspec such as s3://bucket/study
    resume: bool = False  # continue the study in this folder; trials may be added
    checkpoint_seconds: float = 30.0  # shortest time between two checkpoints of a trial


# One trial, in a worker


@dataclass(frozen=True)
class Order:
    """A trial for a worker, in plain values."""

    key: str
    settings: dict[str, Any]
    values: dict[str, Any]
    folder: str
    out: str
    cwd: str
    checkpoint_seconds: float


def order_of(trial: Trial, store: Store, checkpoint_seconds: float) -> Order:
    """Order to run a trial."""
    settings = train.settings_of(trial.args)
    return Order(trial.key, settings, trial.values, trial.folder, store.url, os.getcwd(), checkpoint_seconds)


def record_name(key: str) -> str:
    """Name of a trial's record."""
    return f"trials/{key}.json"


def run_trial(order: Order) -> dict[str, Any]:
    """Run or continue a trial, store its files and then its record, and return the record.

    A trial that fails has a record with "error", which is not stored. Raises OSError if the storage fails.
    """
    store = Store(order.out)
    record = store.read(record_name(order.key))
    if record is not None:  # by another attempt, whose worker was believed lost
        return json.loads(record)
    place = chdir(order.cwd) if os.path.isdir(order.cwd) else nullcontext()
    with place, scratch_folder() as scratch:
        args = train.with_defaults(train.Args(**to_settings(order.settings), out=scratch, resume=True, progress=False))
        checkpoints = Checkpoints(order, store, train.run_folder(args), scratch / "checkpoint.tar")
        checkpoints.restore()
        try:
            folder = train.train(args, Console(quiet=True), after_chunk=checkpoints.save)
        except (ValueError, ArithmeticError, RuntimeError) as error:
            return {"key": order.key, "run": order.folder, "values": order.values, "error": str(error)}
        for path in sorted(folder.rglob("*")):
            own = path.relative_to(folder)
            if path.is_file() and "checkpoints" not in own.parts:
                store.upload(path, f"{order.folder}/{own.as_posix()}")
        finished = record_of(order, args, folder)
        store.write(record_name(order.key), (json.dumps(finished, indent=1) + "\n").encode())
        checkpoints.remove()
    return finished


def record_of(order: Order, args: train.CompleteArgs, folder: Path) -> dict[str, Any]:
    """Record of a finished trial: settings, and the validation of its best network."""
    history = json.loads((folder / "history.json").read_text(encoding="utf-8"))
    best = max(history[1:], key=lambda row: train.score(args, row))
    travel, elevation, *_ = best["rms_error_deg"]
    return {
        "key": order.key,
        "run": order.folder,
        "values": order.values,
        "settings": order.settings,
        "steps": history[-1]["steps"],
        "seconds": history[-1]["seconds"],
        "score": train.score(args, best),
        "rms_travel_deg": travel,
        "rms_elevation_deg": elevation,
        **{name: best[name] for name in ("cost", "episode_return", "success")},
        "weights_sha256": sha256((folder / "best.safetensors").read_bytes()).hexdigest(),
        "host": platform.node(),
    }


class Checkpoints:
    """Checkpoints of a trial in the store: one archive of its folder, named by the number of chunks."""

    def __init__(self, order: Order, store: Store, folder: Path, archive: Path) -> None:
        self.store, self.folder, self.archive = store, folder, archive
        self.name = f"unfinished/{order.key}"
        self.seconds, self.saved = order.checkpoint_seconds, time.monotonic()

    def restore(self) -> None:
        """Unpack the last checkpoint, if there is one."""
        names = self.store.names(self.name)
        if names:
            self.store.download(names[-1], self.archive)
            with tarfile.open(self.archive) as archive:
                archive.extractall(self.folder, filter="data")

    def save(self, chunks: int) -> None:
        """Store a checkpoint and remove the earlier ones, unless the last one is recent."""
        if time.monotonic() - self.saved < self.seconds:
            return
        with tarfile.open(self.archive, "w") as archive:
            archive.add(self.folder, ".")
        name = f"{self.name}/{chunks:06d}.tar"
        self.store.upload(self.archive, name)
        for old in self.store.names(self.name):
            if old < name:
                self.store.remove(old)
        self.saved = time.monotonic()

    def remove(self) -> None:
        """Remove all checkpoints."""
        self.store.remove(self.name)


# The study


def check(args: Args, study: Study) -> tuple[Store, list[Trial]]:
    """Storage, and the trials of the study, or of one of its candidates.

    Raises ValueError and OSError for what would fail later.
    """
    seconds = args.checkpoint_seconds
    require("checkpoint_seconds", seconds, 0.0 <= seconds <= 1e6, "a number of seconds, 0 to 1e6")
    if study.search is None:
        trials = trials_of(study)
        check_distinct(trials)
    else:
        for candidate in islice(corners(study), MOST_TRIALS):
            trials = trials_of(study, candidate, f"study, search.space at {candidate}")
            check_distinct(trials)
    store = Store(str(args.out))
    if store.is_of_process and (args.engine, args.workers) != ("local", 1):
        raise ValueError(f"out = {args.out!r}: must be storage that all workers share")
    check_engine(args.engine, args.workers, args.address)
    store.check()
    return store, trials


def read_records(store: Store) -> dict[str, dict[str, Any]]:
    """Records of finished trials, by key."""
    records = [json.loads(text) for text in store.read_all("trials").values()]
    return {record["key"]: record for record in records}


def look(task: tuple[str, str]) -> bool:
    """Whether this worker finds a file in the storage."""
    out, name = task
    return Store(out).read(name) is not None


def check_shared(engine: Engine, store: Store) -> None:
    """Raise ValueError unless workers of a cluster find the study in the storage."""
    if not all(found for _, found in engine.results(look, [(store.url, "study.json")] * PROBES)):
        raise ValueError(f"out = {store.out!r}: must be storage that all machines of the cluster share")


@contextmanager
def locked_study(store: Store) -> Iterator[None]:
    """Hold the lock of a study in a folder. Raises ValueError while another process holds it."""
    if store.folder is None:
        yield
        return
    store.folder.mkdir(parents=True, exist_ok=True)
    with open(store.folder / ".lock", "ab") as file:
        if not try_lock(file):
            raise ValueError(f"out = {store.out!r}: another heli-sweep is running this study")
        yield


class Board:
    """Progress of a study with the time left, from its records and the names of its checkpoints."""

    def __init__(self, console: Console, store: Store, total: int) -> None:
        self.console, self.store, self.total = console, store, total
        self.finished = self.stored = 0
        columns = (TextColumn("trials"), BarColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
        self.progress = Progress(*columns, console=console)
        self.bar = self.progress.add_task("", total=total)
        self.chunks: dict[str, int] = {}  # by key of a trial
        self.begun = time.monotonic()
        self.ended = threading.Event()

    def __enter__(self) -> "Board":
        self.progress.start()
        self.thread = threading.Thread(target=self.poll, daemon=True)
        self.thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.ended.set()
        self.thread.join()
        self.progress.stop()

    def poll(self) -> None:
        """Update until the end."""
        while not self.ended.wait(POLL if self.store.folder else 10.0 * POLL):
            with suppress(Exception):  # the next look makes up for one that an object store refuses
                self.update()

    def update(self) -> None:
        """Show the share of the study that is done, and the time left."""
        done = float(self.finished)
        for name in self.store.names("unfinished"):
            _, key, file = name.split("/")
            done += int(Path(file).stem) / self.chunks[key] if key in self.chunks else 0.0
        left = ""
        if done > self.stored:
            seconds = (time.monotonic() - self.begun) * (self.total - done) / (done - self.stored)
            left = f", {timedelta(seconds=round(seconds))} left"
        self.progress.update(self.bar, completed=done, description=f"{self.finished} of {self.total}{left}")

    def add_stored(self, count: int) -> None:
        """Count trials that had records already."""
        self.stored += count
        self.finished += count
        self.update()

    def add(self, record: dict[str, Any]) -> None:
        """Count a record; without a terminal, print a line."""
        self.finished += 1
        self.update()
        if not self.console.is_terminal:
            self.console.print(self.progress.tasks[0].description, "trials:", record["run"], record.get("error", ""))


def check_folders(trials: Sequence[Trial], records: dict[str, dict[str, Any]]) -> None:
    """Raise ValueError if the folder of a trial without a record belongs to one of the records."""
    taken = {record["run"] for record in records.values()}
    for trial in trials:
        if trial.key not in records and trial.folder in taken:
            raise ValueError(f"out: {trial.folder} holds a trial with other settings or files; choose another folder")


class Sweep:
    """A study in progress: its storage, engine, and records by key of their trials."""

    def __init__(self, store: Store, engine: Engine, records: dict[str, dict[str, Any]], seconds: float) -> None:
        self.store, self.engine, self.records, self.checkpoint_seconds = store, engine, records, seconds

    def run(self, trials: Sequence[Trial], board: Board) -> None:
        """Run the trials that have no record yet."""
        missing = {trial.key: trial for trial in trials if trial.key not in self.records}
        for trial in missing.values():
            board.chunks[trial.key] = train.chunks_of(trial.args)
        board.add_stored(len(trials) - len(missing))
        orders = [order_of(trial, self.store, self.checkpoint_seconds) for trial in missing.values()]
        for _, record in self.engine.results(run_trial, orders, failed):
            if "error" not in record and self.store.read(record_name(record["key"])) is None:
                raise ValueError(
                    f"out = {self.store.out!r}: must be storage that all machines share; the record of a trial on "
                    f"{record['host']} is not there"
                )
            self.records[record["key"]] = record
            board.add(record)

    def search(self, study: Study, proposals: Proposals, board: Board) -> None:
        """Run all candidates of a search, batch by batch."""
        number = 0
        while candidates := proposals.propose():
            batch = []
            for candidate in candidates:
                number += 1
                batch.append(trials_of(study, candidate, f"study, candidate {number}"))
            trials = [trial for group in batch for trial in group]
            check_folders(trials, self.records)
            self.run(trials, board)
            proposals.learn([self.value(group, proposals.search.metric) for group in batch])

    def value(self, trials: Sequence[Trial], metric: str) -> float | None:
        """Mean of a metric over trials, or None if one failed."""
        records = [self.records[trial.key] for trial in trials]
        if any("error" in record for record in records):
            return None
        return sum(float(record[metric]) for record in records) / len(records)


def failed(order: Order, reason: str) -> dict[str, Any]:
    """Record of a trial that lost its process repeatedly."""
    return {"key": order.key, "run": order.folder, "values": order.values, "error": reason}


# Tables


def rows_of(records: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """Rows of trials.csv, in the order of the folders."""
    rows = []
    for record in sorted(records, key=lambda record: record["run"]):
        settings = record.get("settings", {})
        row = {name: settings.get(name) for name in ("plant", "rig", "algo", "seed")} | record["values"]
        row |= {name: record.get(name) for name in ("steps", "score", *MEASURED, "seconds", "weights_sha256")}
        rows.append({**row, "run": record["run"], "error": record.get("error")})
    return rows


def summarise(records: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """Means over the seeds of each method, with 95 % intervals of a bootstrap; None for a single seed."""
    methods: dict[str, list[dict[str, Any]]] = {}
    for record in records:
        if "error" not in record:
            methods.setdefault(record["run"].rpartition("/")[0], []).append(record)
    rows = []
    for method, own in sorted(methods.items()):
        row: dict[str, Any] = {"method": method.removeprefix("runs/"), "seeds": len(own)}
        for name in MEASURED:
            found = with_interval(np.array([record[name] for record in own]))
            low, high = found["interval"] or (None, None)
            row |= {name: found["mean"], f"{name}_low": low, f"{name}_high": high}
        rows.append(row)
    return rows


def write_tables(store: Store, records: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """Write trials.csv and summary.csv, and return the rows of the summary."""
    summary = summarise(records)
    store.write("trials.csv", to_csv(rows_of(records)))
    store.write("summary.csv", to_csv(summary))
    return summary


def table_of(summary: Sequence[dict[str, Any]]) -> Table:
    """Table of the summary."""
    table = Table(title="validation of the best networks, means over seeds")
    table.add_column("method")
    table.add_column("seeds", justify="right")
    for name in MEASURED:
        table.add_column(name, justify="right")
    for row in summary:
        cells = []
        for name in MEASURED:
            low, high = row[f"{name}_low"], row[f"{name}_high"]
            cells.append(f"{row[name]:.3g}" + ("" if low is None else f" [{low:.3g}, {high:.3g}]"))
        table.add_row(row["method"], str(row["seeds"]), *cells)
    return table


def run(args: Args) -> None:
    """Run the trials, and write and print the tables."""
    study = read_study(args.study)
    store, trials = check(args, study)
    proposals = Proposals(study.search) if study.search else None  # without Optuna, an error before the first trial
    console = Console(width=None if sys.stdout.isatty() else 180)
    with locked_study(store):
        records = read_records(store)
        if not args.resume and (records or store.read("study.json") is not None):
            raise ValueError(f"out: {args.out} holds a study already; --resume goes on with it")
        if proposals is None:
            check_folders(trials, records)
        store.write("study.json", study.to_json().encode())
        total = len(trials) * (study.search.trials if study.search else 1)
        try:
            with open_engine(args.engine, args.workers, args.address) as engine:
                if args.engine == "ray":
                    check_shared(engine, store)
                sweep = Sweep(store, engine, records, args.checkpoint_seconds)
                with Board(console, store, total) as board:
                    if proposals is None:
                        sweep.run(trials, board)
                    else:
                        sweep.search(study, proposals, board)
        except KeyboardInterrupt:
            raise KeyboardInterrupt(f"{len(records)} of {total} trials are in {args.out}; --resume goes on") from None
        finally:
            summary = write_tables(store, list(records.values()))
    console.print(table_of(summary))
    if proposals is not None and (best := proposals.best()):
        console.print(f"best: {best[0]}, mean {proposals.search.metric} {best[1]:.4g}")
    console.print(f"written to {args.out}: trials.csv, summary.csv, and runs for heli-results --methods")
    errors = [record for record in records.values() if "error" in record]
    if errors:
        raise RuntimeError(
            f"{len(errors)} of {total} trials failed, the first one in {errors[0]['run']}: {errors[0]['error']}; "
            "--resume tries them again"
        )


def main(args: Args | None = None) -> None:
    """Run the command `heli-sweep`."""
    with command("heli-sweep"):
        run(args or parse(Args, "heli-sweep", __doc__))


if __name__ == "__main__":
    main()
