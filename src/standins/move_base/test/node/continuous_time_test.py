#!/usr/bin/env python3
"""The node without lockstep: it keeps to its rate while time runs, and passes goals at speed."""

import sys
import unittest

import actionlib
import pytest
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus, GoalStatusArray
from fake_robot import FakeRobot, Room
from geometry_msgs.msg import PoseStamped
from move_base_msgs.msg import MoveBaseAction, MoveBaseActionFeedback, MoveBaseGoal
from nav_msgs.msg import OccupancyGrid, Path

PATIENCE = rospy.Duration(120.0)  # simulated
WALL_PATIENCE = 60.0  # s


def goal_at(x, y):
    """A goal heading along x."""
    pose = PoseStamped()
    pose.header.frame_id = "map"
    pose.pose.position.x = x
    pose.pose.position.y = y
    pose.pose.orientation.w = 1.0
    return MoveBaseGoal(pose)


class ContinuousTimeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        room = Room(20.0, 3.0)
        # A closet that a point can get into, but no car: the search for a plan takes seconds.
        room.add_wall(18.0, 0.0, 18.2, 1.3)
        room.add_wall(18.0, 1.65, 18.2, 3.0)
        cls.robot = FakeRobot(room)
        cls.robot.reads_angles = True
        cls.robot.start()
        cls.client = actionlib.SimpleActionClient("move_base", MoveBaseAction)
        assert cls.client.wait_for_server(PATIENCE)

    @classmethod
    def tearDownClass(cls):
        cls.robot.stop()

    def setUp(self):
        self.robot.put(1.0, 1.5)

    def reach(self, goal):
        self.client.send_goal(goal)
        assert self.client.wait_for_result(PATIENCE)
        assert self.client.get_state() == GoalStatus.SUCCEEDED
        assert self.client.get_goal_status_text() == "Goal reached."

    def test_goals_are_passed_at_speed_and_the_last_one_ends_in_a_stop(self):
        goals = [goal_at(5.0, 1.5), goal_at(8.0, 1.2), goal_at(11.0, 1.5)]
        goals_ahead = rospy.Publisher("move_base/goals_ahead", Path, queue_size=1, latch=True)
        for i, goal in enumerate(goals):
            goals_ahead.publish(Path(poses=[each.target_pose for each in goals[i:]]))
            self.reach(goal)
        assert self.robot.speed_nearest_to(5.0, 1.5) > 0.8
        assert self.robot.speed_nearest_to(8.0, 1.2) > 0.8
        assert abs(self.robot.speed) < 0.1
        assert self.robot.pose == pytest.approx((11.0, 1.5, 0.0), abs=0.2)
        assert not self.robot.touched

    def test_goals_are_taken_again_after_time_has_jumped_back(self):
        self.reach(goal_at(4.0, 1.5))
        self.client.send_goal(goal_at(15.0, 1.5))
        rospy.wait_for_message("move_base/feedback", MoveBaseActionFeedback, WALL_PATIENCE)
        self.robot.restart_clock()
        assert self.client.wait_for_result(PATIENCE)
        assert self.client.get_goal_status_text() == "Aborting on goal because time jumped back"
        # The server that takes its place knows of no goal.
        while rospy.wait_for_message("move_base/status", GoalStatusArray, WALL_PATIENCE).status_list:
            pass
        self.robot.put(1.0, 1.5)
        self.reach(goal_at(4.0, 1.5))

    def test_a_costmap_that_is_never_published_is_sent_to_a_new_subscriber(self):
        assert rospy.wait_for_message("move_base/global_costmap/costmap", OccupancyGrid, WALL_PATIENCE).data

    def test_commands_come_at_the_controller_frequency_and_status_at_5_hz(self):
        status = []
        subscriber = rospy.Subscriber("move_base/status", GoalStatusArray, status.append)
        self.client.send_goal(goal_at(15.0, 1.5))
        rospy.sleep(4.0)
        subscriber.unregister()
        self.client.cancel_goal()
        driving = [time for time, _ in self.robot.commands]
        assert len(driving) / (driving[-1] - driving[0]) == pytest.approx(20.0, abs=4.0)
        assert len(status) / 4.0 == pytest.approx(5.0, abs=1.5)

    def test_commands_feedback_and_cancelling_go_on_while_a_plan_is_made(self):
        feedback = []
        subscriber = rospy.Subscriber("move_base/feedback", MoveBaseActionFeedback, feedback.append)
        self.client.send_goal(goal_at(15.0, 1.5))
        while self.robot.speed < 1.0:
            rospy.sleep(0.05)
        self.client.send_goal(goal_at(19.0, 1.475))
        del feedback[:]
        since = self.robot.now
        rospy.sleep(3.0)
        self.client.cancel_goal()
        assert self.client.wait_for_result(PATIENCE)
        subscriber.unregister()
        assert self.client.get_state() == GoalStatus.PREEMPTED
        commands = [command for time, command in self.robot.commands if time > since]
        # 60 on an idle machine; 2 if each plan had to be waited for.
        assert len(commands) > 15
        assert len(feedback) > 15
        assert commands[-1].linear.x == 0.0
        assert not self.robot.touched


if __name__ == "__main__":
    rospy.init_node("continuous_time_test")
    rostest.rosrun("move_base", "continuous_time_test", ContinuousTimeTest, sys.argv)
