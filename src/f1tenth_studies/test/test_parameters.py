"""Parameters of other packages."""

import pytest
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_studies.parameters import read_parameters, read_planner_limits


def test_the_planner_s_limits_are_those_of_its_file():
    assert read_planner_limits()["max_lateral_acceleration"] > 0.0


def test_a_missing_parameter_is_named_with_its_file():
    with pytest.raises(ScenarioError, match=r"teb_local_planner\.yaml: max_vel_y is missing"):
        read_planner_limits()["max_vel_y"]


def test_a_missing_file_is_named():
    with pytest.raises(ScenarioError, match=r"config/none\.yaml: cannot be read: No such file"):
        read_parameters("f1tenth_navigation", "none.yaml")
