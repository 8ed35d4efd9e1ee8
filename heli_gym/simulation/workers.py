"""Threads that share the blocks of a control step; flights do not depend on their number."""

import itertools
import math
import os
import threading
import time
from collections.abc import Callable
from functools import cache

CHUNKS = 8  # of a step for each thread, so that an interrupted thread delays only a small part
PROBE_SHARE = 0.01  # largest share of the time spent on trials of the slower mode
MEMORY = 0.2  # weight of the latest step in the mean time of a mode


class Job:
    """Loop over [0, count) in chunks; every thread that calls `work` takes the next chunk until all are done."""

    def __init__(self, task: Callable[[int, int], int], count: int, chunk: int) -> None:
        self.task, self.count, self.chunk = task, count, chunk
        self.starts = itertools.count(0, chunk)  # `next` is atomic
        self.left = -(-count // chunk)
        self.total = 0
        self.lock, self.finished = threading.Lock(), threading.Event()

    def work(self) -> None:
        """Process chunks until all are taken."""
        for start in self.starts:
            if start >= self.count:
                return
            result = self.task(start, min(start + self.chunk, self.count))
            with self.lock:
                self.total += result
                self.left -= 1
                if self.left == 0:
                    self.finished.set()


class Pool:
    """Threads that work on the latest job; one pool serves all simulations of a process."""

    def __init__(self, threads: int) -> None:
        self.semaphore, self.threads = threading.Semaphore(0), threads
        self.job: Job | None = None
        for _ in range(threads - 1):
            threading.Thread(target=self.serve, daemon=True).start()

    def run(self, task: Callable[[int, int], int], count: int) -> int:
        """Call the task with ranges (begin, end) that cover [0, count), and return the sum of its results."""
        self.job = job = Job(task, count, max(1, count // (CHUNKS * self.threads)))
        self.semaphore.release(self.threads - 1)
        job.work()
        job.finished.wait()
        self.job = None
        return job.total

    def serve(self) -> None:
        """Work on one job after another; the loop of a thread."""
        while True:
            self.semaphore.acquire()
            job = self.job
            if job is not None:
                job.work()
            del job  # release the caller's arrays


@cache
def pool(threads: int, process: int) -> Pool:
    """Pool of threads, one per process, since threads do not survive a fork."""
    return Pool(threads)


class Workers:
    """Loop over blocks with several threads, or in the caller alone if that has been faster.

    Threads are slower for few helicopters or while other processes use the cores, so both modes are timed continually.
    """

    def __init__(self, threads: int) -> None:
        self.threads, self.steps, self.next_probe = threads, 0, 0
        self.means = {True: 0.0, False: 0.0}  # s per step, with and without the other threads; zero: not tried yet

    def run(self, task: Callable[[int, int], int], count: int) -> int:
        """Call the task with ranges (begin, end) that cover [0, count), and return the sum of its results."""
        self.steps += 1
        together = self.means[True] <= self.means[False]
        if self.steps == self.next_probe:
            together = not together
        begin = time.perf_counter()
        total = pool(self.threads, os.getpid()).run(task, count) if together else task(0, count)
        took, mean = time.perf_counter() - begin, self.means[together]
        if self.steps > 1:  # the first step compiles
            self.means[together] = took if mean == 0.0 else (1.0 - MEMORY) * mean + MEMORY * took
            fast, slow = sorted(self.means.values())
            if self.steps >= self.next_probe and fast > 0.0:
                self.next_probe = self.steps + math.ceil(slow / (PROBE_SHARE * fast))
        return total
