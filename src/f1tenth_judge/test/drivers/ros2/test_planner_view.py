"""What is waited for before a planner gets its first scan."""

import pytest
from f1tenth_judge.drivers.ros2.planner_view import PlannerView


class FakeConnection:
    def __init__(self, processes=0, ends=(), is_cyclone=True):
        self.processes, self.ends, self.is_cyclone = processes, ends, is_cyclone

    def is_all_cyclone(self):
        return self.is_cyclone

    def participants(self):
        return self.processes

    def subscribed(self):
        return self.ends

    def published(self):
        return []


def view(*found):
    return PlannerView(FakeConnection(*found), None, lambda: False)


def missing(*found):
    return view(*found).missing()


def test_process_and_then_its_topics_are_waited_for():
    assert missing() == {"process"}
    assert missing(1) == {"topics"}
    assert missing(1, ["/scan"]) == set()


@pytest.mark.parametrize(
    ("processes", "is_cyclone", "time"), [(1, True, 0.3), (2, True, 2.0), (1, False, 2.0), (2, False, 3.5)]
)
def test_what_connects_unseen_has_more_time(processes, is_cyclone, time):
    assert view(processes, [], is_cyclone).connecting() == time
