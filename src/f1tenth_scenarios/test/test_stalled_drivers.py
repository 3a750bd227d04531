"""Drivers whose processes stand still for seconds, as on a busy machine: the run is the same."""

import json
import os
import signal
import subprocess
import sys
import threading
import time

import pytest
import yaml
from f1tenth_scenarios.drivers.rest import marked_processes
from patience import PATIENCE

from f1tenth_scenarios import places

PLANNER = places.package_path(places.PACKAGE) / "test" / "planners" / "follow_the_gap.launch"
SCENARIO = {
    "description": "A planner that knows nothing of lockstep behind one that answers each scan.",
    "world": "circuit5",
    "cars": [
        {"name": "robot1", "driver": {"launch": str(PLANNER), "interface": "f1tenth"}, "laps": 1},
        {"name": "robot2", "start": {"x": 3.0, "y": 0.0}, "driver": "pursuit", "speed_max": 1.2},
    ],
    "limits": {"timeout": 5.0, "answer": 60.0},
    "expected": "timeout",
    "seed": 1,
}
# Seconds of wall time: how long a driver runs before it is stopped, and how long it stands then.
AS_IT_LOADS = [(0.0, 5.5)]
AS_IT_CONNECTS_AND_LATER = [(1.0, 1.5), (0.3, 1.5), (1.0, 1.5)]


def stall(mark, stalls):
    """Stop a driver's processes, once they are there."""
    end = time.monotonic() + PATIENCE
    while not (pids := marked_processes(mark)) and time.monotonic() < end:
        time.sleep(0.02)
    for runs, stands in stalls:
        time.sleep(runs)
        for number in (signal.SIGSTOP, signal.SIGCONT):
            for pid in pids:
                os.kill(pid, number)
            time.sleep(stands if number == signal.SIGSTOP else 0)


def trajectory(folder, stalls):
    """Its hash; `stalls` by car."""
    folder.mkdir()
    file = folder / "stalled.yaml"
    file.write_text(yaml.safe_dump(SCENARIO), encoding="utf-8")
    command = [sys.executable, "-m", "f1tenth_scenarios", "run", str(file), "--results", str(folder)]
    for car, each in stalls.items():
        mark = f"F1TENTH_DRIVER={car} of {folder / 'stalled'}"
        threading.Thread(target=stall, args=(mark, each), daemon=True).start()
    done = subprocess.run(command, capture_output=True, text=True, timeout=3 * PATIENCE)
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads((folder / "stalled" / "result.json").read_text(encoding="utf-8"))["trajectory_hash"]


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    return trajectory(tmp_path_factory.mktemp("undisturbed") / "run", {})


@pytest.mark.parametrize(
    "stalls", [{"robot1": AS_IT_LOADS}, {"robot2": AS_IT_CONNECTS_AND_LATER}], ids=["planner", "pursuit"]
)
def test_run_of_a_stalled_driver_is_the_same(tmp_path, undisturbed, stalls):
    assert trajectory(tmp_path / "run", stalls) == undisturbed
