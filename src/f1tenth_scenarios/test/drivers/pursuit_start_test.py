#!/usr/bin/env python3
"""A pure pursuit that is to wait for the start signal drives off when its time and the signal have come."""

import contextlib
import queue
import sys
import time
import unittest

import rospy
import rostest
from ackermann_msgs.msg import AckermannDriveStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Header, Int32

PATIENCE = 20.0  # wall s


class PursuitStartTest(unittest.TestCase):
    """The test is the simulator, and the race starter."""

    def setUp(self):
        self._answers = queue.SimpleQueue()
        rospy.Subscriber("drive", AckermannDriveStamped, self._answers.put)
        # Latched: the node may connect later.
        self._odometry = rospy.Publisher("perfect_odom", Odometry, queue_size=None, latch=True)
        self._scan = rospy.Publisher("scan", LaserScan, queue_size=None, latch=True)
        self._countdown = self._say("/race_starter")

    @staticmethod
    def _say(node):
        """Connections made to this publisher are those of a node."""
        header = {"callerid": node}
        return rospy.Publisher("/time_to_start", Int32, queue_size=None, latch=True, headers=header)

    def test_it_drives_off_after_both(self):
        assert self._speed_at(1.0) == 0.0
        self._countdown.publish(1)
        assert self._speed_at(3.0) == 0.0, "before the signal"
        self._countdown.publish(0)
        assert self._speed_at(1.5) == 0.0, "before its time"
        # The signal takes its time.
        deadline = time.monotonic() + PATIENCE
        period = 4.0
        while not self._speed_at(period):
            assert time.monotonic() < deadline, "no start"
            period += 0.25

    def _speed_at(self, seconds):
        """Its answer to the scan of that time (s), m/s."""
        header = Header(stamp=rospy.Time.from_sec(seconds))
        self._odometry.publish(Odometry(header=header))
        deadline = time.monotonic() + PATIENCE
        while time.monotonic() < deadline:
            # Again and again: its first answers may come before anybody hears them.
            self._scan.publish(LaserScan(header=header))
            with contextlib.suppress(queue.Empty):
                answer = self._answers.get(timeout=0.5)
                if answer.header.stamp == header.stamp:
                    return answer.drive.speed
        raise AssertionError(f"no answer to the scan of {seconds} s")


if __name__ == "__main__":
    rospy.init_node("pursuit_start_test")
    rostest.rosrun("f1tenth_scenarios", "pursuit_start_test", PursuitStartTest, sys.argv)
