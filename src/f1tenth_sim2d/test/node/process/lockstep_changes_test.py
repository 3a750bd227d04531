#!/usr/bin/env python3
"""Lockstep while time starts again or is paused, and while cars come and go: who is waited for."""

import unittest

import rospy
import rostest
from gazebo_msgs.srv import DeleteModel, SpawnModel
from geometry_msgs.msg import Pose, Twist
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from sim2d_process import LONG, Collector, Sim2d, Stepper, car_description
from std_msgs.msg import Header
from std_srvs.srv import Empty

PERIOD = 25_000_000


def done(periods):
    return Header(frame_id="test", stamp=rospy.Time(0, periods * PERIOD))


class Driver:
    """Answers each scan with one command, up to a period."""

    def __init__(self, last=1000):
        self._last = last
        self._commands = rospy.Publisher("/robot1/cmd_vel", Twist, queue_size=None)
        self._scans = rospy.Subscriber("/robot1/scan", LaserScan, self._answer, tcp_nodelay=True)

    def _answer(self, scan):
        if scan.header.stamp.to_nsec() <= self._last * PERIOD:
            self._commands.publish(Twist())

    def close(self):
        self._scans.unregister()
        self._commands.unregister()


class LockstepChangesTest(unittest.TestCase):
    def start(self, **parameters):
        self.sim2d = Sim2d(car_description(), lockstep=True, **parameters)
        self.addCleanup(self.sim2d.kill)

    def opened(self, kind, *arguments):
        made = kind(*arguments)
        self.addCleanup(made.close)
        return made

    def call(self, name, kind, **fields):
        rospy.wait_for_service("/gazebo/" + name, LONG)
        return rospy.ServiceProxy("/gazebo/" + name, kind)(**fields)

    def spawn(self):
        place = Pose()
        place.position.z = 0.2
        place.orientation.w = 1.0
        answer = self.call(
            "spawn_urdf_model",
            SpawnModel,
            model_name="robot1",
            model_xml=car_description(),
            robot_namespace="robot1",
            initial_pose=place,
        )
        assert answer.success, answer.status_message

    def delete(self):
        assert self.call("delete_model", DeleteModel, model_name="robot1").success

    def collect_clock(self):
        clock = Collector(clock=Clock)
        self.addCleanup(clock.close)
        return clock

    def wait_for_repetitions(self, clock, count, period=1):
        """Wait until the clock, at most at this period, was said so often again, every 0.1 s of wall time."""
        seen = len(clock.messages["/clock"])

        def times():
            return [message.clock.to_nsec() for message in clock.messages["/clock"][seen:]]

        assert clock.wait_for(lambda _: len(times()) >= count or PERIOD * period < max(times(), default=0))
        assert max(times()) <= period * PERIOD

    def test_answer_under_way_when_time_starts_again_does_not_count(self):
        stepper = self.opened(Stepper)
        clock = self.collect_clock()
        answers = rospy.Publisher("/sim2d/done", Header, queue_size=None)
        self.addCleanup(answers.unregister)
        self.start(participants=["test"])
        stepper.advance_to(40 * PERIOD)
        stepper.restart()
        self.call("reset_simulation", Empty)
        self.wait_for_repetitions(clock, 1)
        answers.publish(done(40))
        self.wait_for_repetitions(clock, 3)
        stepper.advance_to(10 * PERIOD)

    def test_answer_of_the_run_before_does_not_count_in_the_next(self):
        latched = rospy.Publisher("/sim2d/done", Header, queue_size=None, latch=True)
        self.addCleanup(latched.unregister)
        latched.publish(done(400))
        clock = self.collect_clock()
        self.start(participants=["test"])
        self.wait_for_repetitions(clock, 4)
        self.opened(Stepper).advance_to(10 * PERIOD)

    def test_participant_that_acts_more_seldom_says_so_in_the_first_period(self):
        clock = self.collect_clock()
        answers = rospy.Publisher("/sim2d/done", Header, queue_size=None)
        self.addCleanup(answers.unregister)
        answering = rospy.Subscriber("/clock", Clock, lambda _: answers.publish(done(20)), tcp_nodelay=True)
        self.addCleanup(answering.unregister)
        self.start(participants=["test"])
        assert clock.wait_for(
            lambda seen: any(message.clock.to_nsec() >= 21 * PERIOD for message in seen["/clock"])
        )

    def test_car_that_was_deleted_is_not_waited_for(self):
        self.opened(Driver, 9)
        stepper = self.opened(Stepper)
        self.start(participants=["robot1", "test"])
        stepper.advance_to(10 * PERIOD)
        self.delete()
        stepper.advance_to(20 * PERIOD)
        stepper.restart()
        self.call("reset_simulation", Empty)
        stepper.advance_to(10 * PERIOD)

    def test_car_that_is_spawned_while_time_waits_for_it_gets_a_scan_to_answer(self):
        self.opened(Driver)
        stepper = self.opened(Stepper)
        self.start(participants=["robot1", "test"], cars={})
        stepper.advance_to(PERIOD)
        self.spawn()
        stepper.advance_to(10 * PERIOD)

    def test_driver_of_a_car_that_comes_again_answers_its_first_scan_however_late_it_connects(self):
        driver = self.opened(Driver)
        stepper = self.opened(Stepper)
        clock = self.collect_clock()
        self.start(participants=["robot1", "test"], lockstep_timeout=2.0)
        stepper.advance_to(10 * PERIOD)
        self.delete()
        driver.close()
        stepper.advance_to(20 * PERIOD)
        self.spawn()
        stepper.leave()
        self.wait_for_repetitions(clock, 25, period=21)
        self.opened(Driver)
        assert clock.wait_for(
            lambda seen: any(message.clock.to_nsec() >= 40 * PERIOD for message in seen["/clock"])
        )

    def test_nobody_falls_silent_while_time_is_paused(self):
        stepper = self.opened(Stepper)
        clock = self.collect_clock()
        self.start(participants=["test"], lockstep_startup_timeout=1.0)
        self.call("pause_physics", Empty)
        self.wait_for_repetitions(clock, 15)
        self.call("unpause_physics", Empty)
        stepper.advance_to(10 * PERIOD)


if __name__ == "__main__":
    rospy.init_node("lockstep_changes_test")
    rostest.rosrun("f1tenth_sim2d", "sim2d_lockstep_changes", LockstepChangesTest)
