#!/usr/bin/env python3
"""Answers each scan of a car with one command on `drive`: the widest gap ahead, slower the harder it steers.

Run it in the car's namespace: ROS_NAMESPACE=robot1 rosrun f1tenth_sim2d gap_follower.py

The same as gap_follower.h, which the benchmarks drive with: the driver that most know, and cheap. What takes
a car around any circuit to map it is another, slower and more careful: f1tenth_gazebo.driving.gap_follower.
"""

import math
from dataclasses import dataclass

import numpy as np
import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from sensor_msgs.msg import LaserScan


@dataclass(frozen=True)
class Options:
    """What the driver looks at (m, rad), and how it drives (m/s, rad)."""

    field_of_view: float = 2.6
    sight: float = 5.0
    bubble: float = 0.5
    safe_range: float = 1.2
    steering_gain: float = 0.9
    steering_max: float = 0.4
    speed: float = 2.0
    speed_turning: float = 1.2


def gap_angle(ranges, angles, options):
    """Return the angle of the gap with the greatest sum of ranges, in rad; 0 if there is none.

    ranges, angles: arrays of shape (n,), m and rad; too near is -inf, nothing there +inf.
    """
    ahead = np.abs(angles) <= options.field_of_view / 2
    view, angles = np.clip(ranges[ahead], 0.0, options.sight), angles[ahead]
    nearest = np.argmin(view)
    half_angle = math.atan2(options.bubble, view[nearest])
    view[np.abs(angles - angles[nearest]) <= half_angle] = 0.0
    is_free = np.concatenate(([False], view > options.safe_range, [False]))
    starts, ends = np.flatnonzero(np.diff(is_free.astype(np.int8))).reshape(-1, 2).T
    if not starts.size:
        return 0.0
    sums = np.cumsum(np.concatenate(([0.0], view)))
    best = np.argmax(sums[ends] - sums[starts])
    gap = slice(starts[best], ends[best])
    return float(np.average(angles[gap], weights=view[gap]))


def drive(scan, options):
    """Return (speed in m/s, steering angle in rad) for a LaserScan."""
    ranges = np.array(scan.ranges, dtype=np.float32)
    angles = scan.angle_min + scan.angle_increment * np.arange(ranges.size)
    limit = options.steering_max
    steering = max(-limit, min(limit, options.steering_gain * gap_angle(ranges, angles, options)))
    turning = abs(steering) / limit
    return options.speed + (options.speed_turning - options.speed) * turning, steering


def main():
    """Answer scans until ROS shuts down."""
    rospy.init_node("gap_follower")
    options = Options()
    # Without a queue: sent from this thread, at once.
    publisher = rospy.Publisher("drive", AckermannDriveStamped, queue_size=None, tcp_nodelay=True)
    command = AckermannDriveStamped()

    def answer(scan):
        command.header.stamp = scan.header.stamp
        command.drive.speed, command.drive.steering_angle = drive(scan, options)
        publisher.publish(command)

    rospy.Subscriber("scan", LaserScan, answer, tcp_nodelay=True)
    rospy.spin()


if __name__ == "__main__":
    main()
