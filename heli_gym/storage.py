"""Atomic writes of files, and locks for files that are read, changed and written back."""

import os
import secrets
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

try:
    import fcntl
except ImportError:  # Windows, where an open file cannot be removed: that replaces the lock
    fcntl = None  # type: ignore[assignment]


@contextmanager
def atomic_write(path: str | os.PathLike) -> Iterator[BinaryIO]:
    """Open a temporary file for writing, and rename it to `path` when the block succeeds. Missing folders are made.

    Any number of threads and processes may write the same file: one of them wins. Temporary files of killed processes
    are removed by the next process that writes the file.
    """
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    remove_unfinished(path)
    unfinished = path.with_name(f".{path.name}.{os.getpid()}-{secrets.token_hex(4)}.tmp")
    try:
        with open(unfinished, "xb") as file:
            try_lock(file)
            yield file
            file.flush()
            os.fsync(file.fileno())
        os.replace(unfinished, path)
    finally:
        with suppress(OSError):
            unfinished.unlink(missing_ok=True)


def remove_unfinished(path: Path) -> None:
    """Remove temporary files of processes that were killed while they wrote this file."""
    for name in os.listdir(path.parent):
        if name.startswith(f".{path.name}.") and name.endswith(".tmp"):
            with suppress(OSError), open(path.with_name(name), "rb") as file:
                # The lock covers writers on other machines, the process number a writer before its lock.
                if try_lock(file) and not is_alive(name):
                    path.with_name(name).unlink()


def is_alive(name: str) -> bool:
    """Whether the process whose number is in the name of a temporary file runs on this machine."""
    pid = name.split(".")[-2].partition("-")[0]
    try:
        os.kill(int(pid), 0)
    except PermissionError:
        return True
    except (OSError, ValueError, OverflowError):
        return False
    return True


def try_lock(file: BinaryIO) -> bool:
    """Try to lock an open file; return whether it worked. Closing the file or ending the process releases the lock."""
    if fcntl is None:
        return True
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True


@contextmanager
def locked(path: str | os.PathLike) -> Iterator[None]:
    """Hold the lock of this file; wait while another thread or process holds it.

    Protects reading, changing and writing back: `with locked(path): ...`.
    """
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    lock = path.with_name(f".{path.name}.lock")
    while True:
        with open(lock, "ab") as file:
            if fcntl is not None:
                fcntl.flock(file, fcntl.LOCK_EX)
            # The previous holder has removed this file: its name now belongs to another file, or to none.
            try:
                if os.fstat(file.fileno()).st_ino != lock.stat().st_ino:
                    continue
            except FileNotFoundError:
                continue
            try:
                yield
            finally:
                with suppress(OSError):
                    lock.unlink()
            return


def check_folder(name: str, path: str | os.PathLike) -> None:
    """Check before a long computation that a folder can be written to. Leaves nothing behind.

    Raises ValueError unless the path is or can become a folder, and OSError if the operating system cannot write
    there, because of permissions or a full disk.
    """
    path = Path(path)
    if "\0" in str(path):
        raise ValueError(f"{name} = {str(path)!r}: must be a path, without null characters")
    nearest = next(folder for folder in (path, *path.absolute().parents) if folder.exists())
    if not nearest.is_dir():
        raise ValueError(f"{name} = {str(path)!r}: must be a folder, but {str(nearest)!r} is a file")
    try:
        with tempfile.TemporaryFile(dir=nearest) as probe:
            probe.write(b"\0" * 4096)
            probe.flush()
            os.fsync(probe.fileno())
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from error
