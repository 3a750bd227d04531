#!/usr/bin/env python3
"""Subscribers lose nothing and can hang no run."""

import threading
import unittest

import rospy
import rostest
from gazebo_msgs.srv import GetModelState
from sensor_msgs.msg import LaserScan
from sim2d_process import LONG, Sim2d, car_description
from std_srvs.srv import Empty

SECOND = 1_000_000_000
TOPIC = "/robot1/scan"
MORE_THAN_SOCKETS_HOLD = 100  # s, of scans: 17 MB


class SlowReader:
    """A subscriber of scans that reads nothing until it is told to."""

    def __init__(self):
        self._go = threading.Event()
        self._changed = threading.Condition()
        self.numbers = []
        self._subscriber = rospy.Subscriber(TOPIC, LaserScan, self._read, buff_size=1 << 16)

    def _read(self, scan):
        self._go.wait(LONG)
        with self._changed:
            self.numbers.append(scan.header.seq)
            self._changed.notify_all()

    def read(self):
        self._go.set()

    def wait_for(self, count):
        with self._changed:
            assert self._changed.wait_for(lambda: len(self.numbers) >= count, LONG)

    def wait_until_connected(self):
        while not self._subscriber.get_num_connections():
            self._go.wait(0.01)

    def close(self):
        self.read()
        self._subscriber.unregister()


class SubscribersTest(unittest.TestCase):
    def start(self, **parameters):
        sim2d = Sim2d(car_description(), paused=True, **parameters)
        self.addCleanup(sim2d.kill)
        for name in ("pause", "unpause"):
            rospy.wait_for_service(f"/gazebo/{name}_physics", LONG)
        self._state = rospy.ServiceProxy("/gazebo/get_model_state", GetModelState, persistent=True)
        return sim2d

    def slow_reader(self):
        reader = SlowReader()
        self.addCleanup(reader.close)
        reader.wait_until_connected()
        return reader

    def call(self, name):
        rospy.ServiceProxy(f"/gazebo/{name}_physics", Empty)()

    def now(self):
        return self._state("robot1", "").header.stamp.to_nsec()

    def scans_after(self, seconds):
        """Let a free simulation run for some simulated seconds; return how many scans it has published."""
        self.call("unpause")
        while self.now() <= seconds * SECOND:
            pass
        self.call("pause")
        return self.now() // (SECOND // 40)

    def test_subscriber_that_reads_nothing_hangs_nobody_and_gets_everything_later(self):
        self.start(real_time_factor=0)
        reader = self.slow_reader()
        expected = self.scans_after(MORE_THAN_SOCKETS_HOLD)
        reader.read()
        reader.wait_for(expected)
        assert reader.numbers == list(range(expected))

    def test_nothing_is_lost_with_subscribers_that_keep_up(self):
        self.start(real_time_factor=0)
        reader = self.slow_reader()
        reader.read()
        expected = self.scans_after(10)
        reader.wait_for(expected)
        assert reader.numbers == list(range(expected))

    def test_nothing_is_lost_at_a_pace_while_others_come_and_go(self):
        self.start(real_time_factor=10.0)
        self.call("unpause")
        readers = []
        for _ in range(4):
            reader = self.slow_reader()
            reader.read()
            reader.wait_for(20)
            readers.append(reader)
        readers[1].close()
        readers[0].wait_for(len(readers[0].numbers) + 20)
        for reader in readers:
            first = reader.numbers[0]
            assert reader.numbers == list(range(first, first + len(reader.numbers)))


if __name__ == "__main__":
    rospy.init_node("subscribers_test")
    rostest.rosrun("f1tenth_sim2d", "sim2d_subscribers", SubscribersTest)
