#!/usr/bin/env python3
"""Follows the wall to its right at a distance, and slows down for what is ahead."""

import contextlib
import math

import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from sensor_msgs.msg import LaserScan

DISTANCE = 1.8  # m, to the wall


class Planner:
    def __init__(self):
        self._publisher = rospy.Publisher("drive_of_planner", AckermannDriveStamped, queue_size=1)
        rospy.Subscriber("scan", LaserScan, self._drive, queue_size=1)

    def _drive(self, scan):
        def nearest(begin, end):
            first = int((math.radians(begin) - scan.angle_min) / scan.angle_increment)
            last = int((math.radians(end) - scan.angle_min) / scan.angle_increment)
            return min(scan.ranges[max(first, 0) : last])

        right, ahead = nearest(-90, -40), nearest(-12, 12)
        command = AckermannDriveStamped()
        command.drive.speed = max(0.0, min(1.5, ahead - 0.5))
        steering = 0.6 * (DISTANCE - right) if ahead > 2.5 else 0.4
        command.drive.steering_angle = max(-0.4, min(0.4, steering))
        with contextlib.suppress(rospy.ROSException):  # shut down meanwhile
            self._publisher.publish(command)


def main():
    rospy.init_node("planner")
    Planner()
    rospy.spin()


if __name__ == "__main__":
    main()
