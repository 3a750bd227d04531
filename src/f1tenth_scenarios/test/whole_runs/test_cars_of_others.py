"""A workspace of somebody else's, found by rospack: its own car is judged with its planner, and with ours."""

import json
import os
import subprocess
import sys

import pytest
from f1tenth_judge.places import lookup
from f1tenth_judge.record.files import REPLAY_FILE
from f1tenth_judge.record.replay import read_replay
from patience import PATIENCE

WORKSPACE = lookup.package_path(lookup.PACKAGE) / "test" / "workspace_of_others"


@pytest.fixture
def judged(tmp_path):
    """Runs one of its scenarios; returns what its result.json says."""

    def run(name, *options):
        paths = os.pathsep.join([str(WORKSPACE), os.environ["ROS_PACKAGE_PATH"]])
        command = [
            sys.executable,
            "-m",
            "f1tenth_judge",
            "run",
            name,
            "--results",
            str(tmp_path),
            *options,
        ]
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            env={**os.environ, "ROS_PACKAGE_PATH": paths},
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return json.loads((tmp_path / name / "result.json").read_text(encoding="utf-8"))

    return run


def test_car_with_topics_of_its_own_drives_a_lap(judged, tmp_path):
    result = judged("truck_lap", "--report")
    assert result["verdict"] == "success"
    assert not result["contacts"]
    replay = read_replay(tmp_path / "truck_lap" / REPLAY_FILE)
    assert replay.bodies["robot1"] == pytest.approx([-0.13, 0.57, -0.18, 0.18, 0.42, 0.26])
    assert replay.lidars["robot1"][2:4] == pytest.approx([0.45, 0.0])
    assert replay.lidars["robot1"][5] == 12.0
    assert (tmp_path / "report.html").is_file()


def test_contact_of_a_car_without_bumpers_that_controllers_drive_is_seen(judged):
    result = judged("truck_into_wall")
    assert result["verdict"] == "collision"
    assert [contact["touched"] for contact in result["contacts"]] == [["circuit1"]]


def test_our_planner_drives_a_car_of_others_beside_one_of_ours(judged):
    result = judged("trucks_of_ours")
    assert result["verdict"] == "success"
    assert not result["contacts"]
