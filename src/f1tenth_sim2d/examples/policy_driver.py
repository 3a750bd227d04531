#!/usr/bin/env python3
"""Drives by a policy that train_ppo.py has learned: answers each scan, with the odometry of its stamp."""

import threading

import numpy as np
import onnxruntime
import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

EVERY = 10  # beams: the policy knows 109 of the car's 1081


class PolicyDriver:
    """From the topics `scan` and `odom` to `drive`."""

    def __init__(self, file):
        self.policy = onnxruntime.InferenceSession(file, providers=["CPUExecutionProvider"])
        self.heard, self.lock = {}, threading.Lock()
        # Without a queue: sent at once.
        self.drive = rospy.Publisher("drive", AckermannDriveStamped, queue_size=None, tcp_nodelay=True)
        for topic, kind in (("odom", Odometry), ("scan", LaserScan)):
            rospy.Subscriber(topic, kind, self.hear, topic, tcp_nodelay=True)

    def hear(self, message, topic):
        """Answer a scan, once, when the odometry of its stamp is there, too."""
        with self.lock:
            self.heard[topic] = message
            scan, odometry = self.heard.get("scan"), self.heard.get("odom")
            if scan and odometry and scan.header.stamp == odometry.header.stamp:
                del self.heard["scan"]
                self.answer(scan, odometry.twist.twist)

    def answer(self, scan, twist):
        """Publish what the policy does."""
        ranges = np.clip(np.array(scan.ranges)[::EVERY], 0.0, scan.range_max)
        observation = np.float32([[*ranges, twist.linear.x, twist.linear.y, twist.angular.z]])
        ((steering, speed),) = self.policy.run(None, {"observation": observation})[0]
        command = AckermannDriveStamped(header=scan.header)
        command.drive.steering_angle, command.drive.speed = steering, speed
        self.drive.publish(command)


if __name__ == "__main__":
    rospy.init_node("policy_driver")
    driver = PolicyDriver(rospy.get_param("~policy"))
    rospy.spin()
