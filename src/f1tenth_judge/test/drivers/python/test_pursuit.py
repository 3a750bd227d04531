"""Pure pursuit where a run knows no ROS 1."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from f1tenth_judge.drivers.python.pursuit import Pursuit
from f1tenth_judge.places.lookup import course_file
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.planner import Observation
from scenario_samples import SCENARIO_TEXT

OBSERVATION = Observation(2.0, None, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0), 0.0, np.zeros((5, 3)))


@pytest.fixture
def pursuit():
    made = Pursuit()
    line = course_file("circuit1", Path.cwd())
    made.reset({"line": str(line), "speed_max": 1.5, "start_at": 1.0})
    return made


def test_it_stands_until_the_start_and_then_keeps_to_the_line(pursuit):
    early = dataclasses.replace(OBSERVATION, time=0.5)
    assert pursuit.plan(early) == (0.0, 0.0)
    speed, steering = pursuit.plan(OBSERVATION)
    assert (speed, abs(steering)) == (1.5, pytest.approx(0.0, abs=1e-3))


@pytest.mark.parametrize("aside", [-0.3, 0.3])
def test_it_steers_back_to_the_line(pursuit, aside):
    _, steering = pursuit.plan(dataclasses.replace(OBSERVATION, pose=(0.0, aside, 0.0)))
    assert np.sign(steering) == -np.sign(aside)


def test_beside_a_planner_without_ros_the_driver_pursuit_is_this_class(tmp_path):
    other = "  - {name: robot2, start: {x: 3, y: 0}, driver: pursuit}\n"
    text = SCENARIO_TEXT.replace("limits:", f"{other}limits:", 1)
    file = tmp_path / "two.yaml"
    file.write_text(text)
    assert make_plan(str(file)).scenario.cars[1].driver.launch
    planner = Path(__file__).with_name("classes.py")
    plan = make_plan(str(file), settings=[f"cars.robot1.driver={{python: '{planner}:Follower'}}"])
    assert plan.scenario.cars[1].driver.python.endswith("pursuit.py:Pursuit")
    assert plan.cars["robot2"].line
    assert not plan.needs_ros
