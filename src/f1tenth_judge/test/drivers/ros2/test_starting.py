"""What is said where cyclonedds is not installed."""

import sys

import pytest
from f1tenth_judge.drivers.ros2.driver import ros2_drivers
from f1tenth_judge.drivers.ros2.starting import drivers_on_dds
from f1tenth_judge.errors import ScenarioError


def test_planners_are_started_on_dds():
    assert drivers_on_dds() is ros2_drivers


def test_missing_library_is_named_with_its_remedy(monkeypatch):
    monkeypatch.setitem(sys.modules, "cyclonedds.qos", None)
    for name in [each for each in sys.modules if each.startswith("f1tenth_judge.drivers.ros2.")]:
        monkeypatch.delitem(sys.modules, name)
    with pytest.raises(ScenarioError, match=r"need cyclonedds from PyPI .*`pip install 'cyclonedds>=11.0'`"):
        drivers_on_dds()
