"""The node navigation_goals: what is clicked in rviz becomes a goals file."""

import math
import sys

import rospy
from f1tenth_navigation.goal_markers import goal_markers
from geometry_msgs.msg import PoseStamped
from visualization_msgs.msg import MarkerArray

from f1tenth_navigation_mgr import Goal, GoalsFileError, save_goals_file


class GoalCollector:
    """Appends each pose that is clicked, shows it and writes the file anew: it is complete at any time.

    A file that was there stays until the first click.
    """

    def __init__(self, path):
        """Subscribe and advertise; `path` is the goals file."""
        self._path = path
        self._poses = []
        self._publisher = rospy.Publisher("navigation_goals", MarkerArray, queue_size=1, latch=True)
        rospy.Subscriber("move_base_simple/goal", PoseStamped, self._on_pose)

    def _on_pose(self, pose):
        self._poses.append(pose)
        self._publisher.publish(goal_markers(self._poses))
        try:
            save_goals_file(self._path, [goal_of(pose) for pose in self._poses])
        except GoalsFileError as error:
            rospy.logerr("%s", error)
            return
        rospy.loginfo("%s: %d goals", self._path, len(self._poses))


def goal_of(pose):
    """The Goal of a PoseStamped; rviz turns about z only."""
    rotation = pose.pose.orientation
    yaw = 2.0 * math.atan2(rotation.z, rotation.w)
    return Goal(
        pose.pose.position.x, pose.pose.position.y, math.remainder(yaw, math.tau), pose.header.frame_id
    )


def main():
    """Wire the node; return the exit code."""
    rospy.init_node("navigation_goals")
    path = rospy.get_param("~goals_file", "")
    if not path:
        print("navigation_goals: ~goals_file: found nothing, must be the path of a file", file=sys.stderr)
        return 2
    GoalCollector(path)
    rospy.spin()
    return 0
