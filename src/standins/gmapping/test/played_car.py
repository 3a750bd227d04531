"""What slam_gmapping hears from a car in a rectangular room: scans, transforms, the clock."""

import math

import rospy
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

PERIOD = 0.025  # s
BEAMS = 1441


def transform(parent, child, x, yaw, stamp):
    """A transform along x with a yaw, m and rad."""
    message = TransformStamped()
    message.header.frame_id = parent
    message.header.stamp = stamp
    message.child_frame_id = child
    message.transform.translation.x = x
    message.transform.rotation.z = math.sin(yaw / 2.0)
    message.transform.rotation.w = math.cos(yaw / 2.0)
    return TFMessage([message])


def scan(x, stamp):
    """What the lidar sees from (x, 0) in a room from (-3.02, -2.52) to (5.02, 2.52), m."""
    message = LaserScan()
    message.header.frame_id = "/laser"  # as drivers from the time of tf1 write it
    message.header.stamp = stamp
    message.angle_min = -math.pi + 1e-4  # No beam is parallel to a wall.
    message.angle_max = math.pi + 1e-4
    message.angle_increment = 2.0 * math.pi / (BEAMS - 1)
    message.range_min = 0.05
    message.range_max = 10.0
    for i in range(BEAMS):
        angle = message.angle_min + i * message.angle_increment
        ahead = (5.02 if math.cos(angle) > 0.0 else -3.02) - x
        aside = 2.52 if math.sin(angle) > 0.0 else -2.52
        message.ranges.append(min(ahead / math.cos(angle), aside / math.sin(angle)))
    return message


def drive(periods):
    """Of each period, the stamp and what is sent. The car drives 1 m/s, odometry says 2 % more."""
    for i in range(periods):
        stamp = rospy.Time.from_sec(1.0 + i * PERIOD)
        x = i * PERIOD
        yield (
            stamp,
            [("/tf", transform("odom", "base_footprint", 1.02 * x, 0.0, stamp)), ("/scan", scan(x, stamp))],
        )


def mounting():
    """Where the lidar is, for /tf_static."""
    return transform("base_footprint", "laser", 0.0, 0.0, rospy.Time(0))
