"""Tasks for engines, importable by other processes."""

import os
import signal
import time
from pathlib import Path


def square(x):
    return x * x


def refuse(x):
    if x == 3:
        raise ValueError(f"x = {x}: must not be three")
    return x


def sleep_and_note(task):
    """Sleep, and note the start and the process in a file."""
    folder, x, seconds = task
    with open(Path(folder) / f"{x}.{os.getpid()}.{time.monotonic_ns()}", "w"):
        pass
    time.sleep(seconds)
    return x


def die_once(task):
    """End the process at the first attempt of an odd number."""
    folder, x = task
    mark = Path(folder) / str(x)
    if x % 2 and not mark.exists():
        mark.touch()
        os._exit(9)
    return x


def die(x):
    os._exit(9)


def blocked_signals(_):
    """Signals that do not reach this process, by number."""
    return sorted(map(int, signal.pthread_sigmask(signal.SIG_BLOCK, ())))
