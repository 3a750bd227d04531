#!/usr/bin/env python3
"""Inputs get lost and come late in exactly their control periods; the test is simulator and planner."""

import queue
import subprocess
import sys
import unittest

import rospy
import rostest
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Header
from tf2_msgs.msg import TFMessage

PATIENCE = 20  # wall s
RIGHT = {"input": "scan", "at": 1.0, "until": 2}
WRONG = (
    None,
    "",
    "all",
    {},
    ["scan"],
    [{"input": "scan", "at": 1.0}],
    [{"at": 1.0, "until": 2}],
    [RIGHT | {"input": "imu"}],
    [RIGHT | {"input": 1}],
    [RIGHT | {"until": 1.0}],
    [RIGHT | {"at": "soon"}],
    [RIGHT | {"delay": "long"}],
    [RIGHT, RIGHT | {"input": "imu"}],
)


class FaultyInputsTest(unittest.TestCase):
    """The launch file says which faults there are."""

    def test_inputs_fail_when_they_are_to(self):
        # Without queues: sent one after the other. Latched: the node may connect later.
        self._clock = rospy.Publisher("/clock", Clock, queue_size=None, latch=True)
        self._done = rospy.Publisher("/sim2d/done", Header, queue_size=None, latch=True)
        scan = rospy.Publisher("scan", LaserScan, queue_size=None, latch=True)
        transform = rospy.Publisher("/tf", TFMessage, queue_size=None, latch=True)
        scans, transforms, self._answers = queue.SimpleQueue(), queue.SimpleQueue(), queue.SimpleQueue()
        rospy.Subscriber("scan_faulty", LaserScan, lambda message: scans.put(message.ranges))
        rospy.Subscriber("tf_faulty", TFMessage, transforms.put)
        rospy.Subscriber("/sim2d/done", Header, self._hear)

        transform.publish(TFMessage())
        scan.publish(LaserScan(ranges=[0.0]))
        # At once, as the planner has not answered yet.
        assert scans.get(timeout=PATIENCE) == (0.0,)
        assert transforms.get(timeout=PATIENCE) == TFMessage()
        self._step(1.0)
        scan.publish(LaserScan(ranges=[1.0]))
        self._step(1.025)
        assert scans.get(timeout=PATIENCE) == (1.0,)

        scan.publish(LaserScan(ranges=[2.0]))
        transform.publish(TFMessage())
        self._step(2.5)
        self._step(2.975)
        assert transforms.empty()
        self._step(3.0)
        assert transforms.get(timeout=PATIENCE) == TFMessage()
        scan.publish(LaserScan(ranges=[3.0]))
        self._step(3.025)
        assert scans.get(timeout=PATIENCE) == (3.0,)

        scan.publish(LaserScan(ranges=[4.0]))
        self._step(4.5)
        self._step(4.975)
        scan.publish(LaserScan(ranges=[5.0]))
        self._step(5.025)
        assert scans.get(timeout=PATIENCE) == (5.0,)

    def test_wrong_parameter_ends_the_node_with_one_line(self):
        command = ["rosrun", "f1tenth_scenarios", "faulty_inputs", "__name:=wrong"]
        for faults in WRONG:
            if faults is not None:  # else it is not set
                rospy.set_param("/wrong/faults", faults)
            done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE, check=False)
            assert done.returncode == 1, faults
            assert done.stderr.startswith("faulty_inputs: ~faults must be a list of {input: odom, ")
            assert done.stderr.count("\n") == 1

    def _step(self, seconds):
        stamp = rospy.Time.from_sec(seconds)
        self._clock.publish(Clock(stamp))
        self._done.publish(Header(stamp=stamp, frame_id="planner"))
        while self._answers.get(timeout=PATIENCE) != stamp:
            pass

    def _hear(self, message):
        if message.frame_id == "faulty_inputs":
            self._answers.put(message.stamp)


if __name__ == "__main__":
    rospy.init_node("faulty_inputs_test")
    rostest.rosrun("f1tenth_scenarios", "faulty_inputs_test", FaultyInputsTest, sys.argv)
