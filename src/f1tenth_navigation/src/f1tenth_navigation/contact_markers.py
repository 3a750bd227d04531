"""Contacts as rviz shows them: a ball at each place where a car touched something."""

import math

from visualization_msgs.msg import Marker, MarkerArray

DIAMETER = 0.35  # m
SPACING = 0.1  # m; places that are closer are one
MOST = 500  # places; the oldest go first


class ContactPlaces:
    """Where a car has touched something, in the order in which it did."""

    def __init__(self, ground_models=("ground_plane",)):
        """`ground_models` may be touched."""
        self._ground_models = frozenset(ground_models)
        self._places = []

    def take(self, contacts):
        """Note the places of a gazebo_msgs/ContactsState; return whether there is a new one."""
        new = [place for state in contacts.states for place in self._touched(state) if self._is_new(place)]
        self._places = (self._places + new)[-MOST:]
        return bool(new)

    def markers(self, frame):
        """All places as a MarkerArray that replaces the one before."""
        clear = Marker(action=Marker.DELETEALL)
        clear.header.frame_id = frame
        balls = [_ball(frame, number, place) for number, place in enumerate(self._places)]
        return MarkerArray(markers=[clear, *balls])

    def _touched(self, state):
        names = (state.collision1_name, state.collision2_name)
        if any(name.split("::", 1)[0] in self._ground_models for name in names):
            return []
        return [(position.x, position.y, position.z) for position in state.contact_positions[:1]]

    def _is_new(self, place):
        return all(math.dist(place, known) >= SPACING for known in self._places)


def _ball(frame, number, place):
    marker = Marker(ns="contacts", type=Marker.SPHERE, id=number, action=Marker.ADD)
    marker.header.frame_id = frame
    marker.pose.position.x, marker.pose.position.y, _ = place
    marker.pose.position.z = DIAMETER  # Above scan and map.
    marker.pose.orientation.w = 1.0
    marker.scale.x = marker.scale.y = marker.scale.z = DIAMETER
    marker.color.r, marker.color.g, marker.color.b, marker.color.a = 1.0, 0.9, 0.0, 1.0
    return marker
