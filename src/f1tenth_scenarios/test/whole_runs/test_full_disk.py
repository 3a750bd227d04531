"""A run whose HOME and TMPDIR are full is judged as any other, and nothing complains in tracebacks."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from f1tenth_judge.places import lookup
from patience import PATIENCE
from result_schema import valid_result

SHIM = Path(__file__).with_name("full_disk.c")
CLASSES = lookup.package_path("f1tenth_judge") / "test" / "drivers" / "python" / "classes.py"


@pytest.fixture(scope="module")
def shim(tmp_path_factory):
    library = tmp_path_factory.mktemp("shim") / "full_disk.so"
    subprocess.run(["cc", "-shared", "-fPIC", "-o", library, SHIM, "-ldl"], check=True)
    return library


@pytest.fixture(params=["empty", "in use"])
def environment(request, tmp_path, shim):
    """In which HOME and TMPDIR are on a disk without space, new or with what earlier runs have left there."""
    full = tmp_path / "full"
    full.mkdir()
    if request.param == "in use":
        (full / ".ros" / "log").mkdir(parents=True)
    rest = {name: value for name, value in os.environ.items() if not name.startswith(("XDG_", "ROS_HOME"))}
    folders = dict.fromkeys(("HOME", "TMPDIR", "FULL_DISK"), str(full))
    return rest | folders | {"LD_PRELOAD": str(shim)}


def test_disk_of_the_test_is_full(environment):
    made = f"open({environment['HOME'] + '/x'!r}, 'w')"
    done = subprocess.run(
        [sys.executable, "-c", made], env=environment, capture_output=True, text=True, check=False
    )
    assert "No space left on device" in done.stderr


@pytest.mark.parametrize(
    "what",
    [["run", "circuit1"], ["race", "circuit1", "--planner", f"{CLASSES}:Follower"]],
    ids=["nodes", "class"],
)
def test_run_with_home_and_temporary_folder_full_is_judged(environment, tmp_path, what):
    results = tmp_path / "results"
    command = [
        sys.executable,
        "-m",
        "f1tenth_judge",
        *what,
        "--set",
        "limits.timeout=2",
        "--results",
        results,
    ]
    done = subprocess.run(
        command, env=environment, capture_output=True, text=True, timeout=PATIENCE, cwd=tmp_path, check=False
    )
    found = [path.parent for path in results.glob("*/result.json")]
    assert len(found) == 1, done.stdout + done.stderr
    (folder,) = found
    result = valid_result(folder / "result.json")
    assert result["verdict"] == "timeout", done.stdout + done.stderr
    assert result["reason"].startswith("not finished after 2 s of simulated time; robot1 drove ")
    logs = [path.read_text(errors="replace") for path in (folder / "log").rglob("*.log")]
    for text in (done.stdout, done.stderr, *logs):
        assert not ("Traceback" in text and "No space left on device" in text), text
