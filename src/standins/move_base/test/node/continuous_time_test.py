#!/usr/bin/env python3
"""The node without lockstep: it keeps to its rate while time runs."""

import sys
import threading
import unittest
from xmlrpc.client import ServerProxy

import actionlib
import pytest
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus, GoalStatusArray
from fake_robot import FakeRobot, Room
from geometry_msgs.msg import PoseStamped, Twist
from hall_case import Listener
from move_base_msgs.msg import MoveBaseAction, MoveBaseActionFeedback, MoveBaseGoal
from nav_msgs.msg import OccupancyGrid

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


def action_connections():
    """The node's connections of its action, each with the number that it has as long as it lasts."""
    node = rospy.get_master().lookupNode("move_base")[2]
    _, _, connections = ServerProxy(node).getBusInfo(rospy.get_name())
    parts = ("goal", "cancel", "status", "result", "feedback")
    return {
        (number, direction, topic)
        for number, peer, direction, _, topic, *_ in connections
        if topic.startswith("/move_base/") and topic.split("/")[-1] in parts and peer == rospy.get_name()
    }


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

    def test_goals_are_taken_again_after_time_has_jumped_back(self):
        self.reach(goal_at(4.0, 1.5))
        is_accepted = threading.Event()
        self.client.send_goal(goal_at(15.0, 1.5), feedback_cb=lambda _: is_accepted.set())
        assert is_accepted.wait(WALL_PATIENCE)
        connections = action_connections()
        self.robot.restart_clock()
        assert self.client.wait_for_result(PATIENCE)
        assert self.client.get_goal_status_text() == "Aborting on goal because time jumped back"
        # The server that takes its place knows of no goal.
        while rospy.wait_for_message("move_base/status", GoalStatusArray, WALL_PATIENCE).status_list:
            pass
        assert connections <= action_connections()
        self.robot.put(1.0, 1.5)
        self.reach(goal_at(4.0, 1.5))

    def test_a_costmap_that_is_never_published_is_sent_to_a_new_subscriber(self):
        assert rospy.wait_for_message("move_base/global_costmap/costmap", OccupancyGrid, WALL_PATIENCE).data

    def listen(self, topic, message_type):
        listener = Listener(topic, message_type)
        self.addCleanup(listener.close)
        return listener

    def test_commands_come_at_the_controller_frequency_and_status_at_5_hz(self):
        status = self.listen("move_base/status", GoalStatusArray)
        self.client.send_goal(goal_at(15.0, 1.5))
        stamps = [each.header.stamp.to_sec() for each in status.wait(lambda seen: len(seen) > 12)[2:]]
        self.client.cancel_goal()
        driving = [time for time, _ in self.robot.commands]
        assert len(driving) / (driving[-1] - driving[0]) == pytest.approx(20.0, abs=4.0)
        assert (len(stamps) - 1) / (stamps[-1] - stamps[0]) == pytest.approx(5.0, abs=1.5)

    def test_commands_feedback_and_cancelling_go_on_while_a_plan_is_made(self):
        feedback = self.listen("move_base/feedback", MoveBaseActionFeedback)
        self.client.send_goal(goal_at(15.0, 1.5))
        feedback.wait(lambda _: self.robot.speed >= 1.0)
        self.client.send_goal(goal_at(19.0, 1.475))
        since, heard = self.robot.now, len(feedback.messages)

        def commands():
            return [command for time, command in self.robot.commands if time > since]

        feedback.wait(lambda seen: len(seen) > heard + 15 and len(commands()) > 15)
        # 0.8 s on an idle machine; if each plan had to be waited for there would be 2 in this time.
        assert self.robot.now - since < 3.0
        self.client.cancel_goal()
        assert self.client.wait_for_result(PATIENCE)
        assert self.client.get_state() == GoalStatus.PREEMPTED
        velocity = self.listen("cmd_vel", Twist)
        velocity.wait(lambda seen: seen and seen[-1].linear.x == 0.0)
        assert not self.robot.touched


if __name__ == "__main__":
    rospy.init_node("continuous_time_test")
    rostest.rosrun("move_base", "continuous_time_test", ContinuousTimeTest, sys.argv)
