"""Publishes the status of the race."""

import rospy
from workspace_support.nodes import synchronous_publisher

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
        # So that the last status is out before the node ends. A few messages a lap fill no buffer.
        self._publisher = synchronous_publisher("race_status", RaceStatus, latch=True)

    def __call__(self, status, now):
        """Publish and log; after ROS has shut down, log only."""
        rospy.loginfo("%s: %s", status.state.name.lower(), status.text)
        if not rospy.is_shutdown():
            self._publisher.publish(to_message(status, now))
