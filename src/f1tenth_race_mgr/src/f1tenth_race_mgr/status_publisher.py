"""Publishes the status of the race."""

import warnings

import rospy

from f1tenth_race_mgr.msg import RaceStatus


def to_message(status, now):
    """Return the RaceStatus for a Status at now (rospy.Time)."""
    message = RaceStatus()
    message.header.stamp = now
    message.state = status.state
    message.goals_reached = status.goals_reached
    message.goals_total = status.goals_total
    message.laps = status.laps
    message.text = status.text
    return message


class StatusPublisher:
    """The latched topic race_status."""

    def __init__(self):
        # Synchronous (queue_size None, of which rospy warns): with a queue the last status, written by
        # rospy's own thread, could be lost when the node ends. A few messages a lap fill no buffer.
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SyntaxWarning)
            self._publisher = rospy.Publisher("race_status", RaceStatus, latch=True, queue_size=None)

    def __call__(self, status, now):
        """Publish and log; after ROS has shut down, log only."""
        rospy.loginfo("%s: %s", status.state.name.lower(), status.text)
        if not rospy.is_shutdown():
            self._publisher.publish(to_message(status, now))
