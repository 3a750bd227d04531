"""Plans for goals up to half a lap away, on the circuits of the workspace and on tracks of others."""

import os
from pathlib import Path

import f1tenth_racer_core as core
import numpy as np
import pytest
import yaml
from PIL import Image

REPOSITORY = Path(__file__).resolve().parents[4]
MAPS = REPOSITORY / "src" / "f1tenth_gazebo" / "maps"
GOALS = REPOSITORY / "src" / "f1tenth_gazebo" / "goals"
DATA = Path(os.environ.get("F1TENTH_DATA", REPOSITORY.parent / "shared" / "data"))
TRACKS = sorted([*(REPOSITORY / "data" / "tracks").iterdir(), *(DATA / "tracks").glob("*")])
CIRCUITS = sorted(path.stem for path in MAPS.glob("*.yaml"))
OPTIONS = {"inflation_radius": 0.55, "cost_scaling_factor": 10.0}


def load_map(path):
    """A costmap of a map in map_server's format."""
    description = yaml.safe_load(path.read_text())
    pixels = np.asarray(Image.open(path.parent / description["image"]).convert("L"), float)
    occupied = (255 - pixels) / 255 > description["occupied_thresh"]
    cells = np.where(occupied, 100, 0).astype(np.int8)[::-1]
    x, y = description["origin"][:2]
    return core.Costmap(
        np.ascontiguousarray(cells),
        description["resolution"],
        origin=(x, y),
        options=core.CostmapOptions(**OPTIONS),
    )


def check(costmap, start, goal):
    """A plan from start to goal, that the car can drive."""
    plan = core.GlobalPlanner().plan(costmap, start, goal)
    assert plan.found
    points = plan.points
    assert points[-1, :2] == pytest.approx(goal[:2], abs=1e-3)
    assert np.abs(points[:, 3]).max() < 1.03 / 0.8
    assert costmap.clearance(points[:, :3]).min() > 0.0
    steps = np.hypot(*np.diff(points[:, :2], axis=0).T)
    assert steps.max() < 0.15
    motion = np.unwrap(np.arctan2(*np.diff(points[:, 1::-1], axis=0).T))
    turn = np.abs(np.diff(motion[steps > 1e-6]))
    assert np.minimum(turn, np.abs(turn - np.pi)).max() < 0.2, "no kinks"
    return plan


def poses_of_goals(name):
    """The goals of a circuit."""
    rows = [line.split() for line in (GOALS / f"{name}.txt").read_text().splitlines()]
    return np.array([[float(value) for value in row] for row in rows if len(row) == 3 and row[0][0] != "#"])


@pytest.mark.parametrize("name", CIRCUITS)
def test_half_a_lap_of_a_circuit_is_planned(name):
    costmap = load_map(MAPS / f"{name}.yaml")
    goals = poses_of_goals(name)
    opposite = np.roll(goals, -(len(goals) // 2), axis=0)
    plans = [check(costmap, start, goal) for start, goal in zip(goals, opposite)]
    # Also where the shortest way leads back from where the car stands.
    assert max(plan.expansions for plan in plans) < 1000


@pytest.mark.parametrize("track", TRACKS, ids=lambda track: track.name)
def test_half_a_lap_of_a_track_is_planned(track):
    costmap = load_map(track / f"{track.name}_map.yaml")
    line = np.loadtxt(track / f"{track.name}_centerline.csv", delimiter=",")[:, :2]
    ahead = np.roll(line, -1, axis=0) - line
    poses = np.column_stack([line, np.arctan2(ahead[:, 1], ahead[:, 0])])
    plan = check(costmap, poses[0], poses[len(poses) // 2])
    length = np.hypot(*ahead.T).sum()
    assert 0.4 * length < plan.points[-1, 4] < 0.6 * length


@pytest.mark.skipif(not CIRCUITS, reason=f"no {MAPS}")
def test_the_same_plan_comes_every_time():
    costmap = load_map(MAPS / "circuit1.yaml")
    goals = poses_of_goals("circuit1")
    first, second = (check(costmap, goals[0], goals[2]).points for _ in range(2))
    assert np.array_equal(first, second)
