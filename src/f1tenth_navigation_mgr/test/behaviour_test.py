#!/usr/bin/env python3
"""What NavigationMgr does, seen from outside; one test for the C++ class and for the Python one.

The parameter ~driver says which program to run: both print one line per event.
"""

import os
import subprocess
import sys
import tempfile
import threading

import pytest
import rospy
from mock_move_base import (
    ABORT,
    ABORT_TEXT,
    ACCEPT_LATE,
    DELAY,
    DIE,
    DRIVE,
    DROP,
    FORGET,
    HANG,
    IGNORE,
    LOSE_RESULT,
    REJECT,
    SUCCEED,
    TELL,
    TELL_LAST,
    TELL_NEXT,
)
from rosgraph_msgs.msg import Clock

HERE = os.path.dirname(os.path.abspath(__file__))
DRIVERS = {
    "cpp": ["rosrun", "f1tenth_navigation_mgr", "navigation_mgr_test_driver"],
    "python": [sys.executable, os.path.join(HERE, "navigation_mgr_driver.py")],
}
LIMIT = 120.0  # wall s, against hangs
REACHED = "Goal reached."


class Server:
    """The mock in a process of its own, in a namespace."""

    def __init__(self, robot, *arguments):
        command = [sys.executable, os.path.join(HERE, "mock_move_base.py"), *arguments, f"__ns:=/{robot}"]
        self._process = subprocess.Popen(command)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.kill()
        self._process.wait()


class Driver:
    """A program that runs NavigationMgr; collects its lines."""

    def __init__(self, robot, goals, mode=""):
        command = DRIVERS[rospy.get_param("~driver")] + [robot, goals]
        self._process = subprocess.Popen(command + [mode] * bool(mode), stdout=subprocess.PIPE, text=True)
        self.lines = []
        self._changed = threading.Condition()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.kill()
        self._process.wait()
        self._reader.join()

    def _read(self):
        for line in self._process.stdout:
            with self._changed:
                self.lines.append(line.rstrip("\n"))
                self._changed.notify_all()

    def wait_for_line(self, line, timeout=LIMIT):
        with self._changed:
            return self._changed.wait_for(lambda: line in self.lines, timeout)

    def finish(self):
        code = self._process.wait(LIMIT)
        self._reader.join()
        return code


class Goals:
    """A goals file whose y are orders to the mock; x is the number of the goal."""

    def __init__(self, *behaviours):
        self._lines = [f"{number} {behaviour} 0\n" for number, behaviour in enumerate(behaviours)]

    def __enter__(self):
        self._file = tempfile.NamedTemporaryFile("w", suffix=".txt")
        self._file.writelines(self._lines)
        self._file.flush()
        return self._file.name

    def __exit__(self, *_):
        self._file.close()


class SimulatedTime:
    """Nodes started inside live on /clock, which this publishes when told to."""

    def __enter__(self):
        rospy.set_param("/use_sim_time", True)
        self._publisher = rospy.Publisher("/clock", Clock, latch=True, queue_size=None)
        return self

    def __exit__(self, *_):
        self._publisher.unregister()
        rospy.delete_param("/use_sim_time")

    def publish(self, seconds):
        self._publisher.publish(rospy.Time.from_sec(seconds))


@pytest.fixture(scope="module", autouse=True)
def robot1():
    with Server("robot1"):
        yield


def run_goals(*behaviours, robot="robot1", mode=""):
    with Goals(*behaviours) as goals, Driver(robot, goals, mode) as driver:
        assert driver.finish() == 0
        return driver.lines


def test_reaches_goals_in_order_and_reports_the_empty_queue_once():
    expected = []
    for number in range(3):
        expected += ["sent", f"goal {number} succeeded: {REACHED}", "reached"]
    assert run_goals(SUCCEED, SUCCEED, SUCCEED) == expected + ["queue_empty"]


def test_a_spin_written_with_the_parts_does_the_same():
    goals = (SUCCEED, ABORT, DROP, SUCCEED)
    by_parts, whole = run_goals(*goals, mode="parts"), run_goals(*goals)
    assert [line.split(", sent")[0] for line in by_parts] == [line.split(", sent")[0] for line in whole]
    assert by_parts.count("sent") == len(goals)


def test_an_aborted_goal_carries_the_planners_words_and_leaves_the_queue():
    lines = run_goals(ABORT, SUCCEED)
    assert lines[:3] == ["sent", f"goal 0 aborted: {ABORT_TEXT}", "failed"]
    assert lines[3:] == ["sent", f"goal 1 succeeded: {REACHED}", "reached", "queue_empty"]


def test_a_rejected_goal_has_failed():
    assert run_goals(REJECT) == ["sent", "goal 0 rejected: not that one", "failed", "queue_empty"]


def test_a_dropped_goal_is_sent_again_under_the_same_id():
    lines = run_goals(DROP)
    assert lines[1].startswith("goal 0 succeeded: Goal reached, sent ")
    assert lines[2:] == ["reached", "queue_empty"]


def test_a_slow_goal_is_sent_once():
    lines = run_goals(DELAY)
    assert lines == ["sent", f"goal 0 succeeded: {REACHED}", "reached", "queue_empty"]


def test_a_goal_whose_result_is_lost_ends_as_the_status_says():
    lines = run_goals(LOSE_RESULT)
    assert lines == ["sent", f"goal 0 succeeded: {REACHED}", "reached", "queue_empty"]


def test_a_goal_that_the_server_forgets_is_lost():
    lines = run_goals(FORGET)
    assert lines[1:3] == ["goal 0 lost: /robot1/move_base no longer knows the goal", "failed"]


def test_a_goal_that_the_server_ignores_is_lost():
    lines = run_goals(IGNORE)
    text = "/robot1/move_base took no notice of the goal or its cancellation for 4 s"
    assert lines[1:3] == [f"goal 0 lost: {text}", "failed"]


def test_a_server_that_falls_silent_loses_the_goal():
    lines = run_goals(HANG)
    assert lines[1:3] == ["goal 0 lost: /robot1/move_base has published no status for 4 s", "failed"]


def test_a_server_that_dies_loses_the_goal():
    with Server("mortal"), Goals(DIE) as goals, Driver("mortal", goals) as driver:
        assert driver.wait_for_line("goal 0 lost: /mortal/move_base has been gone for 1 s")


def test_a_cancelled_goal_is_preempted():
    lines = run_goals(DRIVE, SUCCEED, mode="cancel")
    assert lines == ["sent", "goal 0 preempted: cancelled", "failed", "queue_empty"]


def test_a_goal_cancelled_before_it_was_taken_is_preempted_and_not_left_behind():
    lines = run_goals(ACCEPT_LATE, mode="cancel")
    assert lines == ["sent", "goal 0 preempted: cancelled", "failed", "queue_empty"]


def test_loop_mode_starts_over():
    lines = run_goals(SUCCEED, DELAY, mode="loop")
    reached = [line for line in lines if "succeeded" in line]
    assert [line.split()[1] for line in reached[:5]] == ["0", "1", "0", "1", "0"]


def ends_of(lines):
    return [line for line in lines if line.startswith("goal")]


def test_says_of_each_goal_which_ones_follow_it():
    assert ends_of(run_goals(TELL, TELL, TELL)) == [
        "goal 0 succeeded: followed by 1 2",
        "goal 1 succeeded: followed by 2",
        "goal 2 succeeded: the last one",
    ]


def test_a_loop_leads_back_to_the_goal():
    lines = run_goals(TELL, TELL, mode="loop")
    assert ends_of(lines)[:2] == ["goal 0 succeeded: followed by 1 0", "goal 1 succeeded: followed by 0 1"]


def test_says_so_when_a_goal_is_added_behind_the_one_in_flight():
    lines = run_goals(TELL_NEXT, mode="add")
    assert ends_of(lines) == ["goal 0 succeeded: followed by 9", f"goal 9 succeeded: {REACHED}"]


def test_says_so_when_the_goals_behind_the_one_in_flight_are_dropped():
    lines = run_goals(TELL_LAST, SUCCEED, mode="drop")
    assert ends_of(lines) == ["goal 0 succeeded: the last one"]


def test_waits_for_a_server_that_comes_late():
    with Goals(SUCCEED) as goals, Driver("late", goals) as driver:
        assert not driver.wait_for_line("sent", 0.5)
        with Server("late"):
            assert driver.finish() == 0
        assert driver.lines[0] == "sent"


@pytest.mark.parametrize("how", ["miss_first", "refuse_first"])
def test_finds_a_server_that_missed_it_at_first(how):
    with Server(how, how):
        lines = run_goals(SUCCEED, robot=how)
    assert lines == ["sent", f"goal 0 succeeded: {REACHED}", "reached", "queue_empty"]


def test_sends_nothing_before_there_is_a_clock():
    with SimulatedTime() as clock, Goals(SUCCEED) as goals, Driver("robot1", goals) as driver:
        assert not driver.wait_for_line("sent", 1.0)
        clock.publish(10.0)
        assert driver.finish() == 0
        assert f"goal 0 succeeded: {REACHED}" in driver.lines


def test_a_stopped_clock_is_not_silence():
    with (
        SimulatedTime() as clock,
        Server("paused"),
        Goals(HANG) as goals,
        Driver("paused", goals) as driver,
    ):
        clock.publish(10.0)
        assert driver.wait_for_line("sent")
        lost = "goal 0 lost: /paused/move_base has published no status for 4 s"
        assert not driver.wait_for_line(lost, 5.0)
        clock.publish(15.0)
        assert driver.wait_for_line(lost)


def test_a_server_that_dies_while_the_clock_stands_loses_the_goal():
    with SimulatedTime() as clock, Server("brief"), Goals(DIE) as goals, Driver("brief", goals) as driver:
        clock.publish(10.0)
        assert driver.wait_for_line("goal 0 lost: /brief/move_base has been gone for 1 s")


def test_a_wrong_goals_file_is_one_line():
    with Goals(SUCCEED, "east") as goals, Driver("robot1", goals) as driver:
        assert driver.finish() == 2
        assert driver.lines == [f'{goals}:2: y is not a number: "east"']


if __name__ == "__main__":
    rospy.init_node("behaviour_test")
    junit = [a.replace("--gtest_output=xml:", "--junitxml=") for a in sys.argv if "_output=xml:" in a]
    sys.exit(pytest.main([__file__, *junit]))
