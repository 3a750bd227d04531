#!/usr/bin/env python3
"""What NavigationMgr does with servers that keep to the rules of actionlib or break them.

Told through Python, whose class is the C++ one; what a C++ program looks like is tested at the end.
"""

import os
import subprocess
import sys
import tempfile
import threading
import time

import pytest
import rospy
from drive import LIMIT, Drive, Server
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

from f1tenth_navigation_mgr import Goal
from f1tenth_navigation_mgr import SpinResult as Did

REACHED = "Goal reached."
AT_THE_GOAL = ["sent", f"goal 0 succeeded: {REACHED}", "reached", "queue_empty"]


@pytest.fixture(scope="module", autouse=True)
def robot1():
    with Server("robot1"):
        yield


def spin_by_parts(navigation):
    """The thesis's Spin, with its names."""
    if navigation.has_active_goal():
        return navigation.check_goal_state()
    if navigation.size_goals_queue() > 0:
        return navigation.send_goal(navigation.front_goals_queue())
    return navigation.spin()


def test_reaches_goals_in_order_and_reports_the_empty_queue_once():
    expected = []
    for number in range(3):
        expected += ["sent", f"goal {number} succeeded: {REACHED}", "reached"]
    assert Drive(SUCCEED, SUCCEED, SUCCEED).to_the_end() == [*expected, "queue_empty"]


def test_a_spin_written_with_the_parts_does_the_same():
    goals = (SUCCEED, ABORT, SUCCEED)
    assert Drive(*goals, spin=spin_by_parts).to_the_end() == Drive(*goals).to_the_end()


def test_an_aborted_goal_carries_the_planners_words_and_leaves_the_queue():
    events = Drive(ABORT, SUCCEED).to_the_end()
    assert events[:3] == ["sent", f"goal 0 aborted: {ABORT_TEXT}", "failed"]
    assert events[3:] == ["sent", f"goal 1 succeeded: {REACHED}", "reached", "queue_empty"]


def test_a_rejected_goal_has_failed():
    assert Drive(REJECT).to_the_end() == ["sent", "goal 0 rejected: not that one", "failed", "queue_empty"]


def test_a_dropped_goal_is_sent_again_under_the_same_id():
    events = Drive(DROP, resend=0.2).to_the_end()
    assert events[1].startswith("goal 0 succeeded: Goal reached, sent ")
    assert events[2:] == ["reached", "queue_empty"]


def test_a_slow_goal_is_sent_once():
    assert Drive(DELAY).to_the_end() == AT_THE_GOAL


def test_a_goal_whose_result_is_lost_ends_as_the_status_says():
    assert Drive(LOSE_RESULT, result=0.2).to_the_end() == AT_THE_GOAL


def test_a_goal_that_the_server_forgets_is_lost():
    events = Drive(FORGET).to_the_end()
    assert events[1:3] == ["goal 0 lost: /robot1/move_base no longer knows the goal", "failed"]


def test_a_goal_that_the_server_ignores_is_lost():
    events = Drive(IGNORE, acknowledge=0.5).to_the_end()
    text = "/robot1/move_base took no notice of the goal or its cancellation for 0.5 s"
    assert events[1:3] == [f"goal 0 lost: {text}", "failed"]


def test_a_server_that_falls_silent_loses_the_goal():
    events = Drive(HANG, silence=0.5).to_the_end()
    assert events[1:3] == ["goal 0 lost: /robot1/move_base has published no status for 0.5 s", "failed"]


def test_a_stopped_clock_is_not_silence():
    drive = Drive(HANG, silence=0.2)
    now = rospy.Time.now()
    drive.until(Did.SENT, at=(now,))
    end = time.monotonic() + 0.5
    while time.monotonic() < end:
        assert drive.navigation.spin(now) == Did.DRIVING
    drive.until(Did.FAILED, at=(now + rospy.Duration(LIMIT),))
    assert "goal 0 lost: /robot1/move_base has published no status for 0.2 s" in drive.events


def test_a_server_that_dies_loses_the_goal_even_while_the_clock_stands():
    with Server("mortal"):
        drive = Drive(DIE, robot="mortal", disconnect=0.2)
        drive.until(Did.FAILED, at=(rospy.Time.now(),))
        assert drive.events == ["sent", "goal 0 lost: /mortal/move_base has been gone for 0.2 s", "failed"]


@pytest.mark.parametrize("order", [DRIVE, ACCEPT_LATE], ids=["taken", "not_yet_taken"])
def test_a_cancelled_goal_is_preempted_and_not_left_behind(order):
    drive = Drive(order, SUCCEED)
    drive.until(Did.SENT)
    drive.navigation.clear_goals()
    drive.navigation.cancel()
    assert drive.to_the_end() == ["sent", "goal 0 preempted: cancelled", "failed", "queue_empty"]


def test_loop_mode_starts_over():
    drive = Drive(SUCCEED, SUCCEED)
    drive.navigation.loop_mode = True
    for _ in range(5):
        drive.until(Did.REACHED)
    assert [result.goal.x for result in drive.navigation.results] == [0, 1, 0, 1, 0]


def ends_of(events):
    return [event for event in events if event.startswith("goal")]


def test_says_of_each_goal_which_ones_follow_it():
    assert ends_of(Drive(TELL, TELL, TELL).to_the_end()) == [
        "goal 0 succeeded: followed by 1 2",
        "goal 1 succeeded: followed by 2",
        "goal 2 succeeded: the last one",
    ]


def test_a_loop_leads_back_to_the_goal():
    drive = Drive(TELL, TELL)
    drive.navigation.loop_mode = True
    for _ in range(2):
        drive.until(Did.REACHED)
    assert ends_of(drive.events) == ["goal 0 succeeded: followed by 1 0", "goal 1 succeeded: followed by 0 1"]


def test_says_so_when_a_goal_is_added_behind_the_one_in_flight():
    drive = Drive(TELL_NEXT)
    drive.until(Did.SENT)
    drive.navigation.add_goal(Goal(9.0, SUCCEED, 0.0))
    assert ends_of(drive.to_the_end()) == [
        "goal 0 succeeded: followed by 9",
        f"goal 9 succeeded: {REACHED}",
    ]


def test_says_so_when_the_goals_behind_the_one_in_flight_are_dropped():
    drive = Drive(TELL_LAST, SUCCEED)
    drive.until(Did.SENT)
    drive.navigation.clear_goals()
    assert ends_of(drive.to_the_end()) == ["goal 0 succeeded: the last one"]


def test_waits_for_a_server_that_comes_late():
    drive = Drive(SUCCEED, robot="late", reconnect=0.5)
    assert {drive.navigation.spin() for _ in range(20)} == {Did.NOT_CONNECTED}
    with Server("late"):
        assert drive.to_the_end() == AT_THE_GOAL


@pytest.mark.parametrize("how", ["miss_first", "refuse_first"])
def test_finds_a_server_that_missed_it_at_first(how):
    with Server(how, how):
        assert Drive(SUCCEED, robot=how, reconnect=1.0).to_the_end() == AT_THE_GOAL


class Program:
    """The C++ program, on a goals file; collects its lines."""

    def __init__(self, *lines):
        with tempfile.NamedTemporaryFile("w", suffix=".txt", delete=False) as self._file:
            self._file.writelines(f"{line}\n" for line in lines)
        self.path = self._file.name
        command = ["rosrun", "f1tenth_navigation_mgr", "navigation_mgr_program", "robot1", self.path]
        self._process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        self._first = threading.Event()
        self.lines = []
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.kill()
        self._process.wait()
        os.remove(self.path)

    def _read(self):
        for line in self._process.stdout:
            self.lines.append(line.rstrip("\n"))
            self._first.set()

    def says_something(self, timeout):
        return self._first.wait(timeout)

    def finish(self):
        code = self._process.wait(LIMIT)
        self._reader.join()
        return code, self.lines


@pytest.fixture
def clock():
    """The topic /clock, to which nodes that start now look."""
    rospy.set_param("/use_sim_time", True)
    publisher = rospy.Publisher("/clock", Clock, latch=True, queue_size=1)
    yield publisher
    publisher.unregister()
    rospy.delete_param("/use_sim_time")


def test_program_sends_nothing_before_there_is_a_clock(clock):
    with Program(f"0 {SUCCEED} 0", f"1 {ABORT} 0") as program:
        assert not program.says_something(0.5)
        clock.publish(rospy.Time(10))
        assert program.finish() == (0, [f"0 reached: {REACHED}", f"1 failed: {ABORT_TEXT}"])


def test_program_names_a_wrong_goals_file_in_one_line():
    with Program(f"0 {SUCCEED} 0", "1 east 0") as program:
        code, (line,) = program.finish()
        assert code == 2
        assert line.startswith(f"{program.path}:2: ")


if __name__ == "__main__":
    rospy.init_node("behaviour_test")
    junit = [a.replace("--gtest_output=xml:", "--junitxml=") for a in sys.argv if "_output=xml:" in a]
    sys.exit(pytest.main([__file__, *junit]))
