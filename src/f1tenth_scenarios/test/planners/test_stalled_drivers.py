"""Processes that stand still for seconds, as on a busy machine: the run is the same."""

import json
import os
import signal
import subprocess
import sys
import threading
import time

import psutil
import pytest
import yaml
from f1tenth_judge.drivers.rest import marked_processes
from f1tenth_judge.places import lookup
from patience import PATIENCE

PLANNER = lookup.package_path(lookup.PACKAGE) / "test" / "planners" / "nodes" / "counting.launch"
SCENARIO = {
    "description": "A planner that knows nothing of lockstep behind one that answers each scan.",
    "world": "circuit5",
    "cars": [
        {"name": "robot1", "driver": {"launch": str(PLANNER)}, "laps": 1},
        {"name": "robot2", "start": {"x": 3.0, "y": 0.0}, "driver": "pursuit", "speed_max": 1.2},
    ],
    "limits": {"timeout": 5.0, "answer": 60.0},
    "expected": "timeout",
    "seed": 1,
}
# Seconds of wall time: how long it runs before it is stopped, and how long it stands then.
AS_IT_LOADS = [(0.0, 5.5)]
AS_IT_CONNECTS_AND_LATER = [(1.0, 1.5), (0.3, 1.5), (1.0, 1.5)]
LATER_THAN_THE_DRIVERS = [(0.0, 3.0)]


def processes(folder, who):
    """Those of a run that belong to a car's driver, or the node of this name."""
    if pids := marked_processes(f"F1TENTH_DRIVER={who} of {folder / 'stalled'}"):
        return pids
    run = marked_processes(f"ROS_LOG_DIR={folder / 'stalled' / 'log'}")
    commands = {each.pid: each.info["cmdline"] or () for each in psutil.process_iter(["cmdline"])}
    return {pid for pid in run if f"__name:={who}" in commands.get(pid, ())}


def stall(folder, who, stalls):
    """Stop processes, once they are there."""
    end = time.monotonic() + PATIENCE
    while not (pids := processes(folder, who)) and time.monotonic() < end:
        time.sleep(0.02)
    for runs, stands in stalls:
        time.sleep(runs)
        for number in (signal.SIGSTOP, signal.SIGCONT):
            for pid in pids:
                os.kill(pid, number)
            time.sleep(stands if number == signal.SIGSTOP else 0)


def trajectory(folder, stalls):
    """Its hash; `stalls` by car or node."""
    folder.mkdir()
    file = folder / "stalled.yaml"
    file.write_text(yaml.safe_dump(SCENARIO), encoding="utf-8")
    command = [sys.executable, "-m", "f1tenth_judge", "run", str(file), "--results", str(folder)]
    for who, each in stalls.items():
        threading.Thread(target=stall, args=(folder, who, each), daemon=True).start()
    done = subprocess.run(command, capture_output=True, text=True, timeout=3 * PATIENCE)
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads((folder / "stalled" / "result.json").read_text(encoding="utf-8"))["trajectory_hash"]


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    return trajectory(tmp_path_factory.mktemp("undisturbed") / "run", {})


@pytest.mark.parametrize(
    "stalls",
    [
        {"robot1": AS_IT_LOADS},
        {"robot2": AS_IT_CONNECTS_AND_LATER},
        {"sim2d": LATER_THAN_THE_DRIVERS},
        {"proxy_driver": LATER_THAN_THE_DRIVERS},
    ],
    ids=["planner", "pursuit", "simulator", "proxy_driver"],
)
def test_run_of_who_is_stalled_is_the_same(tmp_path, undisturbed, stalls):
    assert trajectory(tmp_path / "run", stalls) == undisturbed
