#!/usr/bin/env python3
"""Driving into a wall: which bumper says so, and how soon `collision` is true."""

import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from gazebo_msgs.msg import ContactsState
from simulator import Collector, Driver, Sim2d, Stepper, car_description
from std_msgs.msg import Bool, UInt32

SECOND = 1_000_000_000
PERIOD = 25_000_000
BUMPER_PERIOD = SECOND // 50
SIDES = ("front", "rear", "left", "right")


class CollisionDetectionTest(unittest.TestCase):
    def start(self, participants=("test",), **place):
        self.stepper = Stepper()
        self.addCleanup(self.stepper.close)
        self.collector = Collector(
            robot1__collision=Bool,
            robot1__collisions=UInt32,
            diagnostics=DiagnosticArray,
            **{f"robot1__bumper_{side}": ContactsState for side in SIDES},
        )
        self.addCleanup(self.collector.close)
        self.driver = Driver("robot1", self.stepper)
        self.addCleanup(self.driver.close)
        self.sim2d = Sim2d(
            car_description(),
            lockstep=True,
            participants=list(participants),
            cars={"robot1": place},
            lockstep_timeout=60.0,
        )
        self.addCleanup(self.sim2d.kill)
        self.collector.wait_until_connected()
        # The first message of a run clears what collision_detection knows of the run before.
        assert self.collector.wait_for(lambda seen: all(seen[f"/robot1/bumper_{side}"] for side in SIDES))
        assert self.collector.wait_for(lambda seen: self.state()[-1:] == [False])

    def state(self):
        return [message.data for message in self.collector.messages["/robot1/collision"]]

    def touched(self, side):
        return [m for m in self.collector.messages[f"/robot1/bumper_{side}"] if m.states]

    def drive_until_collision(self, speed):
        """Drive period by period until `collision` is true; at most 2 s."""
        for end in range(2 * PERIOD, 2 * SECOND, PERIOD):
            self.driver.drive_to(end, linear_x=speed)
            last = end // BUMPER_PERIOD * BUMPER_PERIOD
            assert self.collector.wait_for(
                lambda seen, last=last: all(
                    seen[f"/robot1/bumper_{side}"][-1].header.stamp.to_nsec() >= last for side in SIDES
                )
            )
            if any(self.touched(side) for side in SIDES):
                assert self.collector.wait_for(lambda seen: seen["/robot1/collision"][-1].data)
                return
        raise AssertionError("the car has not touched anything")

    def test_front_bumper_tells_of_the_wall_ahead_within_its_period(self):
        self.start(participants=("robot1", "test"), x=2.5)
        self.drive_until_collision(2.0)
        self.sim2d.stop()
        assert [side for side in SIDES if self.touched(side)] == ["front"]
        contact = self.touched("front")[0]
        first = next(row for row in self.sim2d.record() if row["contacts"])
        assert contact.header.stamp.to_nsec() <= round(float(first["time"]) * SECOND) + BUMPER_PERIOD
        state = contact.states[0]
        assert state.collision1_name == "robot1::bumper_front::bumper_front_collision"
        assert state.collision2_name == "walls::east::collision"
        assert abs(state.contact_positions[0].x - 4.0) < 0.02
        assert state.contact_normals[0].x < -0.99
        assert len(state.wrenches) == len(state.contact_positions) == len(state.depths)
        assert state.total_wrench.force.x < 0.0
        assert self.collector.messages["/robot1/collisions"][-1].data == 1

    def test_rear_bumper_tells_of_the_wall_behind(self):
        self.start(participants=("robot1", "test"), x=-3.5)
        self.drive_until_collision(-1.0)
        assert [side for side in SIDES if self.touched(side)] == ["rear"]

    def test_no_collision_is_said_at_10_hz_while_nothing_touches(self):
        self.start(x=0.0)
        before = len(self.state())
        self.stepper.advance_to(SECOND)
        assert self.collector.wait_for(lambda seen: len(seen["/robot1/collision"]) >= before + 9)
        assert not any(self.state()[before:])

    def test_all_sensors_speak(self):
        self.start(x=0.0)
        for second in range(1, 10):
            self.stepper.advance_to(second * SECOND)
            assert self.collector.wait_for(lambda seen, second=second: self.diagnoses(second * SECOND))
            # The diagnosis may have been made before the node has read what the sensors said.
            if self.diagnoses(second * SECOND)[-1].level == 0:
                return
        raise AssertionError(self.diagnoses(0)[-1])

    def diagnoses(self, since):
        return [
            status
            for message in self.collector.messages["/diagnostics"]
            for status in message.status
            if status.name.endswith("collision_detection: contact sensors")
            and message.header.stamp.to_nsec() >= since
        ]


if __name__ == "__main__":
    rospy.init_node("collision_detection_test")
    rostest.rosrun("f1tenth_gazebo_plugins", "collision_detection", CollisionDetectionTest)
