#!/usr/bin/env python3
"""The Python module beside rospy in one process; this test plays the simulator."""

import threading
import unittest

import pytest
import rospy
import rostest
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Header

import sim2d_lockstep

PERIOD_NS = 25_000_000
LEFT_SECS = 2147483647
LONG = 10.0


class Simulator:
    """One /clock per period, then the answers."""

    def __init__(self):
        self._clock = rospy.Publisher("/clock", Clock, queue_size=10)
        self._answers = []
        self._answered = threading.Condition()
        self._subscriber = rospy.Subscriber("/sim2d/done", Header, self._on_done, tcp_nodelay=True)

    def _on_done(self, message):
        with self._answered:
            self._answers.append((message.frame_id, message.stamp))
            self._answered.notify_all()

    def publish_clock_until(self, condition, stamp):
        for _ in range(1000):
            self._clock.publish(stamp)
            result = condition()
            if result is not None:
                return result
        raise AssertionError("nobody listened to /clock")

    def close(self):
        self._clock.unregister()
        self._subscriber.unregister()

    def wait_for(self, answer):
        with self._answered:
            return self._answered.wait_for(lambda: answer in self._answers, LONG)


class PythonModuleTest(unittest.TestCase):
    def start_simulator(self):
        simulator = Simulator()
        self.addCleanup(simulator.close)
        return simulator

    def test_answers_periods(self):
        simulator = self.start_simulator()
        participant = sim2d_lockstep.Participant("robot1/race_mgr")
        for period in range(1, 21):
            stamp = rospy.Time(0, period * PERIOD_NS)
            got = simulator.publish_clock_until(lambda: participant.wait_for_period(0.05), stamp)
            assert got == stamp
            participant.done(got)
            assert simulator.wait_for(("robot1/race_mgr", stamp))

    def test_waiting_lets_other_python_threads_run(self):
        participant = sim2d_lockstep.Participant("patient")
        waiting = threading.Thread(target=participant.wait_for_period, args=(0.5,))
        waiting.start()
        turns = 0
        while waiting.is_alive():
            turns += 1
        assert turns > 1000

    def test_leaving_is_heard(self):
        simulator = self.start_simulator()
        participant = sim2d_lockstep.Participant("leaver")
        participant.leave()
        assert simulator.wait_for(("leaver", rospy.Time(LEFT_SECS, 0)))
        assert participant.wait_for_period(LONG) is None

    def test_answer_reaches_one_who_connects_later(self):
        stamp = rospy.Time(0, PERIOD_NS)
        participant = sim2d_lockstep.Participant("early")
        participant.done(stamp)
        late = self.start_simulator()
        assert late.wait_for(("early", stamp))

    def test_wrong_name_is_a_value_error(self):
        with pytest.raises(ValueError, match='found "/a", expected a node\'s name without the leading slash'):
            sim2d_lockstep.Participant("/a")


if __name__ == "__main__":
    rospy.init_node("python_module_test")
    rostest.rosrun("sim2d_lockstep", "python_module", PythonModuleTest)
