"""Goals as rviz shows them: arrows, with numbers on discs that are seen on walls and on free ground alike."""

from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import PoseStamped
from visualization_msgs.msg import Marker, MarkerArray

LENGTH, WIDTH = 0.8, 0.12
"""Of an arrow, m."""
DISC, HEIGHT = 0.5, 0.34
"""Diameter of a disc and height of the number on it, m."""
BLUE, RED, PINK, WHITE = (0.12, 0.23, 0.42), (0.85, 0.1, 0.1), (0.85, 0.1, 0.6), (1.0, 1.0, 1.0)


def goal_markers(poses, problems=None):
    """A MarkerArray that shows each PoseStamped; it replaces the one before.

    Args:
        poses: in the order of their numbers, which begin with 1
        problems: by number, what is wrong with a goal: it is red, and that is written beside it
    """
    problems = problems or {}
    markers = MarkerArray(markers=[Marker(action=Marker.DELETEALL)])
    for number, pose in enumerate(poses, 1):
        problem = problems.get(number, "")
        markers.markers += [
            arrow_marker("arrows", number, pose, (LENGTH, WIDTH, WIDTH), PINK),
            _disc(number, pose, RED if problem else BLUE),
            text_marker("numbers", number, pose, str(number), HEIGHT, WHITE),
        ]
        if problem:
            below = text_marker("problems", number, pose, problem, HEIGHT, RED)
            below.pose.position.y -= DISC
            markers.markers.append(below)
    return markers


def trouble_marker(status):
    """A Marker beside a car: why it stands still, by move_base's DiagnosticStatus; None while all is well."""
    if status.level == DiagnosticStatus.OK:
        return None
    car = PoseStamped()
    car.header.frame_id = next(value.value for value in status.values if value.key == "frame")
    car.pose.position.y = DISC
    marker = text_marker("trouble", 0, car, status.message, HEIGHT, RED)
    marker.frame_locked = True
    return marker


def text_marker(namespace, number, pose, text, height, colour):
    """A Marker with text of a height (m) over the place of a PoseStamped."""
    marker = _marker(namespace, Marker.TEXT_VIEW_FACING, number, pose, colour)
    marker.pose.position.z = 0.5  # Above all else.
    marker.pose.orientation.w = 1.0
    marker.scale.z = height
    marker.text = text
    return marker


def arrow_marker(namespace, number, pose, scale, colour):
    """A Marker with an arrow of some scale (x, y, z; m) at a PoseStamped."""
    marker = _marker(namespace, Marker.ARROW, number, pose, colour)
    marker.pose.orientation = pose.pose.orientation
    marker.scale.x, marker.scale.y, marker.scale.z = scale
    return marker


def _marker(namespace, kind, number, pose, colour):
    marker = Marker(ns=namespace, type=kind, id=number, action=Marker.ADD)
    marker.header.frame_id = pose.header.frame_id
    marker.pose.position.x = pose.pose.position.x
    marker.pose.position.y = pose.pose.position.y
    marker.color.r, marker.color.g, marker.color.b = colour
    marker.color.a = 1.0
    return marker


def _disc(number, pose, colour):
    marker = _marker("discs", Marker.CYLINDER, number, pose, colour)
    marker.pose.position.z = 0.2  # Above arrow and map.
    marker.pose.orientation.w = 1.0
    marker.scale.x = marker.scale.y = DISC
    marker.scale.z = 0.02
    return marker
