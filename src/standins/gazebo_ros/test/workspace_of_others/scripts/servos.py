#!/usr/bin/env python3
"""Turns what the driver asks for into the commands of the six joints."""

import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from std_msgs.msg import Float64

WHEEL_RADIUS = 0.05  # m
WHEELS = ("left_rear", "right_rear", "left_front", "right_front")
SIDES = ("left", "right")


def main():
    """Relay until ROS shuts down."""
    rospy.init_node("servos")
    wheels = [
        rospy.Publisher(f"/racecar/{wheel}_wheel_controller/command", Float64, queue_size=1)
        for wheel in WHEELS
    ]
    hinges = [
        rospy.Publisher(f"/racecar/{side}_steering_controller/command", Float64, queue_size=1)
        for side in SIDES
    ]

    def relay(message):
        for wheel in wheels:
            wheel.publish(message.drive.speed / WHEEL_RADIUS)
        for hinge in hinges:
            hinge.publish(message.drive.steering_angle)

    rospy.Subscriber("/vesc/ackermann_cmd_mux/output", AckermannDriveStamped, relay, queue_size=1)
    rospy.spin()


if __name__ == "__main__":
    main()
