"""Faults and speed of `heli-sweep` on a Ray cluster of two nodes on this machine.

    python benchmarks/cluster.py            # faults, then times; some five minutes on two idle cores
    python benchmarks/cluster.py --short    # faults, with fewer trials
    python benchmarks/cluster.py --timing   # times only

Trains a small study without Ray. Then trains it on the cluster, while it kills a worker in mid-trial, removes a node
with a trial on it, adds another node, kills the command and resumes it. Ends with status 1 unless both studies have the
same weights, and one record per trial. Requires the extras `train` and `sweep`.
"""

import argparse
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from rich.console import Console

from heli_gym.baselines.evaluation.engine import OBJECT_STORE, import_ray, open_engine
from heli_gym.train import train
from heli_gym.train.store import Store
from heli_gym.train.study import read_study, trials_of
from heli_gym.train.sweep import order_of, read_records, run_trial

STUDY = """
[settings]
plant = "lab"
reference = "climb-7.5"
algo = "ppo"
steps = {steps}
envs = 16
chunk = 64
rollout = 64
batch = 128
validation = 4

[grid]
seed = {seeds}
"""
PATIENCE = 300.0  # s
TRIAL = 10.0  # s, about
COMMAND = "from heli_gym import cli\nif __name__ == '__main__':\n    cli.run('heli-sweep')\n"


def add_node(nodes: Any) -> Any:
    """Add a node with one core to the cluster. Ray waits 30 s for its start, which a loaded machine may exceed."""
    for attempt in range(3):
        try:
            return nodes.add_node(num_cpus=1, object_store_memory=OBJECT_STORE)
        except Exception as error:
            if attempt == 2:
                raise
            print(f"a node did not start, once more: {error}", flush=True)


@contextmanager
def cluster() -> Iterator[Any]:
    """Cluster of two nodes with one core each; all its processes end with the context."""
    import_ray()
    from ray.cluster_utils import Cluster

    # The names of Ray's sockets allow short paths only.
    temporary = tempfile.mkdtemp(prefix="heli-ray-")
    head = {"num_cpus": 1, "object_store_memory": OBJECT_STORE, "include_dashboard": False, "temp_dir": temporary}
    nodes = Cluster(initialize_head=True, head_node_args=head)
    try:
        add_node(nodes)
        yield nodes
    finally:
        nodes.shutdown()
        shutil.rmtree(temporary, ignore_errors=True)


def workers(node: Any) -> list[int]:
    """Process numbers of the workers of a node that run a trial."""
    raylet = node.all_processes["raylet"][0].process.pid
    found = subprocess.run(["pgrep", "-P", str(raylet), "-f", "ray::call"], capture_output=True, text=True)
    return [int(number) for number in found.stdout.split()]


class Command:
    """`heli-sweep` on the cluster."""

    def __init__(self, folder: Path, address: str) -> None:
        script = folder / "start.py"
        script.write_text(COMMAND)
        self.arguments = [sys.executable, str(script), str(folder / "study.toml"), "--out", str(folder / "disturbed")]
        self.arguments += ["--engine", "ray", "--address", address, "--checkpoint-seconds", "0", "--resume"]
        self.log = folder / "log.txt"

    def start(self) -> None:
        """Start or resume."""
        with open(self.log, "ab") as log:
            self.process = subprocess.Popen(self.arguments, stdout=log, stderr=log)

    def kill(self) -> None:
        """End the process without warning."""
        self.process.kill()
        self.process.wait()

    def until(self, condition: Callable[[], Any], wanted: str) -> Any:
        """Wait for a condition while the command runs, and return its value. Raises TimeoutError or RuntimeError."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if value := condition():
                return value
            if self.process.poll() is not None:
                raise RuntimeError(f"{wanted}: not before the end of heli-sweep\n{self.log.read_text()}")
            time.sleep(0.05)
        raise TimeoutError(f"{wanted}: not within {PATIENCE:g} s\n{self.log.read_text()}")


def disturb(folder: Path, store: Store) -> int:
    """Train the study under faults, and return the number of trials done before the resumption."""

    def underway(least: int) -> set[str]:
        """Trials with at least this number of chunks done."""
        names = [name.split("/") for name in store.names("unfinished")]
        return {key for _, key, file in names if int(Path(file).stem) >= least}

    with cluster() as nodes:
        command = Command(folder, nodes.address)
        command.start()
        try:
            first, second = nodes.list_all_nodes()
            running = command.until(lambda: underway(2) and workers(second) and workers(first), "trials on both nodes")
            killed = running[0]
            os.kill(killed, signal.SIGKILL)
            print(f"killed worker {killed} in mid-trial", flush=True)
            command.until(lambda: workers(second), "a trial on the second node")
            nodes.remove_node(second, allow_graceful=False)
            print("removed the second node with its trial", flush=True)
            third = add_node(nodes)
            command.until(lambda: workers(third), "a trial on the new node")
            print("added a node, which runs a trial", flush=True)
            command.until(lambda: read_records(store) and underway(2), "a finished trial and one in progress")
            command.kill()
            finished = len(read_records(store))
            print(f"killed heli-sweep after {finished} finished trials", flush=True)
            command.start()
            if command.process.wait(PATIENCE):
                raise RuntimeError(command.log.read_text())
        finally:
            command.kill()
    return finished


def compare(undisturbed: Store, disturbed: Store) -> list[str]:
    """Differences of two studies: weights, validations, and the number of records."""
    ours, theirs = read_records(undisturbed), read_records(disturbed)
    differences = [f"{len(theirs)} records, not {len(ours)}"] if set(ours) != set(theirs) else []
    for key in set(ours) & set(theirs):
        differences += [
            f"{ours[key]['run']}: {name} differs"
            for name in ours[key]
            if name not in ("seconds", "host") and ours[key][name] != theirs[key][name]
        ]
        networks = [name for name in disturbed.names(ours[key]["run"]) if name.endswith("best.safetensors")]
        if len(networks) != 1 or disturbed.read(networks[0]) != undisturbed.read(networks[0]):
            differences.append(f"{ours[key]['run']}: the stored network differs")
    rows = (disturbed.read("trials.csv") or b"").decode().splitlines()
    if len(rows) != len(ours) + 1 or len(set(rows)) != len(rows):
        differences.append(f"trials.csv has {len(rows) - 1} rows, not {len(ours)}")
    return differences


def steps_of(folder: Path, seconds: float) -> int:
    """Number of steps that a trial takes in this time on this machine, after the kernels are compiled."""
    steps = 4096
    (folder / "calibration.toml").write_text(STUDY.format(steps=steps, seeds=[0, 1]))
    for trial in trials_of(read_study(folder / "calibration.toml")):
        begun = time.perf_counter()
        run_trial(order_of(trial, Store(str(folder / "calibration")), 30.0))
        duration = time.perf_counter() - begun
    return max(2, int(seconds / duration)) * steps


def check_faults(folder: Path, trials: int) -> None:
    """Train a study undisturbed and disturbed, and compare. Ends with status 1 for a difference.

    A trial takes longer than the start of a worker, so that every fault meets trials in progress.
    """
    steps = steps_of(folder, TRIAL)
    (folder / "study.toml").write_text(STUDY.format(steps=steps, seeds=list(range(trials))))
    undisturbed, disturbed = Store(str(folder / "undisturbed")), Store(str(folder / "disturbed"))
    begun = time.perf_counter()
    for trial in trials_of(read_study(folder / "study.toml")):
        run_trial(order_of(trial, undisturbed, 30.0))
    print(f"undisturbed, without Ray: {trials} trials in {time.perf_counter() - begun:.0f} s", flush=True)
    finished = disturb(folder, disturbed)
    differences = compare(undisturbed, disturbed)
    for line in differences:
        print(line)
    digests = {record["weights_sha256"] for record in read_records(disturbed).values()}
    print(json.dumps({"trials": trials, "before the resumption": finished, "different weights": len(digests)}))
    if differences:
        raise SystemExit(1)
    print(f"nothing lost, nothing twice: {trials} trials with the weights of the undisturbed study, byte for byte")


def time_trials(folder: Path, steps: int, count: int) -> None:
    """Print overhead and speed-up of the engines on equal trials, after warming up their workers."""
    (folder / "timing.toml").write_text(STUDY.format(steps=steps, seeds=list(range(100, 100 + count + 2))))
    trials = trials_of(read_study(folder / "timing.toml"))
    warm, timed = trials[:2], trials[2:]
    single = 0.0
    for number, trial in enumerate((warm[0], *timed)):
        args = train.Args(**{**vars(trial.args), "out": folder / "alone" / str(number), "resume": False})
        begun = time.perf_counter()
        train.train(args, Console(quiet=True))
        single += (time.perf_counter() - begun) / count if number else 0.0
    print(f"train alone, in one process: {single:.2f} s a trial; load {os.getloadavg()[0]:.1f}", flush=True)
    print("| engine | workers | s a trial | empty task (ms) | load |", "|---|---|---|---|---|", sep="\n", flush=True)
    walls: dict[tuple[str, int], float] = {}
    for name in ("local", "ray"):
        for workers in (1, 2):
            with open_engine(name, workers) as engine:  # type: ignore[arg-type]
                store = Store(str(folder / f"{name}-{workers}"))
                for _ in engine.results(run_trial, [order_of(trial, store, 30.0) for trial in warm]):
                    pass
                begun = time.perf_counter()
                for _ in engine.results(run_trial, [order_of(trial, store, 30.0) for trial in timed]):
                    pass
                walls[name, workers] = (time.perf_counter() - begun) / count
                begun = time.perf_counter()
                empty = sum(1 for _ in engine.results(abs, range(200)))
                task = (time.perf_counter() - begun) / empty
            load = os.getloadavg()[0]
            print(f"| {name} | {workers} | {walls[name, workers]:.2f} | {1e3 * task:.2f} | {load:.1f} |", flush=True)
    for name in ("local", "ray"):
        overhead, gain = walls[name, 1] - single, walls[name, 1] / walls[name, 2]
        print(f"{name}: {overhead:+.2f} s a trial over training alone; 2 workers are {gain:.2f} times as fast as 1")
    size = sum(len(data) for data in store.read_all("runs").values()) / len(trials)
    records = sum(len(data) for data in store.read_all("trials").values()) / len(trials)
    print(f"stored: {size / 1e3:.0f} kB of networks and histories, and a record of {records / 1e3:.1f} kB, a trial")


def main() -> None:
    """Disturb, compare, and time."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--short", action="store_true", help="faults only, with fewer trials")
    parser.add_argument("--timing", action="store_true", help="times only")
    chosen = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # so that the cluster ends too
    with tempfile.TemporaryDirectory(prefix="heli-cluster-") as name:
        if not chosen.timing:
            check_faults(Path(name), 5 if chosen.short else 8)
        if not chosen.short:
            time_trials(Path(name), 10 * 1024, 4)


if __name__ == "__main__":
    main()
