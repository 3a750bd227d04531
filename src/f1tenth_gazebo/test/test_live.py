"""A running simulation is written down for browsers as its topics have it."""

import math
from pathlib import Path

import pytest
from f1tenth_judge.report.live.feed import Feed, Place
from gazebo_msgs.msg import ModelStates
from geometry_msgs.msg import Pose, Twist

from f1tenth_gazebo import live

PARAMETERS = {
    "/robot1/robot_description": "<robot/>",
    "/robot2/robot_description": "<robot/>",
    "/sim2d/world": "/worlds/mine.world",
}


class FakeServing:
    """In the place of the process that serves."""

    tasks: list = []

    def __init__(self, runs, *_):
        FakeServing.tasks += runs

    def say(self, task):
        FakeServing.tasks.append(task)

    def close(self):
        pass


@pytest.fixture
def shown(tmp_path, monkeypatch):
    monkeypatch.setattr(live, "Serving", FakeServing)
    monkeypatch.setattr(FakeServing, "tasks", [])
    made = live.Live(tmp_path, lambda name: PARAMETERS.get(name, ""))
    yield made
    made.close()


def states(x, yaw=0.0, speed=0.0):
    """A box, and a car that drives where it looks."""
    pose, twist = Pose(), Twist()
    pose.position.x = x
    pose.orientation.z, pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    twist.linear.x, twist.linear.y = speed * math.cos(yaw), speed * math.sin(yaw)
    return ModelStates(["box", "robot1"], [Pose(), pose], [Twist(), twist])


def test_cars_are_shown_where_they_are_and_boxes_are_no_cars(shown):
    shown.take(states(1.0, math.pi / 2, 2.0), 0.1)
    (task,) = FakeServing.tasks
    assert (list(task["descriptions"]), task["world"]) == (["robot1"], "/worlds/mine.world")
    feed = Feed(Path(task["record"]), Path(task["interventions"]))
    feed.poll()
    ((car, rows),) = feed.news(Place())["cars"].items()
    assert car == "robot1"
    assert rows == [[0.1, 1.0, 0.0, pytest.approx(1.5708), 2.0, None, None]]


def test_simulation_that_is_reset_begins_anew(shown):
    shown.take(states(1.0), 5.0)
    (task,) = FakeServing.tasks
    feed, place = Feed(Path(task["record"]), Path(task["interventions"])), Place()
    feed.poll()
    feed.news(place)
    shown.take(states(0.0), 0.1)
    feed.poll()
    news = feed.news(place)
    assert news["begins"]
    assert [row[0] for row in news["cars"]["robot1"]] == [0.1]


def test_car_that_is_spawned_later_is_shown_with_all_that_was_before(shown):
    shown.take(states(1.0), 0.1)
    spawned = states(2.0)
    spawned.name.append("robot2")
    spawned.pose.append(Pose())
    spawned.twist.append(Twist())
    place = Place()
    feed = Feed(Path(FakeServing.tasks[0]["record"]), Path(FakeServing.tasks[0]["interventions"]))
    feed.poll()
    feed.news(place)
    shown.take(spawned, 0.2)
    assert [list(task["descriptions"]) for task in FakeServing.tasks] == [["robot1"], ["robot1", "robot2"]]
    feed.poll()
    news = feed.news(place)
    assert news["begins"]
    assert {car: len(rows) for car, rows in news["cars"].items()} == {"robot1": 2, "robot2": 1}


def test_nothing_is_served_before_there_is_a_car(shown):
    shown.take(ModelStates(["box"], [Pose()], [Twist()]), 0.1)
    assert FakeServing.tasks == []
