"""A file is there whole, or as it was before."""

import multiprocessing
import os

import pytest
import writers

from heli_gym.storage import atomic_write


@pytest.mark.parametrize("kind", [str, lambda path: path], ids=["str", "Path"])
def test_what_is_written_is_there_afterwards_and_folders_are_made(tmp_path, kind):
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
def test_a_failure_leaves_what_was_there_and_no_litter(tmp_path, failure, existing):
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
