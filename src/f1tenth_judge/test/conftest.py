"""Fixtures of several tests; its folder is where the tests below find the samples."""

import pytest
from f1tenth_judge.run import ros
from fake_scenario import program  # noqa: F401


@pytest.fixture(autouse=True)
def planners_of_ros(monkeypatch):
    """Plans with launch files count as such that can be run, wherever the tests are."""
    monkeypatch.setattr(ros, "ros_runner", lambda: "nothing is run here")
