#!/usr/bin/env python3
"""The services of gazebo_ros that say and set where cars and models are and how they move."""

import math

import rospy
import rostest
from gazebo_api_case import FIRST, GazeboApiCase, pose
from gazebo_msgs.srv import GetLinkState
from geometry_msgs.msg import Twist, Vector3

SDF = "<sdf version='1.7'><model name='m'>{}</model></sdf>".format
LINK = "<link name='l'><inertial><mass>1</mass></inertial></link>"


class GazeboStatesTest(GazeboApiCase):
    def test_state_is_set_in_the_frame_of_a_reference(self):
        self.start_lockstep({"robot1": {"x": 1.0, "yaw": math.pi / 2}})
        twist = Twist(linear=Vector3(1.0, 0.0, 0.0), angular=Vector3(0.0, 0.0, 0.5))
        assert self.put(
            model_name="crate", pose=pose(1.0, 0.0), twist=twist, reference_frame="robot1"
        ).success
        crate = self.state("crate")
        assert math.isclose(crate.pose.position.x, 1.0, abs_tol=1e-5)
        assert math.isclose(crate.pose.position.y, 1.0, abs_tol=1e-5)
        assert math.isclose(crate.twist.linear.y, 1.0, abs_tol=1e-5)
        assert math.isclose(crate.twist.angular.z, 0.5, abs_tol=1e-5)
        assert self.put(model_name="robot1", pose=pose(-1.0, -0.5, 0.3), twist=twist).success
        car = self.state("robot1")
        assert math.isclose(car.pose.position.x, -1.0, abs_tol=1e-9)
        assert math.isclose(car.twist.linear.x, 1.0, abs_tol=1e-9)
        assert math.isclose(car.twist.angular.z, 0.5, abs_tol=1e-9)

    def test_twist_is_relative_to_the_motion_of_the_reference(self):
        self.start_lockstep({"robot1": {"x": 1.0, "yaw": math.pi / 2}})
        car = Twist(linear=Vector3(1.0, 0.0, 0.0), angular=Vector3(0.0, 0.0, 0.5))
        crate = Twist(linear=Vector3(0.0, 3.0, 0.0), angular=Vector3(0.0, 0.0, 0.2))
        assert self.put(model_name="robot1", pose=pose(1.0, 0.0, math.pi / 2), twist=car).success
        assert self.put(model_name="crate", pose=pose(-1.0, 0.0), twist=crate).success

        def assert_twist(seen, x, y, turn):
            assert math.isclose(seen.linear.x, x, abs_tol=1e-5)
            assert math.isclose(seen.linear.y, y, abs_tol=1e-5)
            assert math.isclose(seen.angular.z, turn, abs_tol=1e-5)

        assert_twist(self.state("robot1").twist, 1.0, 0.0, 0.5)
        assert_twist(self.state("robot1", "robot1").twist, 0.0, 0.0, 0.0)
        assert_twist(self.state("crate", "robot1").twist, 3.0, 1.0, -0.3)
        link = self.call("get_link_state", GetLinkState, "robot1::base_footprint", "crate").link_state
        assert_twist(link.twist, 1.0, -3.0, 0.3)

    def test_header_of_a_state_names_the_reference_and_counts_the_requests(self):
        self.start_lockstep(FIRST)
        headers = [self.state(name, frame).header for name, frame in (("robot1", ""), ("robot1", "crate"))]
        assert [(header.seq, header.frame_id) for header in headers] == [(1, ""), (2, "crate")]
        assert self.state("crate").header.seq == 1

    def test_models_that_are_nested_in_one_are_put_along_with_it(self):
        self.start_lockstep({})
        brick = f"<model name='n'><pose>1 0 0 0 0 0</pose>{LINK}</model>"
        static = "<static>true</static>"
        for name, y, xml in (("q", 1.0, SDF(LINK + brick)), ("s", -1.0, SDF(static + LINK + brick))):
            assert self.spawn(name, xml, -3.0, y).success
            assert self.put(model_name=name, pose=pose(-1.0, y, math.pi / 2)).success
            nested = self.state(f"{name}::n", name).pose
            assert math.isclose(nested.position.x, 1.0, abs_tol=1e-5)
            assert math.isclose(nested.position.y, 0.0, abs_tol=1e-5)
            assert math.isclose(nested.orientation.z, 0.0, abs_tol=1e-5)


if __name__ == "__main__":
    rospy.init_node("gazebo_states_test")
    rostest.rosrun("f1tenth_sim2d", "sim2d_gazebo_states", GazeboStatesTest)
