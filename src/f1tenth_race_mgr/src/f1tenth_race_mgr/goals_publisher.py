"""Publishes the goals of the race, for displays such as rviz."""

import rospy
from geometry_msgs.msg import Pose, PoseArray


def to_message(goals):
    """Return the PoseArray for Goals, which are all in one frame."""
    message = PoseArray()
    message.header.frame_id = goals[0].frame_id
    message.poses = [_pose(goal) for goal in goals]
    return message


def publish_goals(goals):
    """Advertise the latched topic race_goals; return its publisher, which must live as long as the topic."""
    publisher = rospy.Publisher("race_goals", PoseArray, latch=True, queue_size=1)
    publisher.publish(to_message(goals))
    return publisher


def _pose(goal):
    pose = Pose()
    pose.position.x, pose.position.y, pose.position.z = goal.x, goal.y, goal.z
    rotation = pose.orientation
    rotation.x, rotation.y, rotation.z, rotation.w = goal.qx, goal.qy, goal.qz, goal.qw
    return pose
