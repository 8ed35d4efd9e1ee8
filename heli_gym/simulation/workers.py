"""Threads that share the blocks of a control step; flights are the same for any number of them."""

import itertools
import math
import os
import threading
import time
from collections.abc import Callable
from functools import cache

CHUNKS = 8  # of a step for each thread, so that one that is interrupted holds up little
PROBE_SHARE = 0.01  # of the time, at most, for trying whether the slower way has become the faster one
MEMORY = 0.2  # weight of the latest step in the mean time of a way


class Job:
    """A loop over [0, count) in chunks; whoever calls `work` takes the next ones until there are none left."""

    def __init__(self, task: Callable[[int, int], int], count: int, chunk: int) -> None:
        self.task, self.count, self.chunk = task, count, chunk
        self.starts = itertools.count(0, chunk)  # the next one is taken atomically
        self.left = -(-count // chunk)
        self.total = 0
        self.lock, self.finished = threading.Lock(), threading.Event()

    def work(self) -> None:
        """Do chunks until none is left."""
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
    """Threads that join in the latest job. One pool serves all simulations of a process."""

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
        """Join in job after job."""
        while True:
            self.semaphore.acquire()
            job = self.job
            if job is not None:
                job.work()
            del job  # its arrays are the caller's


@cache
def pool(threads: int, process: int) -> Pool:
    """The pool of a process, for threads do not survive a fork."""
    return Pool(threads)


class Workers:
    """Loops over blocks by several threads, or by the caller alone where that has proved faster.

    Threads do not pay for few helicopters, or while other processes hold the cores; so both ways are timed all along.
    """

    def __init__(self, threads: int) -> None:
        self.threads, self.steps, self.next_probe = threads, 0, 0
        self.means = {True: 0.0, False: 0.0}  # s a step, with the other threads and without; zero: not tried yet

    def run(self, task: Callable[[int, int], int], count: int) -> int:
        """Call the task with ranges (begin, end) that cover [0, count), and return the sum of its results."""
        self.steps += 1
        together = self.means[True] <= self.means[False]
        if self.steps == self.next_probe:
            together = not together
        begin = time.perf_counter()
        total = pool(self.threads, os.getpid()).run(task, count) if together else task(0, count)
        took, mean = time.perf_counter() - begin, self.means[together]
        if self.steps > 1:  # the first one compiles
            self.means[together] = took if mean == 0.0 else (1.0 - MEMORY) * mean + MEMORY * took
            fast, slow = sorted(self.means.values())
            if self.steps >= self.next_probe and fast > 0.0:
                self.next_probe = self.steps + math.ceil(slow / (PROBE_SHARE * fast))
        return total
