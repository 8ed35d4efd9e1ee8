"""Atomic writes: a file holds the new contents or the old ones."""

import fcntl
import importlib.util
import multiprocessing
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

import pytest
import writers

from heli_gym import storage
from heli_gym.storage import atomic_write, check_folder


@pytest.mark.parametrize("kind", [str, lambda path: path], ids=["str", "Path"])
def test_a_write_makes_folders_and_stores_the_data(tmp_path, kind):
    path = tmp_path / "new" / "folder" / "file.bin"
    with atomic_write(kind(path)) as file:
        file.write(b"some ")
        file.write(b"bytes")
    assert path.read_bytes() == b"some bytes"
    assert os.listdir(path.parent) == ["file.bin"]


def test_the_old_content_stays_until_all_is_written(tmp_path):
    path = tmp_path / "file"
    path.write_bytes(b"old")
    with atomic_write(path) as file:
        file.write(b"new")
        file.flush()
        assert path.read_bytes() == b"old"
    assert path.read_bytes() == b"new"


@pytest.mark.parametrize("failure", [ValueError, KeyboardInterrupt])
@pytest.mark.parametrize("existing", [True, False])
def test_a_failed_write_leaves_the_old_file_and_no_temporary_file(tmp_path, failure, existing):
    path = tmp_path / "file"
    if existing:
        path.write_bytes(b"old")
    with pytest.raises(failure), atomic_write(path) as file:
        file.write(b"half of the n")
        raise failure
    assert [(name, (tmp_path / name).read_bytes()) for name in os.listdir(tmp_path)] == [("file", b"old")] * existing


def test_a_name_that_is_a_folder_is_refused_without_litter(tmp_path):
    (tmp_path / "folder").mkdir()
    with pytest.raises(OSError), atomic_write(tmp_path / "folder") as file:
        file.write(b"new")
    assert os.listdir(tmp_path) == ["folder"]
    assert os.listdir(tmp_path / "folder") == []


def test_of_two_processes_that_write_at_once_one_wins_whole(tmp_path):
    context = multiprocessing.get_context("spawn")
    processes = [context.Process(target=writers.write_often, args=(tmp_path / "file", byte)) for byte in (b"a", b"b")]
    for writer in processes:
        writer.start()
    for writer in processes:
        writer.join()
        assert writer.exitcode == 0
    content = (tmp_path / "file").read_bytes()
    assert content in (b"a" * 100_000, b"b" * 100_000)
    assert os.listdir(tmp_path) == ["file"]


def test_threads_that_write_the_same_file_at_once_all_succeed(tmp_path):
    path = tmp_path / "file"

    def write_often(byte):
        for _ in range(50):
            with atomic_write(path) as file:
                file.write(byte * 1000)

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(write_often, (b"a", b"b", b"c", b"d")))
    assert len(set(path.read_bytes())) == 1
    assert os.listdir(tmp_path) == ["file"]


@pytest.mark.parametrize("name", [".file.{}.tmp", ".file.{}-0123abcd.tmp"])
def test_the_next_write_removes_files_of_a_killed_write_but_not_of_a_running_one(tmp_path, name):
    gone = subprocess.Popen([sys.executable, "-c", ""])
    gone.wait()
    (tmp_path / name.format(gone.pid)).write_bytes(b"half")
    (tmp_path / ".other.1.tmp").write_bytes(b"of another file")
    with atomic_write(tmp_path / "file") as outer:
        outer.write(b"outer")
        with atomic_write(tmp_path / "file") as inner:
            inner.write(b"inner")
    assert (tmp_path / "file").read_bytes() == b"outer"
    assert sorted(os.listdir(tmp_path)) == [".other.1.tmp", "file"]


def test_a_kill_in_the_middle_of_writing_leaves_the_old_file_and_no_litter_for_long(tmp_path):
    code = (
        "import os, sys; from heli_gym.storage import atomic_write\n"
        "with atomic_write(sys.argv[1]) as file:\n    file.write(b'half'); file.flush(); os.kill(os.getpid(), 9)"
    )
    path = tmp_path / "file"
    path.write_bytes(b"old")
    assert subprocess.run([sys.executable, "-c", code, str(path)]).returncode == -9
    assert path.read_bytes() == b"old"
    assert len(os.listdir(tmp_path)) == 2
    with atomic_write(path) as file:
        file.write(b"new")
    assert os.listdir(tmp_path) == ["file"]


def test_concurrent_changes_by_processes_and_threads_are_all_stored(tmp_path):
    path = tmp_path / "count"
    context = multiprocessing.get_context("spawn")
    processes = [context.Process(target=writers.count_up, args=(path, 50)) for _ in range(2)]
    for process in processes:
        process.start()
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(writers.count_up, (path, path), (50, 50)))
    for process in processes:
        process.join()
        assert process.exitcode == 0
    assert path.read_text() == "200"
    assert os.listdir(tmp_path) == ["count"]


@pytest.fixture
def on_windows(monkeypatch):
    """The module as it is where there is no fcntl; a lock of msvcrt is one of flock, at the position of the file."""
    places = []

    def locking(descriptor, mode, count):
        places.append(os.lseek(descriptor, 0, os.SEEK_CUR))
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)

    monkeypatch.setitem(sys.modules, "fcntl", None)
    monkeypatch.setitem(sys.modules, "msvcrt", SimpleNamespace(locking=locking, LK_NBLCK=2))
    specification = importlib.util.spec_from_file_location("storage_on_windows", storage.__file__)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    module.places = places
    return module


def test_without_fcntl_a_file_is_locked_once_and_beyond_its_contents(tmp_path, on_windows):
    path = tmp_path / "file"
    with open(path, "wb") as first, open(path, "ab") as second:
        first.write(b"four")
        first.flush()
        assert on_windows.try_lock(first)
        assert not on_windows.try_lock(second)
        first.write(b" more")
    with open(path, "rb") as third:
        assert on_windows.try_lock(third)
        assert third.read() == b"four more"
    assert min(on_windows.places) >= 2**30


def test_without_fcntl_changes_of_threads_are_all_stored_and_files_of_killed_writes_removed(tmp_path, on_windows):
    path = tmp_path / "count"
    path.write_text("0")
    (tmp_path / ".count.1-0123abcd.tmp").write_bytes(b"half")

    def count_up(_):
        with on_windows.locked(path):
            number = int(path.read_text())
            with on_windows.atomic_write(path) as file:
                file.write(str(number + 1).encode())

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(count_up, range(40)))
    assert path.read_text() == "40"
    assert os.listdir(tmp_path) == ["count"]


def test_a_folder_that_cannot_be_written_to_is_refused_before_anything_is_made(tmp_path, monkeypatch):
    check_folder("out", tmp_path / "new" / "folder")
    assert os.listdir(tmp_path) == []
    (tmp_path / "file").write_bytes(b"")
    with pytest.raises(ValueError, match=r"out = .*/x': must be a folder, but .*file' is a file"):
        check_folder("out", tmp_path / "file" / "x")
    (tmp_path / "broken").symlink_to("nowhere/at/all")
    with pytest.raises(ValueError, match=r"out = .*broken/x': must be a folder, but .*broken' is"):
        check_folder("out", tmp_path / "broken" / "x")
    (tmp_path / "loop").symlink_to("loop")
    for unusable in (tmp_path / "loop" / "x", tmp_path / ("x" * 300)):
        with pytest.raises(OSError, match=r"symbolic links|too long"):
            check_folder("out", unusable)
    with pytest.raises(ValueError, match=r"out = 'a.x00b': must be a path"):
        check_folder("out", "a\0b")
    with pytest.raises(OSError) as refusal:
        check_folder("out", "/proc/self/new")
    assert refusal.value.filename == "/proc/self/new"

    def full(*args, **kwargs):
        raise OSError(28, "No space left on device", "/somewhere/else")

    monkeypatch.setattr(tempfile, "TemporaryFile", full)
    with pytest.raises(OSError, match="No space left on device") as refusal:
        check_folder("out", tmp_path / "new")
    assert refusal.value.filename == str(tmp_path / "new")


def test_a_link_is_followed_and_a_device_or_pipe_is_written_to_and_not_replaced(tmp_path):
    (tmp_path / "target").write_bytes(b"old")
    (tmp_path / "link").symlink_to("target")
    with atomic_write(tmp_path / "link") as file:
        file.write(b"new")
    assert (tmp_path / "link").is_symlink() and (tmp_path / "target").read_bytes() == b"new"
    (tmp_path / "loop").symlink_to("loop")
    with pytest.raises(OSError, match="symbolic links"), atomic_write(tmp_path / "loop") as file:
        file.write(b"new")
    os.mkfifo(tmp_path / "pipe")
    with ThreadPoolExecutor(1) as pool:
        read = pool.submit((tmp_path / "pipe").read_bytes)
        with atomic_write(tmp_path / "pipe") as file:
            file.write(b"through")
        assert read.result() == b"through"
    assert (tmp_path / "pipe").is_fifo()
    with pytest.raises(OSError, match=r"No space left.*: '/dev/full'"), atomic_write("/dev/full") as file:
        file.write(b"x" * 10)
    assert os.path.exists("/dev/full") and not os.path.isfile("/dev/full")
    assert sorted(os.listdir(tmp_path)) == ["link", "loop", "pipe", "target"]
