#!/usr/bin/env python3
"""Subscribers that do not keep up are waited for, or named; nobody can hang a run."""

import subprocess
import threading
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from gazebo_msgs.srv import GetModelState
from sensor_msgs.msg import LaserScan
from sim2d_process import LONG, Collector, Sim2d, car_description
from std_srvs.srv import Empty

SECOND = 1_000_000_000
TOPIC = "/robot1/scan"
STANDSTILL = 200  # calls of a service between which the simulation does not move


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

    def diagnostics(self):
        collector = Collector(diagnostics=DiagnosticArray)
        self.addCleanup(collector.close)
        collector.wait_until_connected()
        return collector

    def call(self, name):
        rospy.ServiceProxy(f"/gazebo/{name}_physics", Empty)()

    def now(self):
        return self._state("robot1", "").header.stamp.to_nsec()

    def wait_for_standstill(self):
        """Return the simulated time at which the simulation waits."""
        still, before = 0, 0
        while still < STANDSTILL:
            now = self.now()
            still = still + 1 if now == before and now else 0
            before = now
        return before

    def wait_until_after(self, time):
        while self.now() <= time:
            pass

    def wait_for_warning(self, collector, text):
        def is_there(messages):
            return any(
                status.name == "sim2d: subscribers" and status.level == 1 and text in status.message
                for message in messages["/diagnostics"]
                for status in message.status
            )

        assert collector.wait_for(is_there)

    def test_free_simulation_waits_for_a_slow_subscriber_who_gets_everything(self):
        self.start(real_time_factor=0, silent_subscriber_timeout=LONG)
        reader = self.slow_reader()
        self.call("unpause")
        still = self.wait_for_standstill()
        reader.read()
        self.wait_until_after(still + 10 * SECOND)
        self.call("pause")
        expected = self.now() // (SECOND // 40)
        reader.wait_for(expected)
        assert reader.numbers == list(range(expected))

    def test_subscriber_that_reads_nothing_is_named_and_cannot_hang_the_run(self):
        sim2d = self.start(real_time_factor=0, silent_subscriber_timeout=1.5)
        collector = self.diagnostics()
        self.slow_reader()
        self.call("unpause")
        self.wait_until_after(self.wait_for_standstill() + SECOND)
        self.wait_for_warning(collector, f"{rospy.get_name()} ({TOPIC}, no longer waited for)")
        assert sim2d.stop() == 0
        message = (
            f"{rospy.get_name()} has read nothing of {TOPIC} for 1.5 s: the simulation no longer waits for it"
        )
        assert message in sim2d.stderr

    def test_killed_subscriber_cannot_hang_the_run(self):
        self.start(real_time_factor=0, silent_subscriber_timeout=LONG)
        # Nobody reads what it prints, so that it stops reading, too.
        echo = subprocess.Popen(["rostopic", "echo", TOPIC], stdout=subprocess.PIPE)
        self.addCleanup(echo.stdout.close)
        self.call("unpause")
        while not echo.stdout.read(1):
            pass
        still = self.wait_for_standstill()
        echo.kill()
        echo.wait()
        self.wait_until_after(still + SECOND)

    def test_paced_simulation_waits_for_nobody_and_names_who_loses_messages(self):
        sim2d = self.start(real_time_factor=100.0)
        collector = self.diagnostics()
        self.slow_reader()
        self.call("unpause")
        self.wait_for_warning(collector, f"cannot keep up: {rospy.get_name()} ({TOPIC})")
        assert sim2d.stop() == 0
        assert sim2d.result()["lost"] > 0
        assert f"{rospy.get_name()} does not keep up with {TOPIC} and loses messages" in sim2d.stderr

    def test_nothing_is_lost_at_a_pace_while_others_come_and_go(self):
        sim2d = self.start(real_time_factor=10.0)
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
        assert sim2d.stop() == 0
        assert sim2d.result()["lost"] == 0

    def test_nothing_is_lost_with_subscribers_that_keep_up(self):
        sim2d = self.start(real_time_factor=0)
        reader = self.slow_reader()
        reader.read()
        self.call("unpause")
        self.wait_until_after(10 * SECOND)
        self.call("pause")
        expected = self.now() // (SECOND // 40)
        reader.wait_for(expected)
        assert sim2d.stop() == 0
        assert reader.numbers == list(range(expected))
        assert sim2d.result()["published"][TOPIC] == expected
        assert sim2d.result()["lost"] == 0


if __name__ == "__main__":
    rospy.init_node("subscribers_test")
    rostest.rosrun("f1tenth_sim2d", "sim2d_subscribers", SubscribersTest)
