#!/usr/bin/env python3
"""A planner that is a class, as a node: answers each scan, with the odometry of its time, by one command."""

import importlib
import sys

import numpy as np
import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from f1tenth_judge.planner import Observation, Scan
from f1tenth_scenarios.drivers.answering import Answering
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan


def observed(stamp, scan, odometry):
    place, turn = odometry.pose.pose.position, odometry.pose.pose.orientation
    ranges = np.array(scan.ranges, dtype=np.float32)
    angles = (scan.angle_min, scan.angle_increment, scan.range_min, scan.range_max)
    yaw = 2 * np.arctan2(turn.z, turn.w)
    return Observation(
        stamp, Scan(ranges, *angles), (place.x, place.y, yaw), (0.0, 0.0, 0.0), 0.0, np.empty(0)
    )


def main():
    rospy.init_node("class_node")
    sys.path.insert(0, rospy.get_param("~folder"))
    planner = getattr(importlib.import_module("classes"), rospy.get_param("~class"))()
    if hasattr(planner, "reset"):
        planner.reset({"line": rospy.get_param("~line")})
    publisher = rospy.Publisher("drive", AckermannDriveStamped, queue_size=None, tcp_nodelay=True)
    scans = {}

    def answer(stamp, odometry):
        message = AckermannDriveStamped()
        scan = scans.pop(stamp)
        message.header.stamp = scan.header.stamp
        message.drive.speed, message.drive.steering_angle = planner.plan(observed(stamp, scan, odometry))
        publisher.publish(message)

    answering = Answering(answer, 0.005)

    def take_scan(message):
        scans[message.header.stamp.to_sec()] = message
        answering.take_scan(message.header.stamp.to_sec())

    def take_odometry(message):
        answering.take_odometry(message.header.stamp.to_sec(), message)

    rospy.Subscriber("perfect_odom", Odometry, take_odometry, tcp_nodelay=True)
    rospy.Subscriber("scan", LaserScan, take_scan, tcp_nodelay=True)
    rospy.spin()


if __name__ == "__main__":
    main()
