#!/usr/bin/env python3
"""Lockstep: the same run on a busy and on an idle machine, and an end when somebody falls silent."""

import json
import os
import re
import signal
import subprocess
import sys
import threading
import unittest

import rospy
import rostest
from ackermann_msgs.msg import AckermannDriveStamped
from gazebo_msgs.srv import GetModelState
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from sim2d_process import LEFT_NS, LONG, Collector, Sim2d, Stepper, car_description
from std_msgs.msg import Header
from workspace_support.nodes import synchronous_publisher

from sim2d_lockstep import Participant

SECOND = 1_000_000_000
PERIOD = 25_000_000


class Driver:
    """A reactive driver: one command per scan, towards where there is room. It falls silent in the end."""

    def __init__(self, periods):
        self._periods = periods
        self._publisher = rospy.Publisher("/robot1/drive", AckermannDriveStamped, queue_size=10)
        self._subscriber = rospy.Subscriber("/robot1/scan", LaserScan, self._on_scan, tcp_nodelay=True)

    def _on_scan(self, scan):
        if scan.header.stamp.to_nsec() > self._periods * PERIOD:
            return
        left, right = sum(scan.ranges[720:800]), sum(scan.ranges[280:360])
        command = AckermannDriveStamped()
        command.drive.speed = 1.5
        command.drive.steering_angle = max(-0.4, min(0.4, (left - right) * 0.005))
        self._publisher.publish(command)

    def close(self):
        self._subscriber.unregister()
        self._publisher.unregister()


class StumblingDriver:
    """Answers every scan, one of them twice, and leaves later ones out."""

    def __init__(self, twice, left_out):
        self._answers = {twice: 2, **dict.fromkeys(left_out, 0)}
        self._handled = 0
        self._changed = threading.Condition()
        # Without a queue a command is on its way when publish() returns.
        self._publisher = rospy.Publisher("/robot1/drive", AckermannDriveStamped, queue_size=None)
        self._subscriber = rospy.Subscriber("/robot1/scan", LaserScan, self._on_scan, tcp_nodelay=True)

    def _on_scan(self, scan):
        period = scan.header.stamp.to_nsec() // PERIOD
        for _ in range(self._answers.get(period, 1)):
            self._publisher.publish(AckermannDriveStamped())
        with self._changed:
            self._handled = period
            self._changed.notify_all()

    def wait_for(self, period):
        with self._changed:
            assert self._changed.wait_for(lambda: self._handled >= period, LONG)

    def close(self):
        self._subscriber.unregister()
        self._publisher.unregister()


class StampingDriver:
    """Stamps its answers, a period late if it lags; if not, it answers the first scan after the second."""

    def __init__(self, lag=0):
        self._lag = lag
        self._wait = threading.Event()
        self.answered = threading.Event()
        self._publisher = rospy.Publisher("/robot1/drive", AckermannDriveStamped, queue_size=None)
        self._subscriber = rospy.Subscriber("/robot1/scan", LaserScan, self._on_scan, tcp_nodelay=True)

    def _on_scan(self, scan):
        stamp = scan.header.stamp
        if stamp.to_nsec() == 2 * PERIOD and not self._lag:
            self._answer(rospy.Time(0, PERIOD))
            self._wait.wait(LONG)
        self._answer(stamp - rospy.Duration(0, self._lag))
        if stamp.to_nsec() >= 10 * PERIOD:
            self.answered.set()

    def _answer(self, stamp):
        command = AckermannDriveStamped()
        command.header.stamp = stamp
        self._publisher.publish(command)

    def go_on(self):
        self._wait.set()

    def close(self):
        self.go_on()
        self._subscriber.unregister()
        self._publisher.unregister()


def busy_core():
    return subprocess.Popen([sys.executable, "-c", "while True: pass"])


class LockstepTest(unittest.TestCase):
    def start(self, **parameters):
        sim2d = Sim2d(car_description(), lockstep=True, **parameters)
        self.addCleanup(sim2d.kill)
        return sim2d

    def drive(self, periods, **parameters):
        """Return the result of a run that is stopped when the driver has stopped answering."""
        driver = Driver(periods)
        clock = Collector(clock=Clock)
        sim2d = self.start(participants=["robot1"], **parameters)
        end = (periods + 1) * PERIOD
        assert clock.wait_for(lambda seen: any(message.clock.to_nsec() == end for message in seen["/clock"]))
        assert sim2d.stop() == 0, sim2d.stderr
        driver.close()
        clock.close()
        assert sim2d.result()["periods"] == periods + 1
        return sim2d.result()

    def test_same_seed_gives_the_same_run_also_on_a_busy_machine(self):
        idle = self.hashes_of_three_runs()
        loads = [busy_core() for _ in range(os.cpu_count())]
        try:
            busy = self.hashes_of_three_runs()
        finally:
            for load in loads:
                load.kill()
                load.wait()
        assert len(idle | busy) == 1

    def hashes_of_three_runs(self):
        return {self.drive(100)["trajectory_hash"] for _ in range(3)}

    def test_another_seed_gives_another_run(self):
        hashes = {self.drive(40, seed=seed)["trajectory_hash"] for seed in (1, 2)}
        assert len(hashes) == 2

    def test_driver_that_falls_silent_ends_the_run(self):
        driver = Driver(10)
        self.addCleanup(driver.close)
        sim2d = self.start(participants=["robot1"], lockstep_timeout=3.0)
        assert sim2d.wait() == 3
        message = (
            "lockstep: participant robot1 has not answered period 11 (0.275 s of simulated time) within 3 s"
        )
        assert message in sim2d.stderr
        result = sim2d.result()
        assert result["reason"] == "participant_silent"
        assert result["participant"] == "robot1"
        assert result["error"] == message
        assert result["sim_time"] == 0.275
        assert re.fullmatch("[0-9a-f]{64}", result["trajectory_hash"])

    def stumble(self, left_out, periods):
        """Step through a run with a driver that answers the 20th scan twice and leaves later ones out."""
        driver = StumblingDriver(20, left_out)
        self.addCleanup(driver.close)
        stepper = Stepper()
        self.addCleanup(stepper.close)
        sim2d = self.start(participants=["robot1", "test"], lockstep_timeout=4.0)
        for period in range(1, periods):
            stepper.advance_to(period * PERIOD)
            driver.wait_for(period)
        stepper.leave()
        return sim2d

    def test_answer_that_came_too_early_is_taken_for_one_that_is_missing(self):
        sim2d = self.stumble([40], 60)
        assert sim2d.stop() == 0, sim2d.stderr
        assert (
            "an answer of robot1 came too early or late and is taken for that to another scan" in sim2d.stderr
        )
        assert sim2d.result()["stray_answers"] == [{"participant": "robot1", "period": 40, "time": 1.0}]

    def test_one_answer_too_many_does_not_hide_a_driver_that_falls_silent(self):
        sim2d = self.stumble(range(40, 1000), 41)
        assert sim2d.wait() == 3
        assert "participant robot1 has not answered period 41" in sim2d.stderr

    def test_late_answer_to_the_first_scan_does_not_count_for_the_second(self):
        driver = StampingDriver()
        self.addCleanup(driver.close)
        clock = Collector(clock=Clock)
        self.addCleanup(clock.close)
        sim2d = self.start(participants=["robot1"], lockstep_timeout=LONG)
        assert clock.wait_for(lambda seen: any(each.clock.to_nsec() == 2 * PERIOD for each in seen["/clock"]))
        rospy.wait_for_service("/gazebo/get_model_state", LONG)
        state = rospy.ServiceProxy("/gazebo/get_model_state", GetModelState)
        for _ in range(20):
            assert state("robot1", "").success
        assert max(each.clock.to_nsec() for each in clock.messages["/clock"]) == 2 * PERIOD
        driver.go_on()
        assert driver.answered.wait(LONG)
        assert sim2d.stop() == 0, sim2d.stderr
        assert "too early or late" not in sim2d.stderr

    def test_driver_whose_stamps_lag_behind_its_scans_is_waited_for_once(self):
        driver = StampingDriver(lag=PERIOD)
        self.addCleanup(driver.close)
        sim2d = self.start(participants=["robot1"], lockstep_timeout=2.0)
        assert driver.answered.wait(LONG)
        assert sim2d.stop() == 0, sim2d.stderr
        assert sim2d.stderr.count("too early or late") == 1

    def test_driver_answers_a_lidar_that_scans_more_seldom_than_once_a_period(self):
        driver = Driver(40)
        self.addCleanup(driver.close)
        clock = Collector(clock=Clock)
        self.addCleanup(clock.close)
        sim2d = self.start(participants=["robot1"], control_period=0.01)
        assert clock.wait_for(
            lambda seen: any(message.clock.to_nsec() >= SECOND for message in seen["/clock"])
        )
        assert sim2d.stop() == 0, sim2d.stderr

    def test_participant_that_never_comes_ends_the_start(self):
        sim2d = self.start(participants=["robot1/move_base", "robot1/race_mgr"], lockstep_startup_timeout=0.5)
        assert sim2d.wait() == 3
        assert sim2d.result()["participant"] == "robot1/move_base"
        assert (
            "lockstep: participants robot1/move_base, robot1/race_mgr have not answered period 1 "
            "(0.025 s of simulated time) within 0.5 s" in sim2d.stderr
        )

    def test_one_who_has_left_is_not_waited_for(self):
        stepper = Stepper()
        self.addCleanup(stepper.close)
        leaver = Participant("leaver")
        self.start(participants=["leaver", "test"], lockstep_timeout=10.0)
        leaver.leave()
        stepper.advance_to(SECOND)

    def test_nobody_answers_for_another(self):
        stepper = Stepper()
        self.addCleanup(stepper.close)
        answers = synchronous_publisher("/sim2d/done", Header, latch=True)
        self.addCleanup(answers.unregister)
        clock = Collector(clock=Clock)
        self.addCleanup(clock.close)
        sim2d = self.start(participants=["other", "robot1", "test"])
        assert clock.wait_for(lambda messages: messages["/clock"])
        answers.publish(Header(frame_id="robot1", stamp=rospy.Time(0, LEFT_NS)))
        assert clock.wait_for(lambda _: sim2d.interventions_file.read_text().count("\n") == 1)
        answers.publish(Header(frame_id="other", stamp=rospy.Time(0, LEFT_NS)))
        answers.publish(Header(frame_id="other", stamp=rospy.Time(0, LEFT_NS)))
        assert clock.wait_for(lambda _: sim2d.interventions_file.read_text().count("\n") == 2)
        noted = [json.loads(line) for line in sim2d.interventions_file.read_text().splitlines()]
        told = {"time": 0.025, "kind": "sim2d/done", "caller": "/test"}
        assert noted == [{**told, "model": "robot1"}, {**told, "model": "other"}]
        stepper.leave()
        seen = len(clock.messages["/clock"])
        assert clock.wait_for(lambda messages: len(messages["/clock"]) > seen + 2)
        assert {message.clock.to_nsec() for message in clock.messages["/clock"]} == {PERIOD}

    def test_clock_of_a_period_comes_once_and_in_order(self):
        stepper = Stepper()
        self.addCleanup(stepper.close)
        collector = Collector(clock=Clock)
        self.addCleanup(collector.close)
        self.start(participants=["test"])
        stepper.advance_to(SECOND)
        assert collector.wait_for(lambda messages: messages["/clock"][-1].clock.to_nsec() >= SECOND)
        times = [message.clock.to_nsec() for message in collector.messages["/clock"]]
        assert list(dict.fromkeys(times)) == [n * PERIOD for n in range(1, 41)]
        assert times[times.index(2 * PERIOD) :] == sorted(set(times))[1:]

    def test_stop_while_waiting_is_no_error(self):
        stepper = Stepper()
        self.addCleanup(stepper.close)
        sim2d = self.start(participants=["test"])
        stepper.advance_to(4 * PERIOD)
        sim2d.send(signal.SIGTERM)
        assert sim2d.wait() == 0
        assert sim2d.result()["reason"] == "requested"
        assert sim2d.result()["periods"] == 4


if __name__ == "__main__":
    rospy.init_node("lockstep_test")
    rostest.rosrun("f1tenth_sim2d", "sim2d_lockstep", LockstepTest)
