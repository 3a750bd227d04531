"""Publishes the goals of the race, for displays such as rviz, and its status."""

import rospy
from geometry_msgs.msg import Pose, PoseArray
from workspace_support.nodes import synchronous_publisher

from f1tenth_race_mgr.msg import RaceStatus


def publish_goals(goals):
    """Advertise the latched topic race_goals; return its publisher, which must live as long as the topic."""
    publisher = rospy.Publisher("race_goals", PoseArray, latch=True, queue_size=1)
    publisher.publish(_goals_message(goals))
    return publisher


class StatusPublisher:
    """The latched topic race_status."""

    def __init__(self):
        # So that the last status is sent before the node ends. A few messages per lap fill no buffer
        # (a full one would block publish()).
        self._publisher = synchronous_publisher("race_status", RaceStatus, latch=True)

    def __call__(self, status, now):
        """Publish and log; after ROS has shut down, log only."""
        rospy.loginfo("%s: %s", status.state.name.lower(), status.text)
        if not rospy.is_shutdown():
            self._publisher.publish(_status_message(status, now))


def _goals_message(goals):
    """Return the PoseArray for Goals, which are all in one frame."""
    message = PoseArray()
    message.header.frame_id = goals[0].frame_id
    message.poses = [_pose(goal) for goal in goals]
    return message


def _pose(goal):
    pose = Pose()
    pose.position.x, pose.position.y, pose.position.z = goal.x, goal.y, goal.z
    rotation = pose.orientation
    rotation.x, rotation.y, rotation.z, rotation.w = goal.qx, goal.qy, goal.qz, goal.qw
    return pose


def _status_message(status, now):
    """Return the RaceStatus for a Status at now (rospy.Time)."""
    message = RaceStatus()
    message.header.stamp = now
    message.state = status.state
    message.goals_reached = status.goals_reached
    message.goals_total = status.goals_total
    message.laps = status.laps
    message.text = status.text
    return message
