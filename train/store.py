"""Files of a study in a folder, or at a URL of fsspec (s3://bucket/study). Every write is atomic.

A folder writes by renaming; an object store shows an object once it is complete.
"""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from tempfile import TemporaryDirectory, gettempdir
from time import time
from typing import Any

from fsspec.core import url_to_fs
from fsspec.implementations.local import LocalFileSystem
from fsspec.implementations.memory import MemoryFileSystem

from heli_gym.storage import atomic_write, check_folder, try_lock

PREFIX = "heli-sweep-"
HOUR = 3600.0  # s


class Store:
    """Named files in a folder or object store. Names have "/" between their parts."""

    def __init__(self, out: str) -> None:
        """Raises ValueError for a URL that fsspec cannot open."""
        try:
            self.fs, root = url_to_fs(out)
        except (ValueError, ImportError) as error:
            raise ValueError(f"out = {out!r}: must be a folder, or a URL that fsspec opens: {error}") from error
        self.out = out
        self.folder = Path(root) if isinstance(self.fs, LocalFileSystem) else None
        self.root = root.rstrip("/")
        self.url = self.root if self.folder else out  # for workers with another working directory
        self.is_of_process = isinstance(self.fs, MemoryFileSystem)

    def check(self) -> None:
        """Raise ValueError or OSError unless files can be written."""
        if self.folder is not None:
            check_folder("out", self.folder)
            return
        try:
            self.write(".probe", b"\0")
            self.remove(".probe")
        except Exception as error:  # every store has exceptions of its own
            raise ValueError(f"out = {self.out!r}: must be writable: {type(error).__name__}: {error}") from error

    def path(self, name: str) -> str:
        """Path in the file system."""
        return f"{self.root}/{name}"

    def read(self, name: str) -> bytes | None:
        """Content of a file, or None if it does not exist."""
        with suppress(FileNotFoundError):
            return self.fs.cat_file(self.path(name))
        return None

    def names(self, folder: str) -> list[str]:
        """Sorted names of all files in a folder, in its folders too."""
        self.fs.invalidate_cache()
        found = self.fs.find(self.path(folder))
        return sorted(path[len(self.path("")) :] for path in found if "/." not in path[len(self.root) :])

    def read_all(self, folder: str) -> dict[str, bytes]:
        """Contents of all files in a folder, by name."""
        names = self.names(folder)
        contents: Any = self.fs.cat([self.path(name) for name in names]) if names else {}
        return {name: contents[self.path(name)] for name in names}

    def write(self, name: str, data: bytes) -> None:
        """Write a file."""
        if self.folder is None:
            self.fs.pipe_file(self.path(name), data)
            return
        with atomic_write(self.path(name)) as file:
            file.write(data)

    def upload(self, path: Path, name: str) -> None:
        """Copy a file of this machine into the store."""
        if self.folder is None:
            self.fs.put_file(str(path), self.path(name))
            return
        with open(path, "rb") as source, atomic_write(self.path(name)) as file:
            shutil.copyfileobj(source, file)

    def download(self, name: str, path: Path) -> None:
        """Copy a file of the store to this machine."""
        self.fs.get_file(self.path(name), str(path))

    def remove(self, name: str) -> None:
        """Remove a file, or a folder with all its files, if it exists."""
        with suppress(FileNotFoundError):
            self.fs.rm(self.path(name), recursive=True)


@contextmanager
def scratch_folder() -> Iterator[Path]:
    """Temporary folder of this machine. Removes those of killed processes, too."""
    for old in Path(gettempdir()).glob(f"{PREFIX}*"):
        with suppress(OSError), open(old / "lock", "rb") as file:
            if old.stat().st_mtime < time() - HOUR and try_lock(file):
                shutil.rmtree(old, ignore_errors=True)
    own = TemporaryDirectory(prefix=PREFIX, ignore_cleanup_errors=True)
    with own as name, open(Path(name) / "lock", "wb") as file:
        try_lock(file)
        (Path(name) / "work").mkdir()
        yield Path(name) / "work"
