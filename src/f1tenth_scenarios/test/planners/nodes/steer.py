#!/usr/bin/env python3
"""The second of two nodes: steers to the newest target, by a timer."""

import math

import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from geometry_msgs.msg import PointStamped
from nav_msgs.msg import Odometry

WHEELBASE = 0.33  # m


class Steer:
    def __init__(self):
        self.pose = self.target = None
        self.publisher = rospy.Publisher("drive", AckermannDriveStamped, queue_size=1)
        rospy.Subscriber("perfect_odom", Odometry, self.on_odometry, queue_size=1)
        rospy.Subscriber("target", PointStamped, self.on_target, queue_size=1)
        rospy.Timer(rospy.Duration(0.04), self.on_timer)

    def on_odometry(self, odometry):
        self.pose = odometry.pose.pose

    def on_target(self, target):
        self.target = target.point

    def on_timer(self, _event):
        if self.pose is None or self.target is None:
            return
        yaw = 2 * math.atan2(self.pose.orientation.z, self.pose.orientation.w)
        dx, dy = self.target.x - self.pose.position.x, self.target.y - self.pose.position.y
        left = math.cos(yaw) * dy - math.sin(yaw) * dx
        curvature = 2 * left / max(dx * dx + dy * dy, 1e-6)
        message = AckermannDriveStamped()
        message.drive.steering_angle = max(-0.4, min(0.4, math.atan(WHEELBASE * curvature)))
        message.drive.speed = min(3.0, math.sqrt(2.5 / max(abs(curvature), 1e-3)))
        self.publisher.publish(message)


if __name__ == "__main__":
    rospy.init_node("steer")
    Steer()
    rospy.spin()
