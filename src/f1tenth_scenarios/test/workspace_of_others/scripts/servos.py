#!/usr/bin/env python3
"""Turns what the planner asks for into the commands of four joints."""

import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64

WHEEL_RADIUS = 0.06  # m


def main():
    rospy.init_node("servos")
    joints = {
        name: rospy.Publisher(f"/truck/{name}/command", Float64, queue_size=1)
        for name in ("left_rear", "right_rear", "left_steering", "right_steering")
    }

    def relay(command):
        for name, publisher in joints.items():
            is_wheel = name.endswith("rear")
            publisher.publish(command.linear.x / WHEEL_RADIUS if is_wheel else command.angular.z)

    rospy.Subscriber("/truck/cmd_vel", Twist, relay, queue_size=1)
    rospy.spin()


if __name__ == "__main__":
    main()
