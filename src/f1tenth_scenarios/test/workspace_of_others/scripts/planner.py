#!/usr/bin/env python3
"""Keeps to the middle between what is to its left and to its right; blind, it drives straight on."""

import math

import rospy
from geometry_msgs.msg import Twist
from sensor_msgs.msg import LaserScan

SPEED = 1.5  # m/s
GAIN = 0.5  # rad/m
SIDE = math.radians(50.0)


class Planner:
    def __init__(self):
        self._is_blind = rospy.get_param("~blind", False)
        self._publisher = rospy.Publisher("/truck/cmd_vel", Twist, queue_size=1)
        rospy.Subscriber("/front_laser/scan", LaserScan, self._drive, queue_size=1)

    def _drive(self, scan):
        def nearest(middle):
            index = round((middle - scan.angle_min) / scan.angle_increment)
            return min(scan.ranges[index - 60 : index + 60])

        command = Twist()
        command.linear.x = SPEED
        if not self._is_blind:
            steering = GAIN * (nearest(SIDE) - nearest(-SIDE))
            command.angular.z = max(-0.5, min(0.5, steering))  # an angle, as its plugin takes it
        self._publisher.publish(command)


if __name__ == "__main__":
    rospy.init_node("planner")
    Planner()
    rospy.spin()
