#!/usr/bin/env python3
"""A workspace made for Gazebo, unmodified: its own launch file starts, and the car drives."""

import math
import os
import pathlib
import signal
import subprocess
import threading
import unittest

import rospy
import rostest
from ackermann_msgs.msg import AckermannDriveStamped
from gazebo_msgs.msg import LinkStates
from gazebo_msgs.srv import GetModelState
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import JointState, LaserScan

LONG = 120.0  # wall s: only a hang takes that long
FIXTURE = pathlib.Path(__file__).resolve().parent / "workspace_of_others"


class Watch:
    """Keeps the last message of a topic."""

    def __init__(self, topic, kind):
        self._changed = threading.Condition()
        self.message = None
        self._subscriber = rospy.Subscriber(topic, kind, self._keep)

    def _keep(self, message):
        with self._changed:
            self.message = message
            self._changed.notify_all()

    def wait_for(self, condition=lambda message: True):
        with self._changed:
            done = self._changed.wait_for(lambda: self.message is not None and condition(self.message), LONG)
            assert done, self.message
            return self.message


class WorkspaceOfOthersTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        paths = f"{FIXTURE}:{os.environ['ROS_PACKAGE_PATH']}"
        cls.launch = subprocess.Popen(
            ["roslaunch", "others_racecar", "hall.launch"], env={**os.environ, "ROS_PACKAGE_PATH": paths}
        )

    @classmethod
    def tearDownClass(cls):
        cls.launch.send_signal(signal.SIGINT)
        cls.launch.wait(LONG)

    def test_car_drives_where_its_servos_steer_it(self):
        scan = Watch("/scan", LaserScan)
        joints = Watch("/racecar/joint_states", JointState)
        links = Watch("/gazebo/link_states", LinkStates)
        clock = Watch("/clock", Clock)
        seen = joints.wait_for()
        assert set(seen.name) == {
            *(f"{corner}_wheel_joint" for corner in ("left_rear", "right_rear", "left_front", "right_front")),
            *(f"{side}_steering_joint" for side in ("left", "right")),
        }
        driver = rospy.Publisher("/vesc/ackermann_cmd_mux/output", AckermannDriveStamped, queue_size=1)
        command = AckermannDriveStamped()
        command.drive.speed, command.drive.steering_angle = 2.0, 0.25
        start = self.state()
        assert math.isclose(start.pose.position.x, 1.0, abs_tol=1e-6)

        def drive_on(message):
            driver.publish(command)
            speeds = dict(zip(message.name, message.velocity))
            return speeds["left_rear_wheel_joint"] > 30.0

        joints.wait_for(drive_on)
        begin = clock.message.clock.to_sec()
        clock.wait_for(lambda message: driver.publish(command) or message.clock.to_sec() > begin + 1.0)
        end = self.state()
        way = math.hypot(
            end.pose.position.x - start.pose.position.x, end.pose.position.y - start.pose.position.y
        )
        assert way > 1.0
        assert end.twist.angular.z > 0.5
        assert len(scan.wait_for().ranges) == 1081
        assert "racecar::base_link" in links.wait_for().name

    def state(self):
        rospy.wait_for_service("/gazebo/get_model_state", LONG)
        answer = rospy.ServiceProxy("/gazebo/get_model_state", GetModelState)("racecar", "")
        assert answer.success, answer.status_message
        return answer


if __name__ == "__main__":
    rospy.init_node("workspace_of_others_test", disable_rostime=True)
    rostest.rosrun("gazebo_ros", "workspace_of_others", WorkspaceOfOthersTest)
