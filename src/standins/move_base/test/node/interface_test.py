#!/usr/bin/env python3
"""The node's topics, services and parameters, to the letter of the original, with a car in lockstep."""

import socket
import subprocess
import sys

import numpy as np
import pytest
import rospy
import rostest
from actionlib_msgs.msg import GoalStatusArray
from geometry_msgs.msg import PolygonStamped, PoseStamped
from hall_case import WALL_PATIENCE, HallCase, Listener, make_room, pose_at
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import OccupancyGrid, Path
from nav_msgs.srv import GetPlan


def cells_of(grid):
    """The cells of a costmap, rows from below."""
    return np.array(grid.data, np.int8).reshape(grid.info.height, grid.info.width)


def with_updates(grid, updates):
    """The cells of a costmap with the rectangles that were sent after it."""
    cells = cells_of(grid)
    for update in updates:
        if update.header.stamp > grid.header.stamp:
            part = cells[update.y : update.y + update.height, update.x : update.x + update.width]
            part[:] = np.reshape(update.data, part.shape)
    return cells


def run_with(parameters):
    """The node that has ended, because one of these parameters was wrong."""
    rospy.set_param("wrong", parameters)
    command = ["rosrun", "move_base", "move_base", "__name:=wrong"]
    return subprocess.run(command, capture_output=True, text=True, timeout=WALL_PATIENCE, check=False)


class InterfaceTest(HallCase):
    def test_the_action_is_up_only_with_all_that_driving_needs(self):
        assert "/move_base/status" not in self.topics_before
        assert "/move_base/status" in dict(rospy.get_published_topics())

    def test_goals_and_cancels_come_without_delay(self):
        for publisher in (self.client.action_client.pub_goal, self.client.action_client.pub_cancel):
            connections = publisher.impl.connections
            assert connections
            for connection in connections:
                assert connection.socket.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY)

    def test_plans_come_under_the_planners_names_too(self):
        names = ("NavfnROS/plan", "TebLocalPlannerROS/global_plan", "TebLocalPlannerROS/local_plan")
        listeners = [Listener(f"move_base/{name}", Path) for name in names]
        self.wait_until(lambda: all(each.connected() for each in listeners))
        self.send(pose_at(3.0, 1.0))
        self.result()
        for listener in listeners:
            assert listener.wait()[-1].poses

    def test_the_status_comes_five_times_a_second(self):
        listener = Listener("move_base/status", GoalStatusArray)
        start = self.robot.now
        self.wait_until(lambda: self.robot.now > start + 4.0)
        assert 16 <= len(listener.messages) <= 24

    def test_a_simple_goal_is_relayed_to_the_action(self):
        goals = Listener("move_base/current_goal", PoseStamped)
        publisher = rospy.Publisher("move_base_simple/goal", PoseStamped, queue_size=1)
        self.wait_until(lambda: publisher.get_num_connections() > 0 and goals.connected())
        publisher.publish(pose_at(2.5, 1.0))
        assert goals.wait()[0].pose.position.x == pytest.approx(2.5)
        self.wait_until(lambda: self.robot.pose[0] > 2.3 and self.robot.speed == 0.0)

    def test_make_plan_plans_without_driving(self):
        make_plan = rospy.ServiceProxy("move_base/make_plan", GetPlan)
        plan = make_plan(start=pose_at(1.0, 1.0), goal=pose_at(6.0, 2.0), tolerance=0.0).plan
        assert plan.header.frame_id == "map"
        assert plan.poses[0].pose.position.x == pytest.approx(1.0, abs=1e-3)
        assert plan.poses[-1].pose.position.x == pytest.approx(6.0, abs=1e-3)
        assert self.robot.speed == 0.0

    def test_make_plan_starts_at_the_car_unless_told(self):
        make_plan = rospy.ServiceProxy("move_base/make_plan", GetPlan)
        plan = make_plan(start=PoseStamped(), goal=pose_at(3.0, 1.0), tolerance=0.0).plan
        assert plan.poses[0].pose.position.x == pytest.approx(1.0, abs=0.05)

    def test_make_plan_is_empty_where_no_way_leads(self):
        make_plan = rospy.ServiceProxy("move_base/make_plan", GetPlan)
        assert make_plan(start=pose_at(1.0, 1.0), goal=pose_at(10.5, 5.0), tolerance=0.0).plan.poses == []

    def test_make_plan_fails_while_a_goal_is_pursued(self):
        make_plan = rospy.ServiceProxy("move_base/make_plan", GetPlan)
        self.drive_off(pose_at(6.0, 2.0))
        with pytest.raises(rospy.ServiceException):
            make_plan(start=pose_at(1.0, 1.0), goal=pose_at(6.0, 2.0), tolerance=0.0)
        self.client.cancel_goal()
        self.result()

    def test_plans_and_costmaps_are_shown(self):
        listeners = {
            "global_plan": self.listen("move_base/global_plan", Path),
            "local_plan": self.listen("move_base/local_plan", Path),
            "global_costmap": self.listen("move_base/global_costmap/costmap", OccupancyGrid),
            "local_costmap": self.listen("move_base/local_costmap/costmap", OccupancyGrid),
            "global_footprint": self.listen("move_base/global_costmap/footprint", PolygonStamped),
            "local_footprint": self.listen("move_base/local_costmap/footprint", PolygonStamped),
        }
        self.send(pose_at(6.0, 2.0))
        self.result()
        frames = {name: listener.wait()[-1].header.frame_id for name, listener in listeners.items()}
        assert frames == {
            "global_plan": "map",
            "local_plan": "odom",
            "global_costmap": "map",
            "local_costmap": "odom",
            "global_footprint": "map",
            "local_footprint": "odom",
        }
        assert len(listeners["global_costmap"].messages[-1].data) == self.room.cells.size
        local = listeners["local_costmap"].messages[-1]
        assert (local.info.width, local.info.height) == (80, 80)
        assert {100, 0} <= set(local.data)
        assert -1 not in local.data

    def test_a_costmap_is_sent_whole_to_a_new_subscriber_and_then_what_changes(self):
        updates = self.listen("move_base/global_costmap/costmap_updates", OccupancyGridUpdate)
        first = self.listen("move_base/global_costmap/costmap", OccupancyGrid)
        before = first.wait()[0]
        self.robot.real_room = make_room()
        self.robot.real_room.add_wall(2.5, 0.9, 2.7, 1.1)
        updates.wait(lambda messages: any(100 in message.data for message in messages))
        assert len(first.messages) == 1
        assert all(len(update.data) < len(before.data) for update in updates.messages)
        first.close()
        second = self.listen("move_base/global_costmap/costmap", OccupancyGrid)
        cells = cells_of(second.wait()[0])
        assert (cells[18:22, 48:52] == 100).any()
        self.wait_until(lambda: np.array_equal(with_updates(before, updates.messages), cells))

    def test_a_costmap_may_always_be_sent_whole(self):
        updates = self.listen("move_base/local_costmap/costmap_updates", OccupancyGridUpdate)
        whole = self.listen("move_base/local_costmap/costmap", OccupancyGrid)
        whole.wait(lambda messages: len(messages) > 3)
        assert updates.messages == []

    def test_a_wrong_parameter_ends_the_node_with_one_clear_line(self):
        wrong = {
            "max_vel_x": ("fast", 'parameter /wrong/max_vel_x: found "fast", must be a finite number'),
            "controller_frequency": (0.0, "controller_frequency: found 0, must be a number > 0"),
            "footprint": ([[0.0]], "must be a list of points, [[x, y], ...]"),
            "sensor_timeout": (-1.0, "sensor_timeout: found -1, must be a number > 0"),
            "lockstep": (3, "must be true or false"),
            "max_planning_retries": (0.5, "must be a whole number"),
            "base_local_planner": (1, "must be a text"),
            "base_global_planner": (
                "nobody/Planner",
                "must be PACKAGE/CLASS of a library libPACKAGE_planners.so",
            ),
            "max_steering_angle": (0.2, "parameter /wrong/min_turning_radius: found 0.8, must be at least"),
        }
        for name, (value, message) in wrong.items():
            run = run_with({name: value})
            assert run.returncode == 1, name
            assert message in run.stderr
            assert name in run.stderr
            assert run.stderr.count("move_base: ") == 1, run.stderr

    def test_parameters_of_files_for_the_original_are_taken(self):
        last = 'for_the_original: found "", must be a list of names'
        dwa = {"base_local_planner": "dwa_local_planner/DWAPlannerROS"}
        teb = {"base_local_planner": "teb_local_planner/TebLocalPlannerROS"}
        files = [
            (
                {**dwa, "DWAPlannerROS": {"min_vel_x": 0.0}},
                "DWAPlannerROS: min_vel_x is 0, the least speed is",
            ),
            ({**dwa, "DWAPlannerROS": {"min_vel_x": -0.22, "max_vel_x": 0.1}}, "the least speed is 0.1 m/s"),
            ({**teb, "TebLocalPlannerROS": {"wheelbase": 0.25, "min_turning_radius": 0.5}}, last),
        ]
        for parameters, text in files:
            # The last parameter that is read ends the node.
            run = run_with({**parameters, "for_the_original": ""})
            assert last in run.stderr
            assert text in run.stderr

    def test_a_message_names_the_parameter_where_it_is(self):
        parameters = {"TrajectoryPlannerROS": {"max_vel_x": 0.5, "min_vel_x": 0.6}}
        message = "parameter /wrong/TrajectoryPlannerROS/min_vel_x: found 0.6, must be above 0 and"
        assert message in run_with(parameters).stderr

    def test_make_plan_ends_within_the_tolerance_where_no_way_leads_to_the_goal(self):
        make_plan = rospy.ServiceProxy("move_base/make_plan", GetPlan)
        goal = pose_at(4.1, 2.0)
        assert make_plan(start=PoseStamped(), goal=goal, tolerance=0.1).plan.poses == []
        poses = make_plan(start=PoseStamped(), goal=goal, tolerance=1.0).plan.poses
        assert poses[-1].pose.position.x == pytest.approx(4.1), "the goal itself, as with the original"
        assert abs(poses[-2].pose.position.x - 4.1) <= 1.001

    def test_the_global_planner_makes_plans_under_its_own_name(self):
        make_plan = rospy.ServiceProxy("move_base/NavfnROS/make_plan", GetPlan)
        assert make_plan(start=pose_at(1.0, 1.0), goal=pose_at(3.0, 1.0), tolerance=0.0).plan.poses

    def test_plans_are_not_latched(self):
        plans = Listener("move_base/global_plan", Path)
        self.wait_until(plans.connected)
        self.send(pose_at(3.0, 1.0))
        self.result()
        assert plans.wait()[-1]._connection_header["latching"] == "0"


if __name__ == "__main__":
    rospy.init_node("interface_test")
    rostest.rosrun("move_base", "interface_test", InterfaceTest, sys.argv)
