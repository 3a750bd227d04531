"""What `make` refuses before it builds anything, and how it ends after a race."""

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def test_race_on_a_circuit_that_is_not_there_is_refused_before_building(tmp_path):
    environment = {key: value for key, value in os.environ.items() if key != "ROS_PACKAGE_PATH"}
    command = ["make", "--no-print-directory", "race", "CIRCUIT=circuit9", f"OUT={tmp_path / 'out'}"]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    message, *_ = done.stderr.splitlines()
    assert message.startswith(
        "CIRCUIT=circuit9: no such file, and no such circuit; there are: circuit1 circuit2 "
    )
    assert done.stdout == ""
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("folder", ["workspace", "work space"])
@pytest.mark.parametrize(("code", "ends"), [(0, 0), (1, 1), (2, 2), (130, 2)])
def test_a_race_ends_as_its_command_does_and_a_verdict_is_no_error_of_make(tmp_path, folder, code, ends):
    workspace = tmp_path / folder
    (workspace / "devel").mkdir(parents=True)
    (workspace / "build").mkdir()
    text = (ROOT / "Makefile").read_text()
    recipes = text.replace("\nbuild: installed", "\nold-build:").replace("\nknown-circuit:", "\nold-circuit:")
    (workspace / "Makefile").write_text(recipes.replace("\nendif\n", "\nknown-circuit build: ;\nendif\n"))
    (workspace / "devel" / "setup.bash").write_text(f"rosrun() {{ echo raced; return {code}; }}\n")
    # As from a shell, also where `make test` runs this.
    environment = {key: value for key, value in os.environ.items() if not key.startswith(("MAKE", "MFLAGS"))}
    environment["XDG_CACHE_HOME"] = str(tmp_path / "cache")
    command = ["make", "race", "PLANNER=a b.launch"]
    done = subprocess.run(
        command, cwd=workspace, env=environment, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout) == (ends, "raced\n")
    assert ("***" in done.stderr) == (ends == 2), done.stderr
