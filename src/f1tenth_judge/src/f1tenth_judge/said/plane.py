"""What messages say of the plane, m and rad."""

import math

from f1tenth_judge.places.goals import yaw_of
from f1tenth_judge.record.replay import Planar, Point


def planar(pose) -> Planar:
    """A geometry_msgs/Pose in the plane."""
    turn = pose.orientation
    return (*point(pose.position), round(yaw_of(turn.x, turn.y, turn.z, turn.w), 4))


def point(position) -> Point:
    """A geometry_msgs/Point in the plane."""
    return round(position.x, 3), round(position.y, 3)


def placed(frame: Planar, point: Point) -> Point:
    """Where a point of a frame is."""
    x, y, yaw = frame
    cosine, sine = math.cos(yaw), math.sin(yaw)
    return (
        round(x + cosine * point[0] - sine * point[1], 3),
        round(y + sine * point[0] + cosine * point[1], 3),
    )
