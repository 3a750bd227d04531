"""Runs whose planners need no ROS 1: what they cannot do is refused before anything starts."""

import pytest
from f1tenth_judge.errors import NotApplicableError
from f1tenth_judge.plan.planning import make_plan
from scenario_samples import SCENARIO_TEXT

ROS2 = SCENARIO_TEXT.replace("    goals: circuit1", "    driver: {ros2: my_planner}\n    goals: circuit1")


def plan_of(tmp_path, text):
    file = tmp_path / "mine.yaml"
    file.write_text(text, encoding="utf-8")
    return make_plan(str(file))


def test_planner_of_ros2_needs_no_ros(tmp_path):
    plan = plan_of(tmp_path, ROS2)
    assert not plan.needs_ros
    assert plan.driver_folders == {"robot1": tmp_path}
    assert not plan_of(
        tmp_path, ROS2.replace("my_planner", "my_planner, interface: f1tenth_gym_ros")
    ).needs_ros
    assert plan_of(tmp_path, SCENARIO_TEXT).needs_ros


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "limits:",
            "localization: amcl\nlimits:",
            "'localization: amcl' is for planners that are",
        ),
        (
            "    goals",
            "    dropped_beams: 0.5\n    goals",
            "robot1: 'dropped_beams' is for planners",
        ),
        (
            "    goals",
            "    input_faults: [{inputs: [scan], at: 1, until: 2}]\n    goals",
            "robot1: 'input_faults' is for planners that are",
        ),
        (
            "limits:",
            "faults: [{kill: robot1/planner, at: 1}]\nlimits:",
            "'faults' or 'pushes' is for",
        ),
        (
            "limits:",
            "  - {name: robot2, start: {x: 1, y: 0}, driver: commands}\nlimits:",
            "robot2 is driven by a launch file of ROS 1 (commands), and robot1 is not; one run has one kind",
        ),
    ],
)
def test_what_needs_ros_is_refused(tmp_path, old, new, words):
    with pytest.raises(NotApplicableError) as error:
        plan_of(tmp_path, ROS2.replace(old, new, 1))
    assert words in str(error.value)


def test_another_planner_takes_the_place_of_somebody_elses(tmp_path):
    """Where ours drives in no car, and opponents stay."""
    (tmp_path / "other.py").touch()
    opponent = "  - {name: robot2, start: {x: 3, y: 0}, driver: pursuit, speed_max: 1.0}\nlimits:"
    text = ROS2.replace("    goals: circuit1", "    laps: 1").replace("limits:", opponent)
    file = tmp_path / "mine.yaml"
    file.write_text(text, encoding="utf-8")
    plan = make_plan(str(file), settings=[f"planner={{python: '{tmp_path}/other.py:Other'}}"])
    names = [car.driver.name for car in plan.scenario.cars]
    assert names[0] == f"{tmp_path}/other.py:Other"
    assert "pursuit" in names[1]
