"""Where the car is in the map at the time of a scan, the same at every speed of the machine."""

import threading

import rospy
from geometry_msgs.msg import Quaternion, Transform
from nav_msgs.msg import Odometry
from tf2_msgs.msg import TFMessage

from f1tenth_gazebo.poses import composed
from workspace_support import maths

PATIENCE = 5.0
"""Wall time in which a message of a scan's time must have come, s."""
ODOMETRY_PERIOD = 0.0199
"""At 50 Hz the next odometry is less than 20 ms away, s."""
MAP_DELAY = 0.1
"""Age of the transform from the map that counts, s: the mapper has sent it by then, also in lockstep."""


class Stamped:
    """Messages by their stamps: which one belongs to a stamp must not depend on when it arrives."""

    def __init__(self):
        """Start without any message."""
        self._arrived = threading.Condition()
        self._messages = []

    def add(self, message):
        """Take a message; their stamps only grow."""
        with self._arrived:
            self._messages.append(message)
            self._arrived.notify_all()

    def __bool__(self):
        """Whether there is any message yet."""
        return bool(self._messages)

    def at(self, stamp, period):
        """The last message not after a stamp, once one newer than stamp - period (s) is there; or None."""
        with self._arrived:
            self._arrived.wait_for(lambda: self._has_newer(stamp, period), PATIENCE)
            known = [message for message in self._messages if message.header.stamp <= stamp]
            self._messages = known[-1:] + self._messages[len(known) :]
        return known[-1] if known else None

    def _has_newer(self, stamp, period):
        return any((stamp - message.header.stamp).to_sec() < period for message in self._messages)


class LapInputs:
    """Odometry, and the mapper's transform from the map to its frame."""

    def __init__(self):
        """Subscribe."""
        self._odometry = Stamped()
        self._corrections = {}
        rospy.Subscriber("odom", Odometry, self._odometry.add, tcp_nodelay=True)
        rospy.Subscriber("/tf", TFMessage, self._on_transforms, tcp_nodelay=True)

    def at(self, stamp):
        """((x, y, yaw) in the map in m and rad, speed in m/s) at a scan's stamp, or None without odometry."""
        odometry = self._odometry.at(stamp, ODOMETRY_PERIOD)
        if odometry is None:
            return None
        transform = self._correction(odometry.header.frame_id, stamp)
        return _in_map(transform, odometry.pose.pose), odometry.twist.twist.linear.x

    def _correction(self, frame, stamp):
        corrections = self._corrections.get(frame)
        # A rospy.Time before zero is an error.
        delay = min(rospy.Duration(MAP_DELAY), stamp - rospy.Time())
        correction = corrections.at(stamp - delay, 0.0) if corrections else None
        # Until there is one, the map's frame is that of odometry.
        return correction.transform if correction else Transform(rotation=Quaternion(w=1.0))

    def _on_transforms(self, message):
        for transform in message.transforms:
            if transform.header.frame_id == "map":
                self._corrections.setdefault(transform.child_frame_id, Stamped()).add(transform)


def _yaw(rotation):
    return 2.0 * maths.atan2(rotation.z, rotation.w)


def _in_map(transform, pose):
    moved, position = transform.translation, pose.position
    return composed(
        (moved.x, moved.y, _yaw(transform.rotation)), (position.x, position.y, _yaw(pose.orientation))
    )
