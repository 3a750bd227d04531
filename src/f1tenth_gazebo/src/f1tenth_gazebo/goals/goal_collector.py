"""The node navigation_goals: what is clicked in rviz becomes a goals file."""

import math
import os
import sys
import threading
from pathlib import Path

import rospkg
import rospy
from f1tenth_judge.atomic import write_all
from f1tenth_judge.places.goals import goals_text
from f1tenth_navigation.goal_markers import arrow_marker, goal_markers, text_marker
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import OccupancyGrid
from visualization_msgs.msg import MarkerArray

import f1tenth_sim2d
from f1tenth_gazebo.goals.clicked_goals import ClickedGoals
from f1tenth_gazebo.goals.road_ahead import road_ahead
from f1tenth_gazebo.worlds.find_world import WorldError, find_world
from f1tenth_navigation_mgr import Goal, GoalsFileError, load_goals_file

_HINT = "2D Nav Goal (g): press and drag to add a goal, click on a goal to take it away"
_GREEN, _GREY = (0.1, 0.6, 0.2), (0.4, 0.45, 0.5)
BAD_INPUT = 2  # exit code


class GoalCollector:
    """Takes clicks, shows the goals and writes the file anew: it is complete at any time."""

    def __init__(self, path, goals, road):
        """Subscribe and advertise; the file has these goals already, and the road begins at the start."""
        self._path = path
        self._clicked = ClickedGoals(goals)
        self._lock = threading.Lock()
        self._publisher = rospy.Publisher("navigation_goals", MarkerArray, queue_size=1, latch=True)
        self._road_publisher = rospy.Publisher("road_ahead", MarkerArray, queue_size=1, latch=True)
        self._road_publisher.publish(road_markers(road))
        self._publish()
        rospy.Subscriber("map", OccupancyGrid, self._on_map)
        rospy.Subscriber("move_base_simple/goal", PoseStamped, self._on_pose)

    def _on_map(self, grid):
        with self._lock:
            self._clicked.take_map(grid)
            self._publish()

    def _on_pose(self, pose):
        if pose.header.frame_id != "map":
            rospy.logwarn('a click in frame "%s" is ignored: goals are in "map"', pose.header.frame_id)
            return
        with self._lock:
            added = self._clicked.take(goal_of(pose))
            self._publish()
            goals, problems = self._clicked.poses, self._clicked.problems()
            self._save(goals)
        if added and len(goals) in problems:
            rospy.logwarn("goal %d is %s", len(goals), problems[len(goals)])

    def _save(self, goals):
        try:
            if goals:
                write_all({Path(self._path).resolve(): goals_text(goals).encode()})
            else:  # An empty file is not a goals file.
                Path(self._path).unlink(missing_ok=True)
        except OSError as error:
            rospy.logerr("%s", error)
            return
        rospy.loginfo("%s: %d goals", self._path, len(goals))

    def _publish(self):
        poses = [stamped(goal.x, goal.y, goal.yaw, goal.frame_id) for goal in self._clicked.poses]
        self._publisher.publish(goal_markers(poses, self._clicked.problems()))


def goal_of(pose):
    """The Goal of a PoseStamped; rviz turns about z only."""
    rotation = pose.pose.orientation
    yaw = 2.0 * math.atan2(rotation.z, rotation.w)
    return Goal(
        pose.pose.position.x, pose.pose.position.y, math.remainder(yaw, math.tau), pose.header.frame_id
    )


def stamped(x, y, yaw, frame="map"):
    """A PoseStamped of a pose in the plane."""
    message = PoseStamped()
    message.header.frame_id = frame
    message.pose.position.x, message.pose.position.y = x, y
    message.pose.orientation.z, message.pose.orientation.w = math.sin(yaw / 2.0), math.cos(yaw / 2.0)
    return message


def road_markers(road):
    """The start, the driving direction along the road, and what clicks do, as a MarkerArray."""
    poses = [stamped(pose.x, pose.y, pose.yaw) for pose in road]
    markers = [arrow_marker("road", 0, poses[0], (1.2, 0.25, 0.1), _GREEN)]
    markers += [arrow_marker("road", i, pose, (0.6, 0.1, 0.05), _GREY) for i, pose in enumerate(poses[1:], 1)]
    start = text_marker("start", 0, poses[0], "start", 0.45, _GREEN)
    start.pose.position.y += 0.6
    hint = text_marker("hint", 0, poses[0], _HINT, 0.35, (1.0, 1.0, 1.0))
    hint.pose.position.y = min(pose.pose.position.y for pose in poses) - 2.5
    hint.pose.position.x = (min(p.pose.position.x for p in poses) + max(p.pose.position.x for p in poses)) / 2
    return MarkerArray(markers=[*markers, start, hint])


def main():
    """Wire the node; return the exit code."""
    rospy.init_node("navigation_goals")
    path = rospy.get_param("~goals_file", "")
    if not path:
        return _bad_input("~goals_file: found nothing, must be the path of a file")
    worlds = Path(rospkg.RosPack().get_path("f1tenth_gazebo")) / "worlds"
    world, folder = rospy.get_param("~world", "circuit1"), rospy.get_param("~folder", ".")
    try:
        road = road_ahead(find_world(world, worlds, folder))
        goals = load_goals_file(path) if os.path.exists(path) else []
    except (WorldError, GoalsFileError, f1tenth_sim2d.Error, OSError) as error:
        return _bad_input(error)
    GoalCollector(path, goals, road)
    rospy.spin()
    return 0


def _bad_input(problem):
    print(f"navigation_goals: {problem}", file=sys.stderr)
    return BAD_INPUT
