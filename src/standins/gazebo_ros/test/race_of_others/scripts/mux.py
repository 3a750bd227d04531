#!/usr/bin/env python3
"""Hands the newest drive command on to the four joints that move the car."""

import contextlib

import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from std_msgs.msg import Float64

WHEEL_RADIUS = 0.05  # m


def main():
    rospy.init_node("mux")
    wheels = [rospy.Publisher(f"{side}_rear/command", Float64, queue_size=1) for side in ("left", "right")]
    hinges = [
        rospy.Publisher(f"{side}_steering/command", Float64, queue_size=1) for side in ("left", "right")
    ]

    def hand_on(message):
        with contextlib.suppress(rospy.ROSException):  # shut down meanwhile
            for wheel in wheels:
                wheel.publish(message.drive.speed / WHEEL_RADIUS)
            for hinge in hinges:
                hinge.publish(message.drive.steering_angle)

    rospy.Subscriber("drive_of_planner", AckermannDriveStamped, hand_on, queue_size=1)
    rospy.spin()


if __name__ == "__main__":
    main()
