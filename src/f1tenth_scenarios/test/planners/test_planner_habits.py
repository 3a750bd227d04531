"""Planners as people write them, none made for lockstep: each has a verdict on a circuit and on two tracks.

A loop with a rate that sleeps first, callbacks that answer every second scan, and two nodes with a timer; and
who waits for the simulated time as roscpp does.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import yaml
from f1tenth_judge.places import lookup
from f1tenth_judge.places.course import read_course
from f1tenth_judge.places.goals import goals_along, goals_text
from patience import PATIENCE

PLANNERS = lookup.package_path(lookup.PACKAGE) / "test" / "planners" / "nodes"
ROOT = Path(__file__).parents[4]
OTHERS = Path(os.environ.get("F1TENTH_DATA", ROOT.parent / "shared" / "data")) / "tracks"
TRACKS = [OTHERS / name for name in ("Oschersleben", "Spielberg") if (OTHERS / name).is_dir()]
GOALS = 10  # on a track: 4 m from one to the next
DRIVERS = {
    "follow_the_gap": {"interface": "f1tenth"},
    "disparity_extender": {},
    "two_nodes": {},
}


def planner(name, course, folder):
    """The two nodes are told a line: not the raceline, which goes closer to walls than they can."""
    arguments = {"arguments": {"line": line_of(course, folder)}} if name == "two_nodes" else {}
    return {"launch": str(PLANNERS / f"{name}.launch"), **DRIVERS[name], **arguments}


def scenario(folder, world, car, timeout=90.0, expected="success"):
    description = {
        "description": "A planner that knows nothing of lockstep.",
        "world": str(world),
        "cars": [{"name": "robot1", **car}],
        "limits": {"timeout": timeout},
        "expected": expected,
        # A planner that looks for room does not keep to the middle.
        "criteria": {"goal_tolerance": 1.5},
        "seed": 1,
    }
    file = folder / "habits.yaml"
    file.write_text(yaml.safe_dump(description), encoding="utf-8")
    return file


def line_of(course, folder):
    """A file as X_centerline.csv, with a point every 0.2 m."""
    x, y = np.append(course.x, course.x[0]), np.append(course.y, course.y[0])
    along = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    places_on_it = np.arange(0.0, along[-1], 0.2)
    rows = zip(np.interp(places_on_it, along, x), np.interp(places_on_it, along, y))
    file = folder / "line_centerline.csv"
    file.write_text("".join(f"{at_x}, {at_y}, 0, 0\n" for at_x, at_y in rows), encoding="utf-8")
    return str(file)


def verdict(file, folder, expected="success"):
    command = [sys.executable, "-m", "f1tenth_judge", "run", str(file), "--results", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=3 * PATIENCE)
    result = json.loads((folder / file.stem / "result.json").read_text(encoding="utf-8"))
    assert result["lockstep"], result["note"]
    assert result["verdict"] == expected, done.stdout
    assert done.returncode == 0
    return result


@pytest.mark.parametrize("name", DRIVERS)
def test_it_drives_a_lap_of_circuit3(tmp_path, name):
    driver = planner(name, read_course(lookup.course_file("circuit3", tmp_path)), tmp_path)
    result = verdict(scenario(tmp_path, "circuit3", {"driver": driver, "laps": 1}), tmp_path)
    assert len(result["cars"]["robot1"]["lap_times"]) == 1


@pytest.mark.parametrize(
    "track", TRACKS or [ROOT / "data" / "tracks" / "hand_drawn"], ids=lambda track: track.name
)
@pytest.mark.parametrize("name", DRIVERS)
def test_it_drives_along_a_track(tmp_path, name, track):
    world = track / f"{track.name}_map.yaml"
    course = read_course(track / f"{track.name}_centerline.csv")
    goals = tmp_path / "goals.txt"
    goals.write_text(goals_text(goals_along(course)[:GOALS]), encoding="utf-8")
    car = {"driver": planner(name, course, tmp_path), "goals": str(goals)}
    result = verdict(scenario(tmp_path, world, car), tmp_path)
    assert len(result["cars"]["robot1"]["goals_passed"]) == GOALS


@pytest.mark.parametrize(
    "driver",
    [
        {"launch": str(PLANNERS / "polling.launch"), "arguments": {"how": "rate"}},
        {"launch": str(PLANNERS / "polling.launch"), "arguments": {"how": "timer"}},
        # Its speed follows the odometry of the same period.
        {"launch": str(PLANNERS / "disparity_extender.launch")},
    ],
    ids=["rate", "timer", "odometry"],
)
def test_it_drives_the_same_again(tmp_path, driver):
    file = scenario(tmp_path, "circuit5", {"driver": driver, "laps": 1}, timeout=3.0, expected="timeout")
    results = [verdict(file, tmp_path / str(run), expected="timeout") for run in range(3)]
    assert len({each["trajectory_hash"] for each in results}) == 1
