#!/usr/bin/env python3
"""The services of gazebo_ros that say and set where cars and models are and how they move."""

import math

import rospy
import rostest
from gazebo_api_case import FIRST, PERIOD, GazeboApiCase, pose
from gazebo_msgs.srv import GetLinkState, SpawnModel
from geometry_msgs.msg import Twist, Vector3
from sensor_msgs.msg import LaserScan
from sim2d_process import car_description
from std_srvs.srv import Empty

SDF = "<sdf version='1.7'><model name='m'>{}</model></sdf>".format
BOX_LINK = (
    "<link name='l'><inertial><mass>1</mass></inertial><collision name='c'><geometry><box>"
    "<size>0.4 0.4 0.4</size></box></geometry></collision></link>"
)
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

    def ahead(self, scans):
        """Return the range straight ahead, m, half a second from now."""
        self.periods += 20
        self.run_periods(self.periods)
        now = self.periods * PERIOD

        def last(seen):
            return next((scan for scan in seen["/robot1/scan"] if scan.header.stamp.to_nsec() >= now), None)

        assert scans.wait_for(last)
        return last(scans.messages).ranges[540]

    def check_heights(self, static, heights):
        """Spawn a box, put it to each height (m), and back with a reset; heights: wanted, seen, then."""
        self.periods = 1
        scans = self.collect(robot1__scan=LaserScan)
        self.start_lockstep(FIRST)
        box = SDF(f"{static}<pose>1 0 0.2 0 0 0</pose>{BOX_LINK}")
        assert self.spawn("box", box, 0.0, 0.0).success
        assert self.state("box").pose.position.z == 0.4
        for z, seen, height in heights:
            assert self.put(model_name="box", pose=pose(1.5, 0.0, z=z)).success
            assert math.isclose(self.state("box").pose.position.z, height, abs_tol=1e-9)
            assert (self.ahead(scans) < 2.0) == seen, z
        self.call("reset_world", Empty)
        assert (self.state("box").pose.position.x, self.state("box").pose.position.z) == (1.0, 0.4)

    def test_height_of_a_static_model_is_set(self):
        self.check_heights(
            "<static>true</static>", ((-10.0, False, -10.0), (0.0, True, 0.0), (10.0, False, 10.0))
        )

    def test_height_of_a_model_that_can_move_is_set_but_the_ground_pushes_it_out(self):
        self.check_heights("", ((-10.0, False, -10.0), (0.0, True, 0.2), (10.0, False, 10.0)))

    def test_a_car_cannot_be_put_below_the_ground(self):
        self.start_lockstep(FIRST)
        answer = self.put(model_name="robot1", pose=pose(1.0, 0.0, z=-10.0))
        assert (answer.success, answer.status_message) == (
            False,
            "SetModelState: robot1: z is -10 m, which is below the ground; a car stands on it",
        )
        assert self.put(model_name="robot1", pose=pose(1.0, 0.0, z=3.0)).success

    def test_a_name_without_those_around_it_is_found(self):
        self.start_lockstep({"robot1": {"x": 1.0}})
        answer = self.call("get_link_state", GetLinkState, "base_footprint", "")
        assert (answer.success, answer.link_state.pose.position.x) == (True, 1.0)
        assert self.put(model_name="robot1", pose=pose(0.5, 0.0), reference_frame="base_footprint").success
        assert math.isclose(self.state("robot1", "").pose.position.x, 1.5, abs_tol=1e-9)
        assert not self.state("footprint").success
        assert not self.state("").success
        assert not self.call("get_link_state", GetLinkState, "", "").success

    def test_a_spawned_model_keeps_the_pose_of_its_description(self):
        self.start_lockstep(FIRST)
        post = SDF(f"<pose>0 1 0.2 0 0 1.5</pose><static>true</static>{LINK}")
        answer = self.call("spawn_sdf_model", SpawnModel, "post", post, "", pose(1.0, 0.0, math.pi / 2), "")
        assert answer.success
        place = self.state("post").pose.position
        assert math.dist((place.x, place.y, place.z), (0.0, 0.0, 0.2)) < 1e-9
        car = car_description().replace("</robot>", '<origin xyz="0 0.5 0"/></robot>')
        assert self.spawn("robot2", car, -1.0, 0.0).success
        assert math.isclose(self.state("robot2").pose.position.y, 0.5, abs_tol=1e-9)

    def test_a_model_needs_a_name(self):
        self.start_lockstep(FIRST)
        answer = self.spawn("", SDF(LINK), 1.0, 0.0)
        assert (answer.success, answer.status_message) == (
            False,
            "SpawnModel: Failure - model_name is empty, allowed is a name that no model has",
        )


if __name__ == "__main__":
    rospy.init_node("gazebo_states_test")
    rostest.rosrun("f1tenth_sim2d", "sim2d_gazebo_states", GazeboStatesTest)
