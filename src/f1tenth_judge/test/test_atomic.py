"""Maps, worlds and goals are written whole, or the older ones stay."""

import subprocess
import sys

import pytest
from f1tenth_judge.atomic import write_all

# Its own process: the limit holds for the output of the tests as well.
WITHOUT_SPACE = """
import pathlib, resource, sys
from f1tenth_judge.atomic import write_all
resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
try:
    write_all({pathlib.Path(sys.argv[1]): b"new", pathlib.Path(sys.argv[2]): b"x" * 1000})
except OSError as error:
    sys.exit(f"{error.strerror}: {error.filename}")
"""


def test_all_are_written(tmp_path):
    write_all({tmp_path / "a": b"1", tmp_path / "b": b"2"})
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {"a": b"1", "b": b"2"}


def test_older_files_stay_whole_when_one_of_the_new_ones_has_no_space(tmp_path):
    """A limit of 100 bytes fails as a full disk does: in the middle of a file."""
    (tmp_path / "a").write_bytes(b"old")
    command = [sys.executable, "-c", WITHOUT_SPACE, tmp_path / "a", tmp_path / "b"]
    said = subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False).stderr
    assert said == f"File too large: {tmp_path / 'b'}\n"
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {"a": b"old"}


def test_a_file_that_cannot_be_replaced_is_named(tmp_path):
    (tmp_path / "a").mkdir()
    with pytest.raises(IsADirectoryError) as refused:
        write_all({tmp_path / "a": b"new"})
    assert refused.value.filename == str(tmp_path / "a")
