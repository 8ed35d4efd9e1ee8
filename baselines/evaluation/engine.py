"""Engines for parallel work: tasks in, results out, in processes of this machine or on a Ray cluster.

    with open_engine("local", workers=2) as engine:
        for index, result in engine.results(function, tasks):
            ...

A task whose process or machine is lost runs again, and each task has one result. Callers store the results, and leave
out stored tasks when they resume. Only the engine "ray" imports Ray, from the extra `sweep`.
"""

import json
import multiprocessing
import os
import re
import signal
import socket
import subprocess
import sys
import threading
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from importlib.metadata import version
from typing import Any, Literal, Protocol, get_args

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

EngineName = Literal["local", "ray"]
IfLost = Callable[[Any, str], Any]

MOST_WORKERS = 256
RETRIES = 5  # times that a task runs again after its process or machine was lost
CONNECTION_TIMEOUT, CLUSTER_TIMEOUT = 3.0, 30.0  # s
OBJECT_STORE = 100 * 2**20  # bytes; tasks and results are small


class Engine(Protocol):
    """Runs tasks in parallel."""

    def results(
        self, function: Callable[[Any], Any], tasks: Iterable[Any], if_lost: IfLost | None = None
    ) -> Iterator[tuple[int, Any]]:
        """Yield index and result of each task, in the order of completion.

        The function must be importable by other processes. Its exceptions are raised here. A task that has lost its
        process repeatedly has the result of if_lost(task, reason); without it, RuntimeError is raised. Tasks in
        progress end when the iteration ends.
        """
        ...


def check_engine(name: str, workers: int, address: str | None = None) -> None:
    """Raise ValueError, within seconds, for an engine that cannot start: a missing Ray, no answer from its address."""
    if name not in get_args(EngineName):
        raise ValueError(f"engine = {name!r}: must be one of {', '.join(map(repr, get_args(EngineName)))}")
    if not 1 <= workers <= MOST_WORKERS:
        raise ValueError(f"workers = {workers}: must be at least 1 and at most {MOST_WORKERS}")
    if address is not None and name != "ray":
        raise ValueError(f"address = {address!r}: must be given with engine = 'ray' only")
    if name == "ray":
        import_ray()
        if address is not None:
            check_cluster(address)


@contextmanager
def open_engine(
    name: EngineName = "local", workers: int = 1, address: str | None = None, finish: bool = False
) -> Iterator[Engine]:
    """Engine that ends with the context.

    "local" runs tasks in `workers` processes, one worker in this process. "ray" connects to the cluster at the address,
    or starts one with `workers` cores on this machine. With `finish`, an interrupt lets running local tasks finish and
    yields their results before it is raised.
    """
    check_engine(name, workers, address)
    engine = LocalEngine(workers, finish) if name == "local" else RayEngine(workers, address)
    try:
        yield engine
    finally:
        engine.close()


def in_order(results: Iterator[tuple[int, Any]]) -> Iterator[Any]:
    """Results in the order of their tasks, each as soon as those before it are there."""
    early: dict[int, Any] = {}
    expected = 0
    for index, result in results:
        early[index] = result
        while expected in early:
            yield early.pop(expected)
            expected += 1


def progress_bar(console: Console) -> Progress:
    """Progress bar with counts, elapsed time and time left."""
    columns = (BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TimeRemainingColumn())
    return Progress(TextColumn("{task.description}"), *columns, console=console)


def track_results(
    engine: Engine, function: Callable[[Any], Any], tasks: Sequence[Any], description: str, console: Console
) -> Iterator[Any]:
    """Results in the order of their tasks, with a progress bar."""
    with progress_bar(console) as progress:
        bar = progress.add_task(description, total=len(tasks))

        def counted() -> Iterator[tuple[int, Any]]:
            for index, result in engine.results(function, tasks):
                progress.update(bar, advance=1)
                yield index, result

        yield from in_order(counted())


class Losses:
    """Counts losses of each task's process."""

    def __init__(self, if_lost: IfLost | None) -> None:
        self.if_lost = if_lost
        self.counts: Counter[int] = Counter()

    def may_repeat(self, index: int) -> bool:
        """Count a loss, and return whether the task may run again."""
        self.counts[index] += 1
        return self.counts[index] <= RETRIES

    def result(self, index: int, task: Any, reason: str) -> Any:
        """Result of a lost task. Raises RuntimeError without `if_lost`."""
        reason = f"its process was lost {self.counts[index]} times: {reason}"
        if self.if_lost is None:
            raise RuntimeError(f"task {index + 1}: {reason}")
        return self.if_lost(task, reason)


# Processes of this machine


class Slot:
    """One process for tasks, started with the first task and after each loss."""

    def __init__(self) -> None:
        self.pool: ProcessPoolExecutor | None = None
        self.processes: set[Any] = set()

    def submit(self, function: Callable[[Any], Any], task: Any) -> Future:
        """Start a task."""
        if self.pool is not None:
            try:
                return self.pool.submit(function, task)
            except BrokenProcessPool:  # killed while idle
                self.kill()
        others = set(multiprocessing.active_children())
        self.pool = ProcessPoolExecutor(1, multiprocessing.get_context("spawn"), init_worker)
        with interrupts_blocked():
            future = self.pool.submit(function, task)  # starts the process
        self.processes = set(multiprocessing.active_children()) - others
        return future

    def kill(self) -> None:
        """End the process at once, with its task."""
        for process in self.processes:
            process.kill()
        self.close()

    def close(self) -> None:
        """End the process after its task."""
        if self.pool is not None:
            self.pool.shutdown(wait=True, cancel_futures=True)
        self.pool, self.processes = None, set()


class LocalEngine:
    """Runs each task in one of several processes, or with one worker in this process."""

    def __init__(self, workers: int, finish: bool = False) -> None:
        self.finish = finish
        self.slots = [Slot() for _ in range(workers)]

    def results(
        self, function: Callable[[Any], Any], tasks: Iterable[Any], if_lost: IfLost | None = None
    ) -> Iterator[tuple[int, Any]]:
        """See `Engine`."""
        if len(self.slots) == 1:
            for index, task in enumerate(tasks):
                yield index, function(task)
            return
        waiting, losses = enumerate(tasks), Losses(if_lost)
        again: list[tuple[int, Any]] = []
        free, running = list(self.slots), dict[Future, tuple[int, Any, Slot]]()
        interrupted = False
        try:
            while True:
                while free and not interrupted:
                    following = again.pop() if again else next(waiting, None)
                    if following is None:
                        break
                    slot = free.pop()
                    running[slot.submit(function, following[1])] = *following, slot
                if not running:
                    break
                try:
                    done, _ = wait(running, return_when=FIRST_COMPLETED)
                except KeyboardInterrupt:
                    if not self.finish or interrupted:
                        raise
                    interrupted = True
                    continue
                for future in done:
                    index, task, slot = running.pop(future)
                    free.append(slot)
                    try:
                        result = future.result()
                    except BrokenProcessPool as error:
                        slot.kill()
                        if losses.may_repeat(index):
                            again.append((index, task))
                            continue
                        result = losses.result(index, task, str(error))
                    yield index, result
        finally:
            for _, _, slot in running.values():
                slot.kill()
        if interrupted:
            raise KeyboardInterrupt

    def close(self) -> None:
        """End the processes."""
        for slot in self.slots:
            slot.close()


@contextmanager
def interrupts_blocked() -> Iterator[None]:
    """Deliver Ctrl-C after the context only; processes that start in it never see one, not even while they import."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def init_worker() -> None:
    """Set up a worker: ignore Ctrl-C, which the parent handles, and end with the parent."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:

        def follow_parent() -> None:
            parent.join()
            os._exit(1)

        threading.Thread(target=follow_parent, daemon=True).start()


# Ray


def import_ray() -> Any:
    """Module `ray`, which sends no usage statistics. Raises ValueError if it is not installed."""
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    os.environ.setdefault("RAY_worker_niceness", "0")  # like other processes; Ray's own default is 15
    try:
        import ray
    except ImportError as error:
        raise ValueError(
            "engine = 'ray': must be 'local' without Ray; `pip install \"heli-gym[sweep]\"` brings it"
        ) from error
    return ray


CONNECTION = {"log_to_driver": False, "logging_level": "ERROR", "configure_logging": False}

# Ray waits two minutes for a wrong address and then ends the process: another process tries it first.
PROBE = """
import json, sys
from importlib.metadata import version
from heli_gym.baselines.evaluation.engine import CONNECTION, import_ray
ray = import_ray()
ray.init(address=sys.argv[1], **CONNECTION)
print(json.dumps(ray.get(ray.remote(num_cpus=0)(version).remote("heli-gym"))))
"""


def check_cluster(address: str) -> None:
    """Raise ValueError unless a Ray cluster answers at the address and its nodes have this version of heli-gym."""
    found = re.fullmatch(r"([^:/]+|\[[^]/]+\]):(\d{1,5})", address)
    if address != "auto" and not found:
        raise ValueError(f"address = {address!r}: must be HOST:PORT of a cluster that this machine is part of, or auto")
    if found:
        try:
            socket.create_connection((found[1].strip("[]"), int(found[2])), CONNECTION_TIMEOUT).close()
        except (OSError, OverflowError) as error:
            raise ValueError(f"address = {address!r}: must be of a running cluster: {error}") from error
    try:
        order = [sys.executable, "-c", PROBE, address]
        probe = subprocess.run(order, capture_output=True, text=True, timeout=CLUSTER_TIMEOUT)
    except subprocess.TimeoutExpired as error:
        raise ValueError(
            f"address = {address!r}: must be of a running cluster: nothing there speaks Ray within "
            f"{CLUSTER_TIMEOUT:g} s"
        ) from error
    if probe.returncode:
        reason = (probe.stderr.strip() or "no reason given").splitlines()[-1]
        raise ValueError(f"address = {address!r}: must be of a running cluster with heli-gym: {reason}")
    theirs, ours = json.loads(probe.stdout.splitlines()[-1]), version("heli-gym")
    if theirs != ours:
        raise ValueError(f"address = {address!r}: must have heli-gym {ours} on its nodes, not {theirs}")


def call(function: Callable[[Any], Any], task: Any) -> Any:
    """Call the function in a worker of Ray."""
    return function(task)


class RayEngine:
    """Runs each task on one core of a Ray cluster."""

    def __init__(self, workers: int, address: str | None = None) -> None:
        self.ray = import_ray()
        self.is_own = not self.ray.is_initialized()
        if self.is_own:
            if address is None:
                # Its workers import what this process can import.
                os.environ["PYTHONPATH"] = os.pathsep.join(path or os.getcwd() for path in sys.path)
                own = {"num_cpus": workers, "object_store_memory": OBJECT_STORE, "include_dashboard": False}
                self.ray.init(address="local", **own, **CONNECTION)
            else:
                self.ray.init(address=address, **CONNECTION)

    def results(
        self, function: Callable[[Any], Any], tasks: Iterable[Any], if_lost: IfLost | None = None
    ) -> Iterator[tuple[int, Any]]:
        """See `Engine`."""
        ray = self.ray
        remote = ray.remote(num_cpus=1, max_retries=0, scheduling_strategy="SPREAD")(call)
        waiting, losses = enumerate(tasks), Losses(if_lost)
        again: list[tuple[int, Any]] = []
        running: dict[Any, tuple[int, Any]] = {}
        try:
            while True:
                # Twice as many tasks as cores keep all busy, and make an autoscaler add nodes.
                most = 2 * max(1, int(ray.cluster_resources().get("CPU", 1)))
                while len(running) < most:
                    following = again.pop() if again else next(waiting, None)
                    if following is None:
                        break
                    running[remote.remote(function, following[1])] = following
                if not running:
                    break
                done, _ = ray.wait(list(running), num_returns=1, timeout=1.0)
                for reference in done:
                    index, task = running.pop(reference)
                    try:
                        result = ray.get(reference)
                    except ray.exceptions.RayTaskError as error:
                        if isinstance(error.cause, ray.exceptions.RayError):  # it did not reach the function
                            raise RuntimeError(f"a worker of Ray: {str(error.cause).splitlines()[0]}") from None
                        raise error.cause from None
                    except ray.exceptions.RayError as error:
                        if losses.may_repeat(index):
                            again.append((index, task))
                            continue
                        result = losses.result(index, task, str(error).splitlines()[0])
                    yield index, result
        finally:
            for reference in running:
                ray.cancel(reference, force=True)

    def close(self) -> None:
        """Disconnect from the cluster, or end the own one."""
        if self.is_own:
            self.ray.shutdown()
