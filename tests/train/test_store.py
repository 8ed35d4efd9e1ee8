"""Storage of studies: folders and object stores behave alike, and bad ones are refused by name."""

import os
import time

import pytest

pytest.importorskip("fsspec")

from heli_gym.train import store as stores
from heli_gym.train.store import Store, scratch_folder


@pytest.fixture(params=["", "file://", "memory://"])
def store(request, tmp_path):
    return Store(f"{request.param}{tmp_path}/study")


def test_files_are_written_listed_read_and_removed(store, tmp_path):
    store.check()
    assert store.names("trials") == []
    assert store.read("trials/a.json") is None
    store.write("trials/b.json", b"2")
    store.write("trials/a.json", b"0")
    store.write("trials/a.json", b"1")
    (tmp_path / "here").write_bytes(b"3" * 100_000)
    store.upload(tmp_path / "here", "trials/deep/c d,e=1")
    assert store.names("trials") == ["trials/a.json", "trials/b.json", "trials/deep/c d,e=1"]
    assert store.read_all("trials") == {
        "trials/a.json": b"1",
        "trials/b.json": b"2",
        "trials/deep/c d,e=1": b"3" * 100_000,
    }
    store.download("trials/deep/c d,e=1", tmp_path / "there")
    assert (tmp_path / "there").read_bytes() == b"3" * 100_000
    store.remove("trials/b.json")
    store.remove("trials/deep")
    store.remove("trials/deep")
    assert store.names("trials") == ["trials/a.json"]


def test_an_unfinished_file_of_a_killed_process_is_not_listed(tmp_path):
    store = Store(str(tmp_path))
    store.write("trials/a.json", b"1")
    (tmp_path / "trials" / ".b.json.1-ff.tmp").write_bytes(b"half")
    assert store.names("trials") == ["trials/a.json"]


def test_a_relative_folder_is_absolute_for_workers(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert Store("out/x").url == str(tmp_path / "out" / "x")


@pytest.mark.parametrize("out", ["nonsense://x", "http+foo://x"])
def test_an_unknown_url_is_refused_by_name(out):
    with pytest.raises(ValueError, match=r"out = .*must be a folder, or a URL"):
        Store(out)


def test_a_folder_that_cannot_be_written_is_refused(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(ValueError, match="out"):
        Store(str(tmp_path / "file" / "x")).check()


def test_a_store_that_cannot_be_written_is_refused(monkeypatch):
    store = Store("memory://full")

    def refuse(*_, **__):
        raise PermissionError("denied")

    monkeypatch.setattr(store.fs, "pipe_file", refuse)
    with pytest.raises(ValueError, match="out = 'memory://full': must be writable: PermissionError: denied"):
        store.check()


def test_scratch_folders_of_killed_processes_are_removed_and_those_in_use_are_not(tmp_path, monkeypatch):
    monkeypatch.setattr(stores, "gettempdir", lambda: str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    old = tmp_path / f"{stores.PREFIX}old"
    old.mkdir()
    (old / "lock").touch()
    os.utime(old, (time.time() - 2 * stores.HOUR,) * 2)
    with scratch_folder() as first:
        os.utime(first.parent, (time.time() - 2 * stores.HOUR,) * 2)
        with scratch_folder() as second:
            assert first.is_dir() and second.is_dir() and first != second
        assert not old.exists() and not second.exists()
    assert os.listdir(tmp_path) == []
