#!/usr/bin/env python3
"""Goals, their end states and what the car does meanwhile, to the letter of the original, in lockstep."""

import copy
import itertools
import math
import sys

import actionlib
import pytest
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from fake_robot import FUTURE
from geometry_msgs.msg import PoseStamped, Quaternion
from hall_case import PATIENCE, HallCase, Listener, pose_at
from move_base_msgs.msg import (
    MoveBaseAction,
    MoveBaseActionFeedback,
    MoveBaseActionResult,
    MoveBaseGoal,
    RecoveryStatus,
)
from nav_msgs.msg import Path
from rosgraph_msgs.msg import Log


def told_by(messages):
    """Level and text of what move_base says of itself."""
    return [(status.level, status.message) for message in messages for status in message.status]


class MoveBaseTest(HallCase):
    def test_a_goal_is_reached(self):
        feedback = Listener("move_base/feedback", MoveBaseActionFeedback)
        self.send(pose_at(6.0, 2.0))
        self.assert_result(GoalStatus.SUCCEEDED, "Goal reached.")
        self.assert_stands_at(6.0, 2.0)
        self.assert_stopped()
        assert feedback.wait()[0].feedback.base_position.header.frame_id == "map"

    def test_a_goal_may_come_in_another_frame(self):
        self.send(pose_at(1.5, 0.0, frame="base_footprint"))
        assert self.result()[0] == GoalStatus.SUCCEEDED
        assert self.robot.pose[0] == pytest.approx(2.5, abs=0.2)

    def test_a_goal_in_an_unknown_frame_is_aborted(self):
        self.send(pose_at(2.0, 1.0, frame="nowhere"))
        state, text = self.result()
        assert state == GoalStatus.ABORTED
        assert 'cannot be transformed from frame "nowhere" to "map"' in text

    def test_an_invalid_quaternion_is_aborted(self):
        for quaternion in (
            Quaternion(),
            Quaternion(0.5, 0.5, 0.5, 0.5),
            Quaternion(0.0, 0.0, float("nan"), 1.0),
        ):
            pose = pose_at(2.0, 1.0)
            pose.pose.orientation = quaternion
            self.send(pose)
            text = "Aborting on goal because it was sent with an invalid quaternion"
            self.assert_result(GoalStatus.ABORTED, text)

    def test_without_a_plan_it_is_aborted_after_recovery(self):
        recoveries = Listener("move_base/recovery_status", RecoveryStatus)
        diagnostics = Listener("/diagnostics", DiagnosticArray)
        log = Listener("/rosout", Log)
        self.robot.real_room = copy.deepcopy(self.room)
        self.robot.real_room.add_wall(2.8, 0.8, 3.2, 1.2)
        self.send(pose_at(3.0, 1.0))
        reason = "The lidar sees something at the goal."
        text = f"Failed to find a valid plan. Even after executing recovery behaviors. {reason}"
        self.assert_result(GoalStatus.ABORTED, text)
        self.assert_stopped()
        names = [m.recovery_behavior_name for m in recoveries.wait(lambda messages: len(messages) == 2)]
        assert names == ["forget_far", "turn"]
        log.wait(lambda messages: any(m.name == "/move_base" and m.msg == text for m in messages))
        assert [m.current_recovery_number for m in recoveries.messages] == [0, 1]
        assert {m.total_number_of_recoveries for m in recoveries.messages} == {2}
        told = told_by(diagnostics.wait(lambda messages: (DiagnosticStatus.ERROR, text) in told_by(messages)))
        assert told.index((DiagnosticStatus.WARN, reason)) < told.index((DiagnosticStatus.ERROR, text))

    def test_a_goal_that_the_map_excludes_is_aborted_at_once_with_the_reason(self):
        reasons = {
            (4.1, 1.0): "The goal is in a wall.",
            (30.0, 1.0): "The goal is outside of the map.",
            (10.5, 5.0): "No way leads to the goal.",
        }
        for (x, y), reason in reasons.items():
            self.send(pose_at(x, y))
            self.assert_result(GoalStatus.ABORTED, f"Failed to find a valid plan. {reason}")
            self.assert_stopped()

    def test_a_car_that_stands_still_says_why(self):
        diagnostics = Listener("/diagnostics", DiagnosticArray)
        self.drive_off(pose_at(6.0, 2.0))
        self.robot.scan_works = False
        why = (
            "The car brakes or stands still because the scan on /scan is missing, or its stamp is too old or"
            " in the future. On a slow machine, start with real_time_factor:=0.5."
        )
        diagnostics.wait(lambda messages: (DiagnosticStatus.WARN, why) in told_by(messages))
        self.robot.scan_works = True
        self.assert_result(GoalStatus.SUCCEEDED, "Goal reached.")
        diagnostics.wait(lambda messages: told_by(messages)[-1] == (DiagnosticStatus.OK, "No goal"))
        assert diagnostics.messages[-1].status[0].values[0].value == "base_footprint"

    def test_without_control_it_is_aborted_after_recovery(self):
        self.robot.put(6.0, 1.0)
        self.send(pose_at(10.5, 1.0))
        text = "Failed to find a valid control. Even after executing recovery behaviors."
        self.assert_result(GoalStatus.ABORTED, text)
        self.assert_stopped()

    def test_a_car_that_gets_nowhere_is_aborted_after_recovery(self):
        self.robot.wheels_grip = False
        self.send(pose_at(3.0, 1.0))
        text = "Robot is oscillating. Even after executing recovery behaviors."
        self.assert_result(GoalStatus.ABORTED, text)
        self.assert_stopped()

    def test_cancelling_stops_the_car(self):
        self.drive_off(pose_at(6.0, 2.0))
        self.client.cancel_goal()
        assert self.result()[0] == GoalStatus.PREEMPTED
        self.assert_stopped()

    def test_a_new_goal_preempts_the_old_one(self):
        self.drive_off(pose_at(6.0, 2.0))
        other = actionlib.SimpleActionClient("move_base", MoveBaseAction)
        assert other.wait_for_server(PATIENCE)
        other.send_goal(MoveBaseGoal(pose_at(3.0, 4.5)))
        assert self.result()[0] == GoalStatus.PREEMPTED
        assert other.wait_for_result(PATIENCE)
        assert other.get_state() == GoalStatus.SUCCEEDED
        assert self.robot.pose[1] == pytest.approx(4.5, abs=0.2)

    def test_the_car_stands_still_while_the_scan_is_stale(self):
        self.drive_off(pose_at(6.0, 2.0))
        self.robot.scan_works = False
        silence = self.robot.now
        rospy.sleep(1.5)
        late = [command for time, command in self.robot.commands if time > silence + 0.8]
        assert late
        assert {command.linear.x for command in late} == {0.0}
        self.robot.scan_works = True
        self.assert_result(GoalStatus.SUCCEEDED, "Goal reached.")

    def test_the_car_brakes_to_a_stand_whatever_input_is_missing(self):
        alone = [
            {name: fault} for name in ("scan", "odom", "tf") for fault in ("stopped", "frozen", "future")
        ]
        pairs = [dict.fromkeys(pair, "stopped") for pair in itertools.combinations(("scan", "odom", "tf"), 2)]
        for faults in alone + pairs:
            with self.subTest(faults):
                self.robot.put(1.0, 1.0)
                self.drive_off(pose_at(6.0, 2.0))
                self.robot.faults = faults
                since = self.robot.now
                self.wait_until(lambda since=since: self.robot.now > since + 2.5)
                # Braking from 1.5 m/s with 2 m/s^2, after a timeout of up to 0.3 s.
                late = [command for time, command in self.robot.commands if time > since + 1.4]
                assert late
                assert {command.linear.x for command in late} == {0.0}
                assert not self.robot.touched
                self.client.cancel_goal()
                self.result()
                self.robot.faults = {}
                since = self.robot.now
                self.wait_until(lambda since=since: self.robot.now > since + FUTURE.to_sec() + 0.1)

    def test_the_car_stops_while_everything_is_late_and_goes_on_afterwards(self):
        self.drive_off(pose_at(6.0, 2.0))
        self.robot.delay = 8
        self.wait_until(lambda: self.robot.speed == 0.0)
        stopped = self.robot.now
        self.wait_until(lambda: self.robot.now > stopped + 1.0)
        assert self.robot.speed == 0.0
        self.robot.delay = 0
        self.assert_result(GoalStatus.SUCCEEDED, "Goal reached.")
        assert not self.robot.touched

    def test_what_the_map_does_not_know_is_driven_around(self):
        room = copy.deepcopy(self.room)
        room.add_wall(5.8, 3.3, 6.2, 4.5)
        self.robot.real_room = room
        self.robot.put(5.0, 4.0)
        self.send(pose_at(8.0, 3.5))
        self.assert_result(GoalStatus.SUCCEEDED, "Goal reached.")
        assert not self.robot.touched

    def test_scans_wait_for_transforms_that_come_after_them(self):
        room = copy.deepcopy(self.room)
        room.add_wall(5.8, 3.3, 6.2, 4.5)
        self.robot.put(5.0, 4.0)
        self.robot.transforms_delay = 2
        late = self.robot.now
        self.wait_until(lambda: self.robot.now > late + 0.2)
        self.robot.real_room = room
        self.send(pose_at(8.0, 3.5))
        self.assert_result(GoalStatus.SUCCEEDED, "Goal reached.")
        assert not self.robot.touched

    def test_a_simple_goal_ends_at_a_standstill(self):
        results = Listener("move_base/result", MoveBaseActionResult)
        publisher = rospy.Publisher("move_base_simple/goal", PoseStamped, queue_size=1)
        self.wait_until(lambda: publisher.get_num_connections() > 0 and results.connected())
        publisher.publish(pose_at(6.0, 2.0, -0.3))
        results.wait()
        self.assert_stands_at(6.0, 2.0, -0.3)

    def announce(self, *goals):
        self.goals_ahead.publish(Path(poses=list(goals)))

    def test_the_plain_planner_stops_at_goals_that_another_one_follows(self):
        goals = [pose_at(2.0, 4.0, 0.5 * math.pi), pose_at(3.5, 5.0)]
        for i, goal in enumerate(goals):
            self.announce(*goals[i:])
            self.send(goal)
            self.assert_result(GoalStatus.SUCCEEDED, "Goal reached.")
            assert abs(self.robot.speed) < 0.06
        self.assert_stands_at(3.5, 5.0)

    def test_goals_where_the_car_does_not_fit_are_told_when_it_sets_off(self):
        text = "Of the goals to come, the one at (4.10, 1.00): The goal is in a wall."
        for begin, x in ((self.announce_and_send, 3.0), (self.send_and_announce, 2.5)):
            log = self.listen("/rosout", Log)
            begin(pose_at(x, 1.0), pose_at(4.1, 1.0))
            log.wait(lambda messages: any(m.msg == text for m in messages))
            self.assert_result(GoalStatus.SUCCEEDED, "Goal reached.")
            assert [m.msg for m in log.messages].count(text) == 1
            self.robot.put(1.0, 1.0)

    def announce_and_send(self, *goals):
        self.announce(*goals)
        self.send(goals[0])

    def send_and_announce(self, *goals):
        """The goal is followed when those behind it become known."""
        followed = self.listen("move_base/current_goal", PoseStamped)
        self.send(goals[0])
        followed.wait()
        self.announce(*goals)

    def test_a_goal_is_not_passed_because_another_one_was_followed(self):
        self.announce(pose_at(5.0, 1.0), pose_at(6.0, 2.0))
        self.send(pose_at(3.0, 1.0))
        self.assert_result(GoalStatus.SUCCEEDED, "Goal reached.")
        self.assert_stands_at(3.0, 1.0)


if __name__ == "__main__":
    rospy.init_node("move_base_test")
    rostest.rosrun("move_base", "move_base_test", MoveBaseTest, sys.argv)
