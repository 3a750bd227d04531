#!/usr/bin/env python3
"""The plugin in the simulator: its rate, its exactness, its transform, its errors."""

import math
import unittest

import rospy
import rostest
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Odometry
from simulator import Collector, Driver, Sim2d, Stepper, car_description, perfect_odometry
from tf2_msgs.msg import TFMessage

SECOND = 1_000_000_000
PERIOD = 25_000_000
TOPIC = "/robot1/perfect_odom"


class PerfectOdometryTest(unittest.TestCase):
    def start(self, description, participants=("test",), **parameters):
        self.stepper = Stepper()
        self.addCleanup(self.stepper.close)
        self.collector = Collector(robot1__perfect_odom=Odometry, tf=TFMessage)
        self.addCleanup(self.collector.close)
        self.sim2d = Sim2d(description, lockstep=True, participants=list(participants), **parameters)
        self.addCleanup(self.sim2d.kill)

    def run_until(self, end):
        self.collector.wait_until_connected()
        assert self.collector.wait_for(lambda seen: seen[TOPIC])
        self.stepper.advance_to(end)
        assert self.collector.wait_for(lambda seen: seen[TOPIC][-1].header.stamp.to_nsec() >= end)

    def test_200_hz_with_stamps_at_exact_multiples(self):
        self.start(car_description(perfect_odometry()))
        self.run_until(SECOND)
        stamps = [message.header.stamp.to_nsec() for message in self.collector.messages[TOPIC]]
        assert stamps == sorted(stamps)
        # Who connects during the first period gets its last message, again and again.
        assert stamps[0] <= PERIOD
        assert list(dict.fromkeys(stamps)) == list(range(stamps[0], SECOND + 1, SECOND // 200))

    def test_pose_and_twist_are_the_simulators_own_state(self):
        self.start(
            car_description(perfect_odometry()),
            participants=("robot1", "test"),
            cars={"robot1": {"x": -1.0, "y": -0.5, "yaw": 0.3}},
        )
        assert self.collector.wait_for(lambda seen: seen[TOPIC])
        driver = Driver("robot1", self.stepper)
        self.addCleanup(driver.close)
        driver.drive_to(SECOND, linear_x=1.0, angular_z=0.6)
        assert self.collector.wait_for(lambda seen: seen[TOPIC][-1].header.stamp.to_nsec() == SECOND)
        self.sim2d.stop()
        messages = {message.header.stamp.to_nsec(): message for message in self.collector.messages[TOPIC]}
        rows = self.sim2d.record()
        assert len(rows) == 40
        assert float(rows[-1]["x"]) > -0.9
        for row in rows:
            message = messages[round(float(row["time"]) * SECOND)]
            pose, twist = message.pose.pose, message.twist.twist
            yaw = 2.0 * math.atan2(pose.orientation.z, pose.orientation.w)
            found = (pose.position.x, pose.position.y, yaw, twist.linear.x, twist.linear.y, twist.angular.z)
            expected = [float(row[key]) for key in ("x", "y", "yaw", "v_x", "v_y", "yaw_rate")]
            for actual, exact in zip(found, expected):
                assert abs(actual - exact) < 1e-9

    def test_frames_carry_the_prefix_and_the_transform_is_there(self):
        self.start(car_description(perfect_odometry()))
        self.run_until(SECOND // 5)
        message = self.collector.messages[TOPIC][-1]
        assert (message.header.frame_id, message.child_frame_id) == ("robot1/odom", "robot1/base_footprint")
        assert self.collector.wait_for(
            lambda seen: any(
                t.header.stamp == message.header.stamp for m in seen["/tf"] for t in m.transforms
            )
        )
        transforms = [transform for m in self.collector.messages["/tf"] for transform in m.transforms]
        assert {(t.header.frame_id, t.child_frame_id) for t in transforms} == {
            ("robot1/odom", "robot1/base_footprint")
        }

    def test_pose_and_twist_are_those_of_a_base_footprint_before_the_rear_axle(self):
        ahead = 0.1651
        joint = '<parent link="base_footprint"/><child link="rear_axle"/><origin xyz="-0.1651 0 0.02"/>'
        description = car_description(perfect_odometry()).replace('"base_footprint"', '"rear_axle"')
        base = f'<link name="base_footprint"/><joint name="base_joint" type="fixed">{joint}</joint></robot>'
        self.start(
            description.replace("</robot>", base),
            participants=("robot1", "test"),
            cars={"robot1": {"x": -1.0, "y": -0.5, "yaw": 0.3}},
        )
        assert self.collector.wait_for(lambda seen: seen[TOPIC] and seen["/tf"])
        driver = Driver("robot1", self.stepper)
        self.addCleanup(driver.close)
        driver.drive_to(SECOND, linear_x=1.0, angular_z=0.6)
        assert self.collector.wait_for(lambda seen: seen[TOPIC][-1].header.stamp.to_nsec() == SECOND)
        self.sim2d.stop()
        record = self.sim2d.record()[-1]
        row = {key: float(record[key]) for key in ("x", "y", "yaw", "v_y", "yaw_rate")}
        message = self.collector.messages[TOPIC][-1]
        position, twist = message.pose.pose.position, message.twist.twist
        assert abs(row["yaw_rate"]) > 0.1
        assert abs(position.x - row["x"] - ahead * math.cos(row["yaw"])) < 1e-9
        assert abs(position.y - row["y"] - ahead * math.sin(row["yaw"])) < 1e-9
        assert abs(position.z + 0.02) < 1e-9
        assert abs(twist.linear.y - row["v_y"] - ahead * row["yaw_rate"]) < 1e-9
        transform = self.collector.messages["/tf"][-1].transforms[0]
        assert transform.child_frame_id == "robot1/base_footprint"
        assert transform.transform.translation.z == position.z

    def test_link_that_stands_for_the_car_need_not_be_a_base_footprint(self):
        description = car_description(perfect_odometry(robotBaseFrame="base_link"))
        self.start(description.replace('"base_footprint"', '"base_link"'))
        self.run_until(SECOND // 5)
        assert self.collector.messages[TOPIC][-1].child_frame_id == "robot1/base_link"
        transforms = [transform for m in self.collector.messages["/tf"] for transform in m.transforms]
        assert {t.child_frame_id for t in transforms} == {"robot1/base_link"}

    def test_tags_change_topic_rate_and_frame(self):
        self.start(
            car_description(perfect_odometry(odometryTopic="truth", updateRate="50", odometryFrame="origin"))
        )
        truth = Collector(robot1__truth=Odometry)
        self.addCleanup(truth.close)
        assert truth.wait_for(lambda seen: seen["/robot1/truth"])
        self.stepper.advance_to(SECOND)
        assert truth.wait_for(lambda seen: seen["/robot1/truth"][-1].header.stamp.to_nsec() == SECOND)
        stamps = dict.fromkeys(message.header.stamp.to_nsec() for message in truth.messages["/robot1/truth"])
        assert list(stamps) == [n * SECOND // 50 for n in range(1, 51)]
        assert truth.messages["/robot1/truth"][0].header.frame_id == "robot1/origin"

    def test_pose_alone_is_published_in_the_map_if_it_has_a_topic(self):
        self.start(car_description(perfect_odometry(poseTopic="gt_pose", updateRate="50")))
        truth = Collector(robot1__gt_pose=PoseStamped)
        self.addCleanup(truth.close)
        assert truth.wait_for(lambda seen: seen["/robot1/gt_pose"])
        self.run_until(SECOND)
        assert truth.wait_for(lambda seen: seen["/robot1/gt_pose"][-1].header.stamp.to_nsec() == SECOND)
        pose = truth.messages["/robot1/gt_pose"][-1]
        odometry = self.collector.messages[TOPIC][-1]
        assert pose.header.frame_id == "map"
        assert (pose.header.stamp, pose.pose) == (odometry.header.stamp, odometry.pose.pose)

    def test_simulator_with_the_plugin_ends_in_peace(self):
        self.start(car_description(perfect_odometry()))
        self.run_until(PERIOD)
        assert self.sim2d.stop() == 0, self.sim2d.stderr
        assert "class_loader" not in self.sim2d.stderr

    def test_wrong_tag_ends_the_simulator_with_one_line(self):
        self.start(car_description(perfect_odometry(robotBaseFrame="base")))
        assert self.sim2d.wait() == 2
        error = self.sim2d.result()["error"]
        assert (
            '<robotBaseFrame>: found "base", expected a link of the robot description: base_footprint, '
            in error
        )
        assert "perfect_odometry" in error
        assert error in self.sim2d.stderr


if __name__ == "__main__":
    rospy.init_node("perfect_odometry_test")
    rostest.rosrun("f1tenth_gazebo_plugins", "perfect_odometry", PerfectOdometryTest)
