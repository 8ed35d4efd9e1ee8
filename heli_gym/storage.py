"""Atomic writes of files, locks for files that are read, changed and written back, and readers of untrusted files."""

import csv
import errno
import io
import json
import math
import os
import secrets
import tempfile
import time
import tomllib
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]
    import msvcrt

LOCKED_BYTE = 2**30  # beyond the contents, because others cannot read what is locked on Windows
WAIT = 0.01  # s, before a lock is tried again on Windows


@contextmanager
def atomic_write(path: str | os.PathLike) -> Iterator[BinaryIO]:
    """Open a temporary file for writing, and rename it to `path` when the block succeeds. Missing folders are made.

    Any number of threads and processes may write the same file: one of them wins. Temporary files of killed processes
    are removed by the next process that writes the file. A link is followed; a device or a pipe is written to directly.
    An OSError without a file name, as of a full disk, gets that of the path.
    """
    path = Path(os.path.realpath(path))
    try:
        with atomic_file(path) as file:
            yield file
    except OSError as error:
        if error.errno is not None and error.filename is None:
            error.filename = str(path)
        raise


@contextmanager
def atomic_file(path: Path) -> Iterator[BinaryIO]:
    """File of `atomic_write`, by its real path."""
    if path.is_symlink():
        raise OSError(errno.ELOOP, os.strerror(errno.ELOOP), str(path))
    if path.exists() and not path.is_file() and not path.is_dir():
        with open(path, "wb") as file:
            yield file
        return
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
            with suppress(OSError):
                with open(path.with_name(name), "rb") as file:
                    # The lock covers writers on other machines, the process number a writer before its lock.
                    is_left = try_lock(file) and not is_alive(name)
                if is_left:  # closed, since Windows does not remove an open file
                    path.with_name(name).unlink()


def is_alive(name: str) -> bool:
    """Whether the process whose number is in the name of a temporary file runs on this machine; False on Windows."""
    if fcntl is None:  # there, signal 0 is Ctrl-C, and a file that its writer has open cannot be removed
        return False
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
    try:
        if fcntl is not None:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return True
        position = os.lseek(file.fileno(), 0, os.SEEK_CUR)
        os.lseek(file.fileno(), LOCKED_BYTE, os.SEEK_SET)
        try:
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined]
        finally:
            os.lseek(file.fileno(), position, os.SEEK_SET)
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
            elif not try_lock(file):
                time.sleep(WAIT)
                continue
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
    # a link to nothing counts, since no folder can be made in its place
    nearest = next(folder for folder in (path, *path.absolute().parents) if os.path.lexists(folder))
    with suppress(FileNotFoundError, NotADirectoryError):
        os.lstat(path)  # raises OSError for a name that is too long, a loop of links, or a folder that is not open
    if not nearest.is_dir():
        raise ValueError(f"{name} = {str(path)!r}: must be a folder, but {str(nearest)!r} is a file")
    try:
        with tempfile.TemporaryFile(dir=nearest) as probe:
            probe.write(b"\0" * 4096)
            probe.flush()
            os.fsync(probe.fileno())
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from error


def to_csv(rows: Sequence[Mapping[str, Any]]) -> bytes:
    """Rows as CSV, under every name that one of them has."""
    text = io.StringIO()
    writer = csv.DictWriter(text, list(dict.fromkeys(name for row in rows for name in row)), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue().encode()


MOST_BYTES = 2**28  # of all arrays in an .npz file


def parse_json(text: str | bytes) -> Any:
    """Parse JSON. Raises ValueError for anything else, also for text nested too deeply."""
    try:
        return json.loads(text)
    except RecursionError:
        raise ValueError("its JSON is nested too deeply") from None


def parse_toml(text: str) -> dict[str, Any]:
    """Parse TOML. Raises ValueError for anything else, also for text nested too deeply."""
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise ValueError("its TOML is nested too deeply") from None


def read_json_object(path: str | os.PathLike) -> dict[str, Any]:
    """Read a JSON object. Raises ValueError that names the file for any other content, OSError if it cannot be read."""
    data = Path(path).read_bytes()
    try:
        value = parse_json(data)
    except ValueError as error:
        raise ValueError(f"{path}: must be JSON: {error}") from error
    if not isinstance(value, dict):
        raise ValueError(f"{path}: must be a JSON object")
    return value


def read_arrays(path: str | os.PathLike) -> dict[str, np.ndarray]:
    """Read the arrays of an .npz file by name, without unpickling and without more memory than the file announces.

    Raises ValueError for a damaged file, or arrays of more than MOST_BYTES together; OSError if it cannot be opened.
    """
    arrays: dict[str, np.ndarray] = {}
    with open(path, "rb") as file:
        try:
            with zipfile.ZipFile(file) as archive:
                members = archive.infolist()
                if sum(member.file_size for member in members) > MOST_BYTES:
                    raise ValueError(f"its arrays take more than {MOST_BYTES >> 20} MB")
                for member in members:
                    with archive.open(member) as content:
                        arrays[member.filename.removesuffix(".npy")] = read_array(content, member.file_size)
        except ValueError:
            raise
        except Exception as error:  # zipfile, zlib and numpy raise many types for damaged files
            raise ValueError(str(error) or type(error).__name__) from error
    return arrays


def read_array(content: Any, size: int) -> np.ndarray:
    """Read one array in numpy's format, of at most `size` bytes."""
    version = np.lib.format.read_magic(content)
    read_header = {
        (1, 0): np.lib.format.read_array_header_1_0,
        (2, 0): np.lib.format.read_array_header_2_0,
    }.get(version)
    if read_header is None:
        raise ValueError(f"version {version} of numpy's format is unknown")
    shape, is_fortran, dtype = read_header(content)
    if dtype.hasobject:
        raise ValueError("an array of objects is not read")
    count = math.prod(shape)
    if not 0 <= count * dtype.itemsize <= size:
        raise ValueError(f"an array {shape} does not fit into {size} bytes")
    data = content.read(count * dtype.itemsize)
    if len(data) < count * dtype.itemsize:
        raise ValueError("an array is not whole")
    array = np.frombuffer(data, dtype, count)
    return array.reshape(shape, order="F" if is_fortran else "C").copy()
