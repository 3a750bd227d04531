"""What is known of packages with ROS."""

import f1tenth_scenarios.ros_packages
from f1tenth_judge.places.packages import is_original, package_path
from f1tenth_judge.record.observations import RaceState

from f1tenth_race_mgr.msg import RaceStatus


def test_packages_are_found_where_ros_finds_them():
    assert package_path("rospy") == f1tenth_scenarios.ros_packages.RosPackages().path("rospy")
    assert f1tenth_scenarios.ros_packages.RosPackages().path("no_such_package") is None


def test_the_packages_of_this_workspace_are_standins():
    assert not is_original("amcl")
    assert is_original("f1tenth_scenarios")


def test_states_of_a_race_are_those_of_the_message():
    constants = {name: value for name, value in vars(RaceStatus).items() if name in RaceState.__members__}
    assert {each.name: each.value for each in RaceState} == constants
