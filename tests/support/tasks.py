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


def note_and_wait(task):
    """Note the start in a file, and wait until there is a file "end"; half an hour at most."""
    folder, x = task
    (Path(folder) / str(x)).touch()
    for _ in range(180_000):
        if (Path(folder) / "end").exists():
            break
        time.sleep(0.01)
    return x


def wait_or_refuse(task):
    """Task 0: note its process in a file, and wait. Task 1: raise ValueError once it does."""
    folder, x = task
    note = Path(folder) / "process"
    if x == 0:
        (Path(folder) / "draft").write_text(str(os.getpid()))
        (Path(folder) / "draft").rename(note)
        return note_and_wait(task)
    while not note.exists():
        time.sleep(0.01)
    return refuse(3)


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
