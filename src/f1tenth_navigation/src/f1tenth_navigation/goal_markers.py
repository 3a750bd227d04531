"""Goals as rviz shows them: numbered arrows."""

from visualization_msgs.msg import Marker, MarkerArray

LENGTH, WIDTH, HEIGHT = 0.6, 0.12, 0.4
"""Of an arrow and of the figures of its number, m."""


def goal_markers(poses):
    """A MarkerArray of an arrow and a number, from 1, for each PoseStamped; it replaces the one before."""
    markers = MarkerArray(markers=[Marker(action=Marker.DELETEALL)])
    for number, pose in enumerate(poses, 1):
        markers.markers += [_arrow(number, pose), _number(number, pose)]
    return markers


def _marker(namespace, kind, number, pose):
    marker = Marker(ns=namespace, type=kind, id=number, action=Marker.ADD)
    marker.header.frame_id = pose.header.frame_id
    marker.pose.position.x = pose.pose.position.x
    marker.pose.position.y = pose.pose.position.y
    marker.color.a = 1.0
    return marker


def _arrow(number, pose):
    marker = _marker("arrows", Marker.ARROW, number, pose)
    marker.pose.orientation = pose.pose.orientation
    marker.scale.x, marker.scale.y, marker.scale.z = LENGTH, WIDTH, WIDTH
    marker.color.r, marker.color.g, marker.color.b = 0.85, 0.1, 0.6
    return marker


def _number(number, pose):
    marker = _marker("numbers", Marker.TEXT_VIEW_FACING, number, pose)
    marker.pose.position.y += HEIGHT
    marker.pose.position.z = 0.5  # Above arrow and map.
    marker.pose.orientation.w = 1.0
    marker.scale.z = HEIGHT
    marker.text = str(number)
    return marker
