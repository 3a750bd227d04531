"""What is waited for before a planner gets its first scan."""

from f1tenth_judge.drivers.ros2.planner_view import PlannerView


class FakeConnection:
    def __init__(self, processes=0, ends=()):
        self.processes, self.ends = processes, ends

    def participants(self):
        return self.processes

    def subscribed(self):
        return self.ends

    def published(self):
        return []


def missing(*found):
    return PlannerView(FakeConnection(*found), None, lambda: False).missing()


def test_process_and_then_its_topics_are_waited_for():
    assert missing() == {"process"}
    assert missing(1) == {"topics"}
    assert missing(1, ["/scan"]) == set()
