import contextlib
import resource

import pytest
from map_server.errors import MapSaveError
from map_server.files import replace_files


@contextlib.contextmanager
def full_disk():
    """Within it files may not grow beyond 10 bytes, the one to which pytest may be writing included."""
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (10, limits[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)


def content(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_writes_all_files_and_nothing_else(tmp_path):
    replace_files({tmp_path / "a": b"1", tmp_path / "b": b"2"})
    assert content(tmp_path) == {"a": b"1", "b": b"2"}


def test_replaces_existing_files(tmp_path):
    (tmp_path / "a").write_bytes(b"old")
    replace_files({tmp_path / "a": b"new"})
    assert content(tmp_path) == {"a": b"new"}


def test_full_disk_leaves_the_old_files_and_no_new_one(tmp_path):
    (tmp_path / "a").write_bytes(b"old")
    with full_disk(), pytest.raises(MapSaveError) as raised:
        replace_files({tmp_path / "a": b"new", tmp_path / "b": b"too much for it"})
    assert str(raised.value) == f"{tmp_path}/b: cannot be written: File too large"
    assert content(tmp_path) == {"a": b"old"}


def test_missing_folder_is_named(tmp_path):
    with pytest.raises(MapSaveError) as raised:
        replace_files({tmp_path / "no" / "a": b"1"})
    assert str(raised.value) == f"{tmp_path}/no/a: cannot be written: No such file or directory"


def test_folder_in_the_place_of_the_second_file_stops_both(tmp_path):
    (tmp_path / "b").mkdir()
    with pytest.raises(MapSaveError) as raised:
        replace_files({tmp_path / "a": b"1", tmp_path / "b": b"2"})
    assert str(raised.value) == f"{tmp_path}/b: cannot be written: Is a directory"
    assert [path.name for path in tmp_path.iterdir()] == ["b"]
