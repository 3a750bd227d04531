"""What commands write is whole, or what was there before stays."""

import subprocess
import sys

import pytest
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_studies.files import write_text

# Its own process: the limit holds for the output of the tests as well.
WITHOUT_SPACE = """
import pathlib, resource, sys
from f1tenth_studies.files import write_text
resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
write_text(pathlib.Path(sys.argv[1]), "x" * 1000)
"""


def test_what_stands_in_a_file_stays_when_there_is_no_space_for_the_new_text(tmp_path):
    """A limit of 100 bytes fails as a full disk does: in the middle of the file."""
    file = tmp_path / "table.md"
    file.write_text("Remarks of a person.\n", encoding="utf-8")
    command = [sys.executable, "-c", WITHOUT_SPACE, file]
    said = subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False).stderr
    assert said.endswith(f"ScenarioError: {file}: cannot be written: File too large\n")
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {
        "table.md": "Remarks of a person.\n"
    }


def test_a_folder_is_not_replaced_by_a_file(tmp_path):
    with pytest.raises(ScenarioError, match=f"^{tmp_path}: cannot be written: Is a directory$"):
        write_text(tmp_path, "text")
