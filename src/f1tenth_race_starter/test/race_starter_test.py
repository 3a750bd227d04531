#!/usr/bin/env python3
"""The node race_starter, seen from outside."""

import contextlib
import os
import signal
import subprocess
import sys
import threading

import pytest
import rospkg
import rospy
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Header, Int32
from workspace_support.nodes import synchronous_publisher

SCRIPT = rospkg.RosPack().get_path("f1tenth_race_starter") + "/scripts/race_starter"
PATIENCE = 10.0  # wall s, for a node to end by itself
LIMIT = 120.0  # wall s, against hangs
QUIET = 0.5  # wall s in which something must not happen
FAR_FUTURE = 2147483647  # s


class Listener:
    """Collects what a topic says."""

    def __init__(self, topic, message_type, convert):
        self.heard = []
        self._changed = threading.Condition()
        self._convert = convert
        self._subscriber = rospy.Subscriber(topic, message_type, self._on_message)

    def _on_message(self, message):
        with self._changed:
            self.heard.append(self._convert(message))
            self._changed.notify_all()

    def wait_for(self, heard, timeout=LIMIT):
        with self._changed:
            return self._changed.wait_for(lambda: self.heard == heard, timeout)

    def wait_for_one(self, item, timeout=LIMIT):
        with self._changed:
            return self._changed.wait_for(lambda: item in self.heard, timeout)

    def close(self):
        self._subscriber.unregister()


@pytest.fixture
def seconds():
    listener = Listener("/time_to_start", Int32, lambda message: message.data)
    yield listener
    listener.close()


@pytest.fixture
def start():
    """Return a function that starts the node with parameters."""
    processes = []

    def start_node(**parameters):
        rospy.set_param("/race_starter", {"linger": 0.2, **parameters})
        processes.append(subprocess.Popen([sys.executable, SCRIPT], stderr=subprocess.PIPE, text=True))
        return processes[-1]

    yield start_node
    for process in processes:
        # Killed only if it must be: the master would still know it, and tell its port to shut down when the
        # next one comes, whoever has got that port by then.
        process.terminate()
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(PATIENCE)
        process.kill()
        process.communicate()
    rospy.delete_param("/race_starter")


@pytest.fixture
def clock():
    """Return a function that sets simulated time, s."""
    rospy.set_param("/use_sim_time", True)
    publisher = synchronous_publisher("/clock", Clock, latch=True)
    yield lambda time: publisher.publish(rospy.Time.from_sec(time))
    publisher.unregister()
    rospy.delete_param("/use_sim_time")


def test_counts_down_and_ends_with_code_0(start, seconds):
    node = start(time_to_start=2)
    assert node.wait(LIMIT) == 0
    assert seconds.wait_for([2, 1, 0])


def test_counts_in_ros_time_once_there_is_a_clock(start, seconds, clock):
    node = start(time_to_start=2)
    assert not seconds.wait_for_one(2, QUIET)
    for time, heard in ((10.0, [2]), (10.9, [2]), (11.0, [2, 1]), (12.0, [2, 1, 0])):
        clock(time)
        assert seconds.wait_for(heard)
    assert node.wait(LIMIT) == 0


def test_a_late_subscriber_gets_the_start(start, seconds):
    start(time_to_start=0, linger=LIMIT)
    assert seconds.wait_for([0])
    late = Listener("/time_to_start", Int32, lambda message: message.data)
    assert late.wait_for([0])
    late.close()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_ends_when_told_to_while_the_clock_stands(start, seconds, clock, number):
    node = start(time_to_start=2)
    clock(10.0)
    assert seconds.wait_for([2])
    node.send_signal(number)
    _, errors = node.communicate(timeout=LIMIT)
    assert (node.returncode, "Traceback" in errors) == (1, False)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_ends_when_told_to_while_it_waits_for_a_master(number):
    # Port 1: nobody listens there.
    environment = {**os.environ, "ROS_MASTER_URI": "http://localhost:1"}
    pipe = subprocess.PIPE
    command = [sys.executable, "-u", SCRIPT]  # what rospy prints comes at once
    node = subprocess.Popen(command, env=environment, stdout=pipe, stderr=pipe, text=True)
    assert "master may not be running" in node.stdout.readline()
    node.send_signal(number)
    _, errors = node.communicate(timeout=LIMIT)
    assert node.returncode == {signal.SIGINT: 1, signal.SIGTERM: -signal.SIGTERM}[number]
    assert "Traceback" not in errors


def test_a_parameter_that_ros_cannot_carry_is_one_line_and_code_2():
    command = [sys.executable, SCRIPT, "_time_to_start:=99999999999"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT)
    message = "race_starter: a parameter on the command line is too large for ROS\n"
    assert (done.returncode, done.stderr) == (2, message)


@pytest.mark.parametrize("value", [-1, 1.5, "soon"])
def test_a_wrong_parameter_is_one_line_and_code_2(start, value):
    node = start(time_to_start=value)
    _, errors = node.communicate(timeout=LIMIT)
    assert node.returncode == 2
    # rospy itself may warn of those who were just connecting to a node that ends at once.
    assert len([line for line in errors.splitlines() if "[WARN]" not in line]) == 1, errors
    allowed = "a whole number from 0 to 2147483647"
    assert f"/race_starter/time_to_start: found {value!r}, must be {allowed}" in errors


def test_in_lockstep_each_number_is_out_before_the_answer_to_its_period(start, seconds, clock):
    answers = Listener("/sim2d/done", Header, lambda message: (message.frame_id, message.stamp.to_sec()))
    node = start(time_to_start=1, lockstep=True)
    for time, heard in ((0.5, [1]), (1.0, [1]), (1.5, [1, 0])):
        clock(time)
        assert answers.wait_for_one(("race_starter", time))
        assert seconds.wait_for(heard)
    assert answers.wait_for_one(("race_starter", FAR_FUTURE))
    assert node.wait(LIMIT) == 0
    answers.close()


if __name__ == "__main__":
    rospy.init_node("race_starter_test")
    junit = [a.replace("--gtest_output=xml:", "--junitxml=") for a in sys.argv if "_output=xml:" in a]
    sys.exit(pytest.main([__file__, *junit]))
