"""The bag of a run: what is recorded from the start, and what is read from it."""

import pytest
import rospy
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_scenarios.launch.bag import recorder_parameters
from f1tenth_scenarios.launch.bag_reader import read_bag
from gazebo_msgs.msg import ModelStates
from geometry_msgs.msg import Pose, PoseStamped
from nav_msgs.msg import Path


def plan(stamp, *points):
    path = Path()
    path.header.stamp = rospy.Time.from_sec(stamp)
    for x, y in points:
        pose = PoseStamped()
        pose.pose.position.x, pose.pose.position.y = x, y
        path.poses.append(pose)
    return path


def turned(x):
    pose = Pose()
    pose.position.x = x
    pose.orientation.z = pose.orientation.w = 0.5**0.5
    return pose


def test_plans_are_those_of_each_car_at_their_own_stamps(bag):
    said = read_bag(
        bag(
            ("/robot1/move_base/global_plan", 1.3, plan(1.25, (0, 0), (2, 0))),
            ("/robot2/move_base/local_plan", 1.4, plan(1.35, (1.23456, 0))),
            ("/robot3/move_base/local_plan", 1.4, plan(1.35, (9, 9))),
        ),
        ["robot1", "robot2"],
    )[0]
    assert {car: (each.stamps, each.values) for car, each in said.global_plans.items()} == {
        "robot1": ([1.25], [[(0.0, 0.0), (2.0, 0.0)]])
    }
    assert {car: (each.stamps, each.values) for car, each in said.local_plans.items()} == {
        "robot2": ([1.35], [[(1.235, 0.0)]])
    }


def test_plans_are_read_at_a_low_rate_and_thinned(bag):
    line = [(index / 100, 0.0) for index in range(1000)]
    messages = [
        ("/robot1/move_base/local_plan", stamp / 20, plan(stamp / 20, *line)) for stamp in range(1, 21)
    ]
    plans = read_bag(bag(*messages), ["robot1"])[0].local_plans["robot1"]
    assert plans.stamps == [0.05, 0.25, 0.45, 0.65, 0.85]
    assert {len(each) for each in plans.values} == {100}


def test_models_are_read_where_they_move_and_cars_are_none(bag):
    def states(heard, x):
        message = ModelStates(name=["robot1", "box"], pose=[Pose(), turned(x)])
        return "/gazebo/model_states", heard, message

    said = read_bag(bag(states(0.1, 3.0), states(0.15, 3.5), states(0.2, 3.0), states(0.3, 4.0)), ["robot1"])[
        0
    ]
    assert set(said.models) == {"box"}
    assert said.models["box"].stamps == [0.1, 0.3]
    assert said.models["box"].values == [(3.0, 0.0, 1.5708), (4.0, 0.0, 1.5708)]


@pytest.mark.parametrize("content", [None, b"nonsense"])
def test_bag_that_cannot_be_read_is_named(tmp_path, content):
    path = tmp_path / "run.bag"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(ScenarioError, match=f"{path}: cannot be read: "):
        read_bag(path, ["robot1"])


def test_recorder_hears_what_rviz_shows_of_each_car(tmp_path):
    topics = set(recorder_parameters(tmp_path / "run.bag", ["robot1", "robot2"])["topics"])
    config = lookup.package_path("f1tenth_navigation") / "rviz" / "two_cars.rviz"
    shown = {
        line.split()[-1] for line in config.read_text(encoding="utf-8").splitlines() if " /robot" in line
    }
    wanted = {
        each
        for each in shown
        if each.rsplit("/", 1)[-1] in ("scan", "perfect_odom", "global_plan", "local_plan")
    }
    assert wanted
    assert wanted <= topics
    assert {"/clock", "/tf", "/tf_static", "/map"} <= topics
