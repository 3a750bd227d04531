#!/usr/bin/env python3
"""Drives straight on, and publishes what it thinks on topics of its own, one of them far too much."""

import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from geometry_msgs.msg import Point, Pose, PoseArray, PoseStamped
from nav_msgs.msg import OccupancyGrid, Path
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float32, Float64, String
from visualization_msgs.msg import Marker, MarkerArray

TOO_MUCH = "x" * (4 << 20)


def pose_at(x, y):
    pose = Pose()
    pose.position.x, pose.position.y, pose.orientation.w = x, y, 1.0
    return pose


class Talkative:
    def __init__(self):
        self.drive = rospy.Publisher("drive", AckermannDriveStamped, queue_size=1)
        kinds = {
            "steering_error": Float64,
            "/clearance_ahead": Float32,
            "candidates": MarkerArray,
            "target": Marker,
            "road_ahead": Path,
            "particles": PoseArray,
            "my_costmap": OccupancyGrid,
            "noise": String,
        }
        self.publishers = {
            name: rospy.Publisher(name, kind, queue_size=10, latch=name == "road_ahead")
            for name, kind in kinds.items()
        }
        rospy.Subscriber("scan", LaserScan, self.on_scan, queue_size=1)

    def on_scan(self, scan):
        stamp = scan.header.stamp
        ahead = min(scan.ranges[len(scan.ranges) // 2], scan.range_max)
        said = {
            "steering_error": Float64(0.1 * ahead),
            "/clearance_ahead": Float32(ahead),
            "candidates": MarkerArray([self.marker(stamp, 0, Marker.LINE_STRIP, [(0, 0), (ahead, 0.2)])]),
            "target": self.marker(stamp, 0, Marker.SPHERE, []),
            "road_ahead": Path(poses=[PoseStamped(pose=pose_at(x, 0.0)) for x in (0.0, 1.0)]),
            "particles": PoseArray(poses=[pose_at(x / 10, 0.5) for x in range(3)]),
            "my_costmap": OccupancyGrid(),
            "noise": String(TOO_MUCH),
        }
        for name in ("road_ahead", "particles"):
            said[name].header.stamp, said[name].header.frame_id = stamp, scan.header.frame_id
        for name, message in said.items():
            self.publishers[name].publish(message)
        command = AckermannDriveStamped()
        command.drive.speed = 1.0  # slow, as recording begins a moment after the topics do
        self.drive.publish(command)

    @staticmethod
    def marker(stamp, number, kind, points):
        marker = Marker(ns="talkative", id=number, type=kind)
        marker.header.stamp, marker.header.frame_id = stamp, "map"
        marker.pose.orientation.w = 1.0
        marker.scale.x = marker.scale.y = 0.2
        marker.color.g = marker.color.a = 1.0
        marker.points = [Point(x, y, 0.0) for x, y in points]
        return marker


if __name__ == "__main__":
    rospy.init_node("talkative")
    Talkative()
    rospy.spin()
