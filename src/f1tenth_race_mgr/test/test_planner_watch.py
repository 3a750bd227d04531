"""A missing planner is named again and again, in wall time."""

import pytest
from f1tenth_race_mgr.planner_watch import PATIENCE, PlannerWatch

from f1tenth_race_mgr import planner_watch


class Navigation:
    action_name = "/robot1/move_base"

    def __init__(self):
        self.is_there = False
        self.timeouts = []

    def wait_for_server(self, timeout):
        self.timeouts.append(timeout)
        return self.is_there


@pytest.fixture
def clock(monkeypatch):
    """Wall time as the test wants it."""
    times = [100.0]
    monkeypatch.setattr(planner_watch.time, "monotonic", lambda: times[0])
    return times


@pytest.fixture
def warnings(monkeypatch):
    said = []
    monkeypatch.setattr(planner_watch.rospy, "logwarn", lambda text, *values: said.append(text % values))
    return said


def test_missing_planner_is_named_after_a_while_and_again_after_as_long(clock, warnings):
    watch = PlannerWatch(Navigation())
    found = []
    for second in range(13):
        clock[0] = 100.0 + second
        assert watch.check() is False
        found.append(len(warnings))
    assert PATIENCE == 5.0
    assert found == [0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2]
    assert set(warnings) == {"waiting for a planner: no action server on /robot1/move_base"}


def test_planner_that_is_there_is_asked_for_no_more(clock, warnings):
    navigation = Navigation()
    watch = PlannerWatch(navigation)
    assert not watch.check()
    navigation.is_there = True
    assert watch.check(0.25)
    clock[0] += 100.0
    assert watch.check(0.5)
    assert navigation.timeouts == [0.0, 0.25]
    assert warnings == []
