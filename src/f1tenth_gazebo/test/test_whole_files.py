"""Maps, worlds and goals are written whole, or the older ones stay."""

import resource

import pytest
from f1tenth_gazebo.whole_files import write_all


@pytest.fixture
def no_space():
    """No file may become longer than 100 bytes: fails as a full disk does, in the middle of a file."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, hard))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def test_all_are_written(tmp_path):
    write_all({tmp_path / "a": b"1", tmp_path / "b": b"2"})
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {"a": b"1", "b": b"2"}


@pytest.mark.usefixtures("no_space")
def test_older_files_stay_whole_when_one_of_the_new_ones_has_no_space(tmp_path):
    (tmp_path / "a").write_bytes(b"old")
    with pytest.raises(OSError, match="File too large") as refused:
        write_all({tmp_path / "a": b"new", tmp_path / "b": b"x" * 1000})
    assert refused.value.filename == str(tmp_path / "b")
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {"a": b"old"}


def test_a_file_that_cannot_be_replaced_is_named(tmp_path):
    (tmp_path / "a").mkdir()
    with pytest.raises(IsADirectoryError) as refused:
        write_all({tmp_path / "a": b"new"})
    assert refused.value.filename == str(tmp_path / "a")
