"""The replay file, and the world around what was heard."""

import gzip
import json
import math
import re
import subprocess

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.record.replay import Poses, Replay, read_replay, write_replay
from f1tenth_judge.record.scene import load_scene
from f1tenth_judge.scenario.car import Pose
from report_samples import replay

WORLD = """<sdf version="1.7"><world name="w">
<model name="wall"><static>1</static><pose>2 0 0 0 0 0</pose><link name="l"><collision name="c"><geometry>
<box><size>1 0.2 2</size></box></geometry></collision></link></model>
<model name="crate"><pose>1 2 0 0 0 1.5707963</pose><link name="l"><collision name="c"><geometry>
<box><size>0.4 0.2 1</size></box></geometry></collision></link></model>
</world></sdf>
"""


@pytest.fixture
def world(tmp_path):
    path = tmp_path / "my.world"
    path.write_text(WORLD, encoding="utf-8")
    return path


def test_file_holds_what_was_written(tmp_path):
    path = tmp_path / "replay.json.gz"
    write_replay(path, replay(2.0))
    first = path.read_bytes()
    back = read_replay(path)
    write_replay(path, back)
    assert path.read_bytes() == first
    assert back.lidars == {"robot1": [-2.35, 2.35, 0.27, 0.0, 0.0, 10.0]}
    assert back.road[1] == pytest.approx([3.0 * math.cos(1 / 9), 3.0 * math.sin(1 / 9)])
    assert len(back.models["box"].shape.outlines[0]) == 4


def test_model_whose_shape_is_not_known_has_none(tmp_path):
    write_replay(tmp_path / "replay.json.gz", Replay(models={"ghost": Poses([0.0], [(1.0, 2.0, 0.0)])}))
    shape = read_replay(tmp_path / "replay.json.gz").models["ghost"].shape
    assert (list(shape.outlines), list(shape.circles)) == ([], [])


def test_what_comes_after_the_end_is_cut():
    cut = replay(5.0).until(0.5)
    assert cut.local_plans["robot1"].stamps == [0.0]
    assert cut.models["box"].values == [(2.0, 2.0, 0.0)]
    assert cut.walls == replay(5.0).walls


def test_missing_file_is_an_empty_replay(tmp_path):
    assert read_replay(tmp_path / "none") == Replay()


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        (b"nonsense", "not a replay: "),
        (gzip.compress(b"nonsense", mtime=0), "not a replay: "),
        (
            gzip.compress(b"nonsense", mtime=0)[:10] + b"\xff" * 20,
            "not a replay: Error -3 while decompressing data",
        ),
        (gzip.compress(b'{"format": NaN}', mtime=0), "not a replay: NaN is not finite"),
        (gzip.compress(b'{"format": 2}', mtime=0), "not a replay: it has no 'walls'"),
        (gzip.compress(b'{"format": 2, "walls": []}', mtime=0), "not a replay: "),
        (gzip.compress(b"[]", mtime=0), "not a replay of format 2; run the scenario again"),
        (
            gzip.compress(json.dumps({"format": 0}).encode(), mtime=0),
            "not a replay of format 2; run the scenario again",
        ),
    ],
)
def test_what_is_no_replay_is_refused(tmp_path, content, problem):
    path = tmp_path / "replay.json.gz"
    path.write_bytes(content)
    with pytest.raises(ScenarioError, match=f"{path}: {problem}"):
        read_replay(path)


def test_walls_and_movable_models_are_told_apart(world):
    made = load_scene(world, {}).with_run({"robot1": (Pose(1.0, 2.0, 3.0),)}, Replay())
    (wall,) = made.walls.outlines
    assert sorted(wall) == [(1.5, -0.1), (1.5, 0.1), (2.5, -0.1), (2.5, 0.1)]
    assert set(made.models) == {"crate"}
    assert sorted(made.models["crate"].shape.outlines[0]) == [
        (-0.2, -0.1),
        (-0.2, 0.1),
        (0.2, -0.1),
        (0.2, 0.1),
    ]
    (pose,) = made.models["crate"].values
    assert pose == pytest.approx((1.0, 2.0, math.pi / 2), abs=1e-6)
    assert made.goals == {"robot1": [(1.0, 2.0, 3.0)]}


def test_models_are_where_they_were_heard_to_be(world):
    said = Replay(models={"crate": Poses([0.0], [(5.0, 5.0, 0.0)]), "wall": Poses([0.0], [(2.0, 0.0, 0.0)])})
    made = load_scene(world, {}).with_run({}, said)
    assert made.models["crate"].values == [(5.0, 5.0, 0.0)]
    assert set(made.models) == {"crate"}


def test_models_of_the_workspace_are_found():
    detailed = lookup.world_file("circuit_detailed", lookup.package_path(lookup.PACKAGE))
    assert len(load_scene(detailed, {}).walls.outlines) > 20


def car_with_lidar(x):
    description = lookup.package_path("f1tenth_description") / "urdf" / "f1tenth.urdf.xacro"
    text = subprocess.run(["xacro", description], capture_output=True, text=True, check=True).stdout
    moved, count = re.subn(
        r'(<joint name="laser_joint".*?<origin[^>]*xyz=")[^ ]+', rf"\g<1>{x}", text, flags=re.S
    )
    assert count == 1
    return moved


def test_each_lidar_is_where_its_car_carries_it(world):
    ahead = car_with_lidar(0.3)
    scene = load_scene(world, {"robot1": ahead, "robot2": ahead, "robot3": car_with_lidar(0.1), "robot4": ""})
    lidars = scene.lidars
    assert {car: round(x, 9) for car, (_, _, x, _, _, _) in lidars.items()} == {
        "robot1": 0.3, "robot2": 0.3, "robot3": 0.1,
    }  # fmt: skip
    assert scene.bodies["robot3"] == pytest.approx((-0.1186, 0.4615, -0.155, 0.155, 0.3302, 0.2), abs=1e-4)
    assert "robot4" not in scene.bodies
    first, last, _, y, yaw, reach = lidars["robot1"]
    assert (last, reach) == pytest.approx((math.radians(135.0), 10.0), abs=0.01)
    assert (first, y, yaw) == pytest.approx((-last, 0.0, 0.0))


def test_world_that_cannot_be_read_leaves_the_walls_out(tmp_path):
    goals = {"robot1": (Pose(1.0, 2.0),)}
    made = load_scene(tmp_path / "none.world", {}).with_run(goals, Replay())
    assert made.walls.outlines == ()
    assert made.goals == {"robot1": [(1.0, 2.0, 0.0)]}
