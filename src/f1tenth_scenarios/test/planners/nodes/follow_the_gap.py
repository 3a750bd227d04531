#!/usr/bin/env python3
"""Follow the gap as people write it: sleep until all is up, then a loop with a rate and the newest scan."""

import numpy as np
import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from sensor_msgs.msg import LaserScan

BUBBLE = 0.35  # m, kept clear around the nearest obstacle
SIGHT = 4.0  # m


class FollowTheGap:
    def __init__(self):
        self.scan = None
        self.publisher = rospy.Publisher("/drive", AckermannDriveStamped, queue_size=10)
        rospy.sleep(5.0)
        rospy.Subscriber("/scan", LaserScan, self.on_scan, queue_size=1)

    def on_scan(self, scan):
        self.scan = scan

    def run(self):
        rate = rospy.Rate(20)
        while not rospy.is_shutdown():
            if self.scan is not None:
                self.drive(self.scan)
            rate.sleep()

    def drive(self, scan):
        angles = scan.angle_min + scan.angle_increment * np.arange(len(scan.ranges))
        ahead = np.abs(angles) < 1.2
        angles, ranges = angles[ahead], np.clip(np.array(scan.ranges)[ahead], 0.0, SIGHT)
        ranges = np.convolve(ranges, np.ones(9) / 9, "same")
        nearest = int(np.argmin(ranges))
        ranges[np.abs(angles - angles[nearest]) < np.arctan2(BUBBLE, ranges[nearest])] = 0.0
        message = AckermannDriveStamped()
        message.drive.steering_angle = float(np.average(angles, weights=ranges**3 + 1e-6))
        message.drive.speed = 2.0 if abs(message.drive.steering_angle) < 0.15 else 1.2
        self.publisher.publish(message)


if __name__ == "__main__":
    rospy.init_node("follow_the_gap")
    FollowTheGap().run()
