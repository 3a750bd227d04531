"""Who won a race, and by how much."""

from f1tenth_judge.results.standing import Winner, name_of, who, winner_of
from f1tenth_judge.scenario.car import Car
from f1tenth_judge.scenario.driver import Driver


def test_the_first_to_finish_wins_by_its_lead():
    assert winner_of({"robot1": 12.0, "robot2": 10.5}) == Winner("robot2", "robot1", 1.5)


def test_a_car_that_did_not_finish_is_second_to_one_that_did():
    assert winner_of({"robot1": None, "robot2": 10.5}) == Winner("robot2", "robot1", None)


def test_nobody_wins_alone_in_a_tie_or_when_none_finished():
    assert winner_of({"robot1": 10.0}) is None
    assert winner_of({"robot1": 10.0, "robot2": 10.0}) is None
    assert winner_of({"robot1": None, "robot2": None}) is None
    assert winner_of({}) is None


def test_a_planner_is_told_with_its_kind_and_its_car():
    mine = Car("robot1", driver=Driver(python="/robots/gap.py:Gap"), description="truck.urdf")
    assert who(mine) == {
        "planner": "/robots/gap.py:Gap",
        "driver": "Python class",
        "description": "truck.urdf",
    }
    assert name_of(mine) == "robot1 (gap.py:Gap)"
    theirs = Car("robot2", driver=Driver(ros2="ros2 launch a/b.launch.py"))
    assert who(theirs)["driver"] == "command of ROS 2"
    assert name_of(theirs) == "robot2 (ros2 launch a/b.launch.py)"
    assert name_of(Car("robot1")) == "robot1 (race)"
