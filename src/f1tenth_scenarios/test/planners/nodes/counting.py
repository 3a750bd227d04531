#!/usr/bin/env python3
"""Drives by how many scans it has had: one more or less shows in the run."""

import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from sensor_msgs.msg import LaserScan


class Counting:
    def __init__(self):
        self.count = 0
        self.publisher = rospy.Publisher("drive", AckermannDriveStamped, queue_size=1)
        rospy.Subscriber("scan", LaserScan, self.on_scan, queue_size=1)

    def on_scan(self, _scan):
        self.count += 1
        command = AckermannDriveStamped()
        command.drive.speed = 0.2 + 0.002 * self.count
        self.publisher.publish(command)


if __name__ == "__main__":
    rospy.init_node("counting")
    Counting()
    rospy.spin()
