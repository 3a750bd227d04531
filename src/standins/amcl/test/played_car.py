"""What amcl hears from a car in a rectangular room: map, scans, transforms."""

import math

import rospy
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

PERIOD = 0.025  # s
BEAMS = 361
RESOLUTION = 0.05  # m
WEST, SOUTH, COLUMNS, ROWS = -3.0, -2.5, 160, 100  # of the map
START = 1.0  # s, stamp of the first period


def transform(parent, child, x, stamp):
    """A transform along x, m."""
    message = TransformStamped()
    message.header.frame_id = parent
    message.header.stamp = stamp
    message.child_frame_id = child
    message.transform.translation.x = x
    message.transform.rotation.w = 1.0
    return TFMessage([message])


def room():
    """The map: walls of one cell around 8 m by 5 m, and a pillar from (3, 0.5) to (3.5, 1.5)."""
    grid = OccupancyGrid()
    grid.header.frame_id = "map"
    grid.info.resolution = RESOLUTION
    grid.info.width, grid.info.height = COLUMNS, ROWS
    grid.info.origin.position.x, grid.info.origin.position.y = WEST, SOUTH
    grid.info.origin.orientation.w = 1.0
    grid.data = [100 if _is_wall(i % COLUMNS, i // COLUMNS) else 0 for i in range(COLUMNS * ROWS)]
    return grid


def _is_wall(column, row):
    at_edge = column in (0, COLUMNS - 1) or row in (0, ROWS - 1)
    return at_edge or (120 <= column < 130 and 60 <= row < 80)


def scan(x, stamp):
    """What the lidar sees from (x, 0), without noise."""
    message = LaserScan()
    message.header.frame_id = "/laser"  # as drivers from the time of tf1 write it
    message.header.stamp = stamp
    message.angle_min, message.angle_max = -math.pi, math.pi
    message.angle_increment = 2.0 * math.pi / (BEAMS - 1)
    message.range_min, message.range_max = 0.05, 10.0
    angles = [message.angle_min + i * message.angle_increment for i in range(BEAMS)]
    message.ranges = [_range(x, angle) for angle in angles]
    return message


def _range(x, angle):
    distance = 0.0
    while True:
        column = math.floor((x + distance * math.cos(angle) - WEST) / RESOLUTION)
        row = math.floor((distance * math.sin(angle) - SOUTH) / RESOLUTION)
        if _is_wall(column, row):
            return distance
        distance += 0.02


def stamp_of(period):
    """Stamp of a period."""
    return rospy.Time.from_sec(START + period * PERIOD)


def drive(periods):
    """Of each period, the stamp and what is sent. The car drives 1 m/s, odometry says 10 % more."""
    for i in range(periods):
        stamp, x = stamp_of(i), i * PERIOD
        odometry = transform("odom", "base_footprint", 1.1 * x, stamp)
        yield stamp, [("/tf", odometry), ("/scan", scan(x, stamp))]


def mounting():
    """Where the lidar is, for /tf_static."""
    return transform("base_footprint", "laser", 0.0, rospy.Time(0))
