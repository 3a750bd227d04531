#!/usr/bin/env python3
"""A disparity extender in callbacks: answers every second scan; odometry limits how fast its speed grows."""

import numpy as np
import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

HALF_WIDTH = 0.28  # m, of the car and some air
STEP = 0.3  # m, between neighbouring beams: an edge


class DisparityExtender:
    def __init__(self):
        self.count = 0
        self.speed = 0.0
        self.publisher = rospy.Publisher("drive", AckermannDriveStamped, queue_size=1)
        rospy.Subscriber("perfect_odom", Odometry, self.on_odometry, queue_size=1)
        rospy.Subscriber("scan", LaserScan, self.on_scan, queue_size=1)

    def on_odometry(self, odometry):
        self.speed = odometry.twist.twist.linear.x

    def on_scan(self, scan):
        self.count += 1
        if self.count % 2:
            return
        angles = scan.angle_min + scan.angle_increment * np.arange(len(scan.ranges))
        ahead = np.abs(angles) < np.pi / 2
        angles = angles[ahead]
        ranges = self.extended(np.clip(np.array(scan.ranges)[ahead], 0.05, 8.0), scan.angle_increment)
        target = float(angles[int(np.argmax(np.convolve(ranges, np.ones(41) / 41, "same")))])
        free = float(ranges[np.abs(angles) < 0.05].min())
        message = AckermannDriveStamped()
        message.drive.steering_angle = float(np.clip(target, -0.4, 0.4))
        message.drive.speed = min(
            self.speed + 0.5, 0.8 + 0.4 * free, 3.0 - 4.0 * abs(message.drive.steering_angle)
        )
        self.publisher.publish(message)

    @staticmethod
    def extended(ranges, increment):
        found = ranges.copy()
        for edge in np.flatnonzero(np.abs(np.diff(ranges)) > STEP):
            near = min(ranges[edge], ranges[edge + 1])
            reach = int(np.ceil(np.arctan2(HALF_WIDTH, near) / increment))
            part = slice(max(edge - reach, 0), edge + reach + 2)
            found[part] = np.minimum(found[part], near)
        return found


if __name__ == "__main__":
    rospy.init_node("disparity_extender")
    DisparityExtender()
    rospy.spin()
