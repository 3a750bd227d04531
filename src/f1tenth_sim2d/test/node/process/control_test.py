#!/usr/bin/env python3
"""Paced time, the services of gazebo_ros, the record, and how the node ends."""

import hashlib
import math
import signal
import unittest
from pathlib import Path

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from gazebo_msgs.srv import GetModelState
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sim2d_process import DATA, LONG, WORLD, Collector, Driver, Sim2d, Stepper, car_description
from std_srvs.srv import Empty

SECOND = 1_000_000_000
PERIOD = 25_000_000


def service(name, kind):
    rospy.wait_for_service("/gazebo/" + name, LONG)
    return rospy.ServiceProxy("/gazebo/" + name, kind)


class ControlTest(unittest.TestCase):
    def start(self, description=None, **parameters):
        sim2d = Sim2d(description or car_description(), **parameters)
        self.addCleanup(sim2d.kill)
        return sim2d

    def collect(self, **topics):
        collector = Collector(**topics)
        self.addCleanup(collector.close)
        return collector

    def start_lockstep(self, participants=("test",), **parameters):
        self.stepper = Stepper()
        self.addCleanup(self.stepper.close)
        return self.start(lockstep=True, participants=list(participants), **parameters)

    def wait_for_clock(self, collector, condition):
        assert collector.wait_for(lambda seen: any(condition(m.clock.to_nsec()) for m in seen["/clock"]))

    def test_clock_runs_at_its_rate(self):
        collector = self.collect(clock=Clock)
        self.start(real_time_factor=5.0, clock_rate=100)
        self.wait_for_clock(collector, lambda now: now >= SECOND)
        times = [message.clock.to_nsec() for message in collector.messages["/clock"]]
        steps = {later - earlier for earlier, later in zip(times, times[1:])}
        # Who lags behind gets only the newest times.
        assert min(steps) == SECOND // 100
        assert all(step % (SECOND // 100) == 0 for step in steps)

    def test_paced_time_goes_no_faster_than_told(self):
        collector = self.collect(diagnostics=DiagnosticArray)
        self.start(real_time_factor=4.0)
        assert collector.wait_for(lambda messages: len(messages["/diagnostics"]) >= 3)
        values = {entry.key: entry.value for entry in collector.messages["/diagnostics"][2].status[0].values}
        assert (values["mode"], values["wanted_real_time_factor"]) == ("paced", "4.000")
        assert float(values["real_time_factor"]) < 4.4

    def test_factor_that_cannot_be_reached_is_reported(self):
        collector = self.collect(diagnostics=DiagnosticArray)
        self.start(real_time_factor=1e6)
        assert collector.wait_for(lambda messages: messages["/diagnostics"])
        status = collector.messages["/diagnostics"][0].status[0]
        assert status.level == 1
        assert status.message.endswith("cannot keep up with 1000000.000")

    def test_second_with_a_pause_or_a_restart_tells_nothing_of_the_pace(self):
        collector = self.collect(diagnostics=DiagnosticArray)

        def seconds(seen):
            return [message.header.stamp.secs for message in seen["/diagnostics"]]

        def restart(seen):
            pairs = zip(seconds(seen), seconds(seen)[1:])
            return next((index for index, (last, now) in enumerate(pairs, 1) if now < last), None)

        self.start(real_time_factor=10.0)
        assert collector.wait_for(lambda seen: max(seconds(seen), default=0) > 1)
        service("reset_simulation", Empty)()
        assert collector.wait_for(restart)
        service("pause_physics", Empty)()
        paused_in = math.ceil(service("get_model_state", GetModelState)("robot1", "").header.stamp.to_sec())
        service("unpause_physics", Empty)()
        assert collector.wait_for(lambda seen: seconds(seen)[-1] > paused_in)
        times = [message.status[0] for message in collector.messages["/diagnostics"]]
        restarted = restart(collector.messages)
        for disturbed in (times[restarted], times[restarted + paused_in - 1]):
            assert disturbed.level == 0
            assert disturbed.message == "no real-time factor: time was paused, restarted or told another pace"
        assert times[restarted + paused_in].message.startswith("real-time factor ")

    def test_pause_stops_the_clock_and_unpause_starts_it(self):
        collector = self.collect(clock=Clock)
        self.start(real_time_factor=1.0)
        self.wait_for_clock(collector, lambda now: now > 0)
        service("pause_physics", Empty)()
        state = service("get_model_state", GetModelState)
        paused_at = state("robot1", "").header.stamp
        for _ in range(20):
            assert state("robot1", "").header.stamp == paused_at
        service("unpause_physics", Empty)()
        self.wait_for_clock(collector, lambda now: now > paused_at.to_nsec() + SECOND // 5)

    def test_reset_in_lockstep_repeats_the_run(self):
        sim2d = self.start_lockstep()
        self.stepper.advance_to(40 * PERIOD)
        reset = service("reset_simulation", Empty)
        self.stepper.restart()
        reset()
        self.stepper.advance_to(8 * PERIOD)
        assert sim2d.stop() == 0
        again = self.start_lockstep()
        self.stepper.advance_to(8 * PERIOD)
        assert again.stop() == 0
        assert sim2d.result()["periods"] == again.result()["periods"] == 8
        assert sim2d.result()["trajectory_hash"] == again.result()["trajectory_hash"]
        assert len(sim2d.record()) == 8
        assert sim2d.record() == again.record()

    def test_model_state_of_cars_and_models(self):
        self.start_lockstep(cars={"robot1": {"x": 1.0, "y": -1.0, "yaw": math.pi / 2}})
        state = service("get_model_state", GetModelState)
        car = state("robot1", "")
        assert car.success
        assert (car.pose.position.x, car.pose.position.y) == (1.0, -1.0)
        assert math.isclose(car.pose.orientation.z, math.sqrt(0.5))
        crate = state("crate", "robot1")
        assert crate.success
        assert math.isclose(crate.pose.position.x, -0.5, abs_tol=1e-9)
        assert math.isclose(crate.pose.position.y, 4.0, abs_tol=1e-9)

    def test_unknown_models_are_named(self):
        self.start_lockstep()
        state = service("get_model_state", GetModelState)
        answer = state("robot9", "")
        assert not answer.success
        assert answer.status_message == "GetModelState: model does not exist"
        answer = state("robot1", "table")
        assert not answer.success
        assert answer.status_message == (
            "GetModelState: reference relative_entity_name not found, "
            "did you forget to scope the body by model name?"
        )

    def test_record_has_a_row_a_period_with_the_contacts(self):
        sim2d = self.start_lockstep(participants=["robot1", "test"], cars={"robot1": {"x": 3.0}})
        driver = Driver("robot1", self.stepper)
        self.addCleanup(driver.close)
        driver.drive_to(20 * PERIOD, linear_x=2.0)
        assert sim2d.stop() == 0
        rows = sim2d.record()
        assert [row["time"] for row in rows] == [f"{n * 0.025:.9f}" for n in range(1, 21)]
        assert rows[0]["car"] == "robot1"
        assert rows[0]["contacts"] == ""
        assert float(rows[0]["clearance"]) > 0.3
        touching = [row for row in rows if row["contacts"]]
        assert {row["contacts"] for row in touching} == {"walls"}
        before = rows[rows.index(touching[0]) - 1]
        assert float(touching[0]["contact_speed"]) > 0.8 * float(before["v_x"])
        assert float(before["contact_speed"]) == 0.0
        assert min(float(row["clearance"]) for row in touching) < 0.02
        assert rows[-1]["hash"] == sim2d.result()["trajectory_hash"]

    def test_record_is_complete_when_the_hash_is_said(self):
        sim2d = self.start_lockstep()
        self.stepper.advance_to(20 * PERIOD)
        sim2d.send(signal.SIGINT)
        assert sim2d.read_line().startswith("trajectory hash")
        sim2d.kill()
        assert len(sim2d.record()) == 20

    def test_robot_without_a_vehicle_file_drives_as_its_description_says(self):
        collector = self.collect(robot1__wheel_odom=Odometry)
        description = (DATA / "two_wheels.urdf").read_text()
        sim2d = self.start_lockstep(participants=["robot1", "test"], description=description)
        driver = Driver("robot1", self.stepper)
        self.addCleanup(driver.close)
        driver.drive_to(40 * PERIOD, linear_x=0.0, angular_z=1.0)
        driver.drive_to(80 * PERIOD, linear_x=3.0)
        assert collector.wait_for(
            lambda seen: (
                seen["/robot1/wheel_odom"][-1:]
                and seen["/robot1/wheel_odom"][-1].header.stamp.to_nsec() == 80 * PERIOD
            )
        )
        odometry = collector.messages["/robot1/wheel_odom"][-1]
        assert (odometry.header.frame_id, odometry.child_frame_id) == ("robot1/odom", "robot1/base_footprint")
        assert abs(odometry.twist.twist.linear.x - 1.0) < 0.1
        assert sim2d.stop() == 0
        turned, driven = sim2d.record()[39], sim2d.record()[79]
        assert float(turned["yaw_rate"]) == 1.0
        assert math.hypot(float(turned["x"]), float(turned["y"])) < 1e-6
        assert math.isclose(float(driven["v_x"]), 20 * 0.05)

    def test_interrupt_ends_with_result_and_hash(self):
        collector = self.collect(clock=Clock)
        sim2d = self.start(real_time_factor=0, seed=5)
        self.wait_for_clock(collector, lambda now: now >= SECOND)
        sim2d.send(signal.SIGINT)
        assert sim2d.wait() == 0
        result = sim2d.result()
        assert (result["reason"], result["error"], result["seed"]) == ("requested", "", 5)
        assert result["sim_time"] >= 1.0
        assert result["physics_step"] == 0.001
        assert result["world_sha256"] == hashlib.sha256(Path(WORLD).read_bytes()).hexdigest()
        assert result["cars_sha256"] == {"robot1": hashlib.sha256(car_description().encode()).hexdigest()}
        assert f"trajectory hash {result['trajectory_hash']}" in sim2d.stdout

    def test_interrupt_ends_with_the_period_under_way(self):
        collector = self.collect(clock=Clock)
        sim2d = self.start(real_time_factor=0.1, control_period=0.5)
        self.wait_for_clock(collector, lambda now: now > 10 * PERIOD)
        assert sim2d.stop() == 0, sim2d.stderr
        result = sim2d.result()
        assert result["sim_time"] == result["periods"] * 0.5 == float(sim2d.record()[-1]["time"])


if __name__ == "__main__":
    rospy.init_node("control_test")
    rostest.rosrun("f1tenth_sim2d", "sim2d_control", ControlTest)
