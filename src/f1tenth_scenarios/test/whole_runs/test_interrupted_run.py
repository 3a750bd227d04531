"""A real run that is interrupted ends everything it started, whoever interrupts it."""

import json
import signal
import subprocess
from pathlib import Path

import psutil
import pytest
from patience import PATIENCE, wait_for

SCENARIO = Path(__file__).parents[2] / "scripts" / "scenario"


def processes_of(folder):
    """Those that a run with its results in this folder has started."""
    found = []
    for process in psutil.process_iter():
        try:
            if process.environ().get("ROS_LOG_DIR", "").startswith(str(folder)):
                found.append(process.name())
        except psutil.Error:
            continue
    return found


@pytest.fixture
def driving(tmp_path):
    """A run whose car has begun to move."""
    with subprocess.Popen(
        [SCENARIO, "run", "circuit1", "--results", tmp_path], stdout=subprocess.PIPE
    ) as run:
        record = tmp_path / "circuit1" / "log" / "record.csv"
        wait_for(lambda: run.poll() is not None or (record.exists() and record.read_text().count("\n") > 1))
        yield run
        run.kill()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_run_cleans_up_and_says_so(driving, tmp_path, number):
    assert processes_of(tmp_path)
    driving.send_signal(number)
    assert driving.wait(PATIENCE) == 128 + number
    assert processes_of(tmp_path) == []
    folder = tmp_path / "circuit1"
    assert sorted(path.name for path in folder.iterdir()) == [".lock", "interrupted"]
    result = json.loads((folder / "interrupted" / "result.json").read_text(encoding="utf-8"))
    assert (result["verdict"], result["passed"]) == ("error", False)
    assert result["reason"] == f"runner: was told to stop by {number.name}"


def test_killed_run_takes_its_processes_along(driving, tmp_path):
    driving.kill()
    wait_for(lambda: not processes_of(tmp_path))
    assert not (tmp_path / "circuit1" / "result.json").exists()
