#!/usr/bin/env python3
"""The services of gazebo_ros: cars and models come and go while the simulator runs."""

import math

import rospy
import rostest
from gazebo_api_case import BOX, FIRST, GazeboApiCase, pose
from gazebo_msgs.srv import (
    DeleteModel,
    GetModelProperties,
    GetPhysicsProperties,
    GetWorldProperties,
    SetPhysicsProperties,
    SpawnModel,
)
from geometry_msgs.msg import Point, Pose, Quaternion, Vector3
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from sim2d_process import Driver, car_description
from std_srvs.srv import Empty

SECOND = 1_000_000_000
SENSED = {"scan": LaserScan, "odom": Odometry}


class GazeboApiTest(GazeboApiCase):
    def test_simulator_starts_without_cars_and_gets_two(self):
        scans = self.collect(red__scan=LaserScan, blue__scan=LaserScan)
        self.start(cars={})
        assert self.names() == ["walls", "crate"]
        for name, y in (("red", 1.0), ("blue", -1.0)):
            answer = self.spawn(name, car_description(), 1.0, y, robot_namespace=f"/{name}")
            assert (answer.success, answer.status_message) == (
                True,
                "SpawnModel: Successfully spawned entity",
            )
        assert self.names() == ["walls", "crate", "red", "blue"]
        assert scans.wait_for(lambda seen: seen["/red/scan"] and seen["/blue/scan"])
        assert math.isclose(self.state("blue").pose.position.y, -1.0, abs_tol=1e-9)

    def test_frames_that_a_description_names_with_the_car_stay_apart(self):
        drive = (
            "<gazebo><plugin name='drive' filename='libgazebo_ros_diff_drive.so'>"
            "<commandTopic>cmd_vel</commandTopic><odometryTopic>odom</odometryTopic>"
            "<odometryFrame>{0}/odom</odometryFrame><robotBaseFrame>{0}/base_footprint</robotBaseFrame>"
            "</plugin></gazebo>"
        )
        topics = {f"{name}__{topic}": kind for name in ("red", "blue") for topic, kind in SENSED.items()}
        seen = self.collect(**topics)
        self.start(cars={})
        rospy.set_param("/blue/tf_prefix", "blue")
        self.addCleanup(rospy.delete_param, "/blue/tf_prefix")
        for name, y in (("red", 1.0), ("blue", -1.0)):
            xml = car_description(drive.format(name)).replace("<frameName>laser", f"<frameName>{name}/laser")
            assert self.spawn(name, xml, 1.0, y, robot_namespace=f"/{name}").success
        assert seen.wait_for(
            lambda messages: all(messages[f"/{name}/{topic}"] for name in ("red", "blue") for topic in SENSED)
        )
        for name in ("red", "blue"):
            assert seen.messages[f"/{name}/scan"][0].header.frame_id == f"{name}/laser"
            odometry = seen.messages[f"/{name}/odom"][0]
            frames = (odometry.header.frame_id, odometry.child_frame_id)
            assert frames == (f"{name}/odom", f"{name}/base_footprint")

    def test_car_that_is_deleted_publishes_nothing_more(self):
        rospy.set_param("/robot2/robot_description", car_description())
        scans = self.collect(robot1__scan=LaserScan, robot2__scan=LaserScan)
        self.start(cars={"robot1": {"y": 1.0}, "robot2": {"y": -1.0}})
        assert scans.wait_for(lambda seen: seen["/robot1/scan"] and seen["/robot2/scan"])
        answer = self.call("delete_model", DeleteModel, "robot1")
        assert (answer.success, answer.status_message) == (True, "DeleteModel: successfully deleted model")
        assert self.names() == ["walls", "crate", "robot2"]
        count = len(scans.messages["/robot2/scan"])
        assert scans.wait_for(lambda seen: len(seen["/robot2/scan"]) > count + 5)
        published = {topic for topic, _ in rospy.get_published_topics("/robot1")}
        assert "/robot1/scan" not in published

    def test_model_that_is_spawned_stands_in_the_way_until_it_is_deleted(self):
        scans = self.collect(robot1__scan=LaserScan)
        self.start()

        def sees(low, high):
            count = len(scans.messages["/robot1/scan"])
            return scans.wait_for(
                lambda seen: any(low < scan.ranges[540] < high for scan in seen["/robot1/scan"][count:])
            )

        assert self.spawn("box", BOX, 1.5, 0.0).success
        assert sees(0.9, 1.2)
        state = self.state("box")
        assert math.isclose(state.pose.position.z, 0.2, abs_tol=1e-6)
        assert not self.call("get_model_properties", GetModelProperties, "box").is_static
        assert self.call("delete_model", DeleteModel, "box").success
        assert sees(3.5, 4.0)

    def test_names_that_are_taken_or_unknown_are_refused(self):
        self.start_lockstep(FIRST)
        answer = self.spawn("crate", BOX, 1.0, 1.0)
        assert (answer.success, answer.status_message) == (
            False,
            "SpawnModel: Failure - model name crate already exist.",
        )
        answer = self.spawn("box", BOX, 1.0, 1.0, reference_frame="table")
        assert answer.status_message.startswith("SpawnModel: reference reference_frame not found")
        answer = self.call("delete_model", DeleteModel, "table")
        assert (answer.success, answer.status_message) == (False, "DeleteModel: model does not exist")
        answer = self.put(model_name="table")
        assert (answer.success, answer.status_message) == (False, "SetModelState: model does not exist")
        answer = self.put(model_name="crate", reference_frame="table")
        assert answer.status_message == "SetModelState: specified reference frame entity does not exist"

    def test_descriptions_and_places_that_cannot_be_are_refused(self):
        self.start_lockstep(FIRST)
        answer = self.spawn("box", "<robot", 1.0, 1.0)
        assert not answer.success
        assert answer.status_message.startswith("SpawnModel: Failure - description of box: ")
        assert self.spawn("block", BOX.replace("0.4 0.4 0.4", "4 4 0.4"), 0.0, 2.6).success
        answer = self.spawn("car", car_description(), 0.0, 2.6)
        assert not answer.success
        assert "is not free: it overlaps model block" in answer.status_message
        assert answer.status_message.endswith("and no place within a car's length is free")
        assert self.call("delete_model", DeleteModel, "block").success
        answer = self.put(model_name="robot1", pose=pose(3.9, 0.0))
        assert not answer.success
        assert answer.status_message.startswith("SetModelState: robot1: the pose (3.9, 0, 0) is not free")
        assert self.state("robot1").pose.position.x == 0.0
        assert self.names() == ["walls", "crate", "robot1"]

    def test_orientations_that_are_not_finite_are_refused(self):
        self.start_lockstep(FIRST)
        twisted = Pose(Point(1.0, 1.0, 0.0), Quaternion(0.0, 0.0, math.nan, 1.0))
        reason = "the orientation (x y z w) is 0 0 nan 1, allowed are finite numbers"
        answer = self.call(
            "spawn_urdf_model", SpawnModel, model_name="box", model_xml=BOX, initial_pose=twisted
        )
        assert (answer.success, answer.status_message) == (False, "SpawnModel: Failure - " + reason)
        answer = self.put(model_name="crate", pose=twisted)
        assert (answer.success, answer.status_message) == (False, "SetModelState: " + reason)
        assert self.names() == ["walls", "crate", "robot1"]

    def test_model_with_others_nested_in_it_comes_and_goes_as_one(self):
        self.start_lockstep(FIRST)
        sdf = "<sdf version='1.7'><model name='m'>{}</model></sdf>".format
        link = "<link name='l'><inertial><mass>1</mass></inertial></link>"
        brick = f"<model name='brick'>{link}</model>"
        for name, parts, names in (("box", brick, ["box"]), ("pair", link + brick, ["pair", "pair::brick"])):
            assert self.spawn(name, sdf(parts), 1.0, 1.0).success
            assert self.names() == ["walls", "crate", *names, "robot1"]
            assert self.state(name).pose.position.x == 1.0
            assert self.call("delete_model", DeleteModel, name).success
            assert self.names() == ["walls", "crate", "robot1"]
        answer = self.spawn("heap", sdf(brick + brick.replace("brick", "other")), 1.0, 1.0)
        assert not answer.success
        assert "has no <link> of its own" in answer.status_message
        assert self.names() == ["walls", "crate", "robot1"]

    def test_model_of_which_a_nested_one_cannot_be_leaves_nothing_behind(self):
        self.start_lockstep(FIRST)
        link = "<link name='l'><inertial><mass>1</mass></inertial></link>"
        xml = f"<sdf version='1.7'><model name='m'>{link}<model name='n'>{link}</model></model></sdf>"
        assert self.spawn("p::n", BOX, 2.0, 1.0).success
        answer = self.spawn("p", xml, 1.0, 1.0)
        assert (answer.success, answer.status_message) == (
            False,
            "SpawnModel: Failure - p::n: there is already a model of this name",
        )
        assert self.names() == ["walls", "crate", "p::n", "robot1"]

    def test_description_without_a_name_gets_the_one_asked_for(self):
        self.start_lockstep(FIRST)
        nameless = car_description().replace('<robot name="car">', '<robot name="">')
        for name, x in (("second", 1.0), ("third", 2.0)):
            assert self.spawn(name, nameless, x, 0.0).success
        assert self.spawn("box", BOX.replace('<robot name="box">', '<robot name="">'), 1.0, 1.0).success
        assert self.names() == ["walls", "crate", "box", "robot1", "second", "third"]

    def test_car_whose_place_is_not_free_comes_beside_it(self):
        sim2d = self.start_lockstep(FIRST)
        assert self.spawn("car", car_description(), 3.7, 0.0).success
        x = self.state("car").pose.position.x
        assert 3.3 < x < 3.7
        sim2d.stop()
        assert "car: the start pose (3.7, 0, 0) is not free: it overlaps model walls" in sim2d.stderr
        assert f"m beside it, at ({x:.2f}, " in sim2d.stderr

    def test_car_whose_topic_ros_does_not_take_leaves_nothing_behind(self):
        self.start_lockstep({})
        bad = car_description().replace(">scan<", ">my-scan!<")
        assert "my-scan!" in bad
        answer = self.spawn("bad", bad, 1.0, 1.0, robot_namespace="/bad")
        assert not answer.success
        assert "my-scan!" in answer.status_message
        assert self.names() == ["walls", "crate"]
        assert self.spawn("good", car_description(), 1.0, 1.0, robot_namespace="/good").success
        answer = self.call("delete_model", DeleteModel, "bad")
        assert (answer.success, answer.status_message) == (False, "DeleteModel: model does not exist")
        self.run_periods(4)
        assert self.call("delete_model", DeleteModel, "good").success
        self.run_periods(8)
        assert self.names() == ["walls", "crate"]

    def test_reset_after_cars_have_come_and_gone_is_as_from_fresh(self):
        rospy.set_param("/robot2/robot_description", car_description())
        changed = self.start_lockstep({"robot2": {"y": -1.0}, "robot1": {"y": 1.0}})
        self.run_periods(4)
        assert self.call("delete_model", DeleteModel, "robot1").success
        assert self.spawn("robot3", car_description(), 1.0, 1.0, robot_namespace="/robot3").success
        self.run_periods(6)
        assert self.call("delete_model", DeleteModel, "robot3").success
        self.stepper.restart()
        self.call("reset_simulation", Empty)
        self.run_periods(8)
        assert changed.stop() == 0
        fresh = self.start_lockstep({"robot2": {"y": -1.0}})
        self.run_periods(8)
        assert fresh.stop() == 0
        assert changed.result()["periods"] == fresh.result()["periods"] == 8
        assert changed.result()["trajectory_hash"] == fresh.result()["trajectory_hash"]

    def test_reset_world_brings_everything_back_but_not_time(self):
        self.start_lockstep(FIRST, participants=("robot1", "test"))
        driver = Driver("robot1", self.stepper)
        self.addCleanup(driver.close)
        driver.drive_to(SECOND, linear_x=1.0)
        assert self.put(model_name="crate", pose=pose(2.0, 1.0)).success
        assert self.state("robot1").pose.position.x > 0.2
        self.call("reset_world", Empty)
        assert self.state("robot1").pose.position.x == 0.0
        assert self.state("crate").pose.position.x == -3.0
        assert self.call("get_world_properties", GetWorldProperties).sim_time == 1.0

    def test_physics_properties_set_the_pace(self):
        clock = self.collect(clock=Clock)
        self.start(real_time_factor=0.001)
        physics = self.call("get_physics_properties", GetPhysicsProperties)
        assert (physics.time_step, physics.pause, physics.gravity.z) == (0.001, False, -9.8)
        assert math.isclose(physics.max_update_rate, 1.0)
        answer = self.set_physics(physics, max_update_rate=0.0)
        assert (answer.success, answer.status_message) == (True, "physics engine updated")
        assert clock.wait_for(lambda seen: any(m.clock.to_sec() > 10.0 for m in seen["/clock"]))
        assert self.call("get_physics_properties", GetPhysicsProperties).max_update_rate == 0.0

    def test_physics_properties_that_cannot_be_are_refused(self):
        self.start()
        physics = self.call("get_physics_properties", GetPhysicsProperties)
        answer = self.set_physics(physics, time_step=0.002)
        assert (answer.success, answer.status_message) == (
            False,
            "SetPhysicsProperties: time_step is 0.002, this simulator keeps 0.001",
        )
        answer = self.set_physics(physics, gravity=Vector3(0.0, 0.0, -1.6))
        assert answer.status_message == (
            "SetPhysicsProperties: gravity is (0, 0, -1.6), this simulator keeps (0, 0, -9.8)"
        )
        for rate in ("-1", "1e-09"):
            answer = self.set_physics(physics, max_update_rate=float(rate))
            assert (answer.success, answer.status_message) == (
                False,
                f"SetPhysicsProperties: max_update_rate is {rate}, "
                "allowed is 0 (as fast as it goes) or at least 0.001",
            )

    def set_physics(self, physics, **changes):
        fields = {"time_step": physics.time_step, "max_update_rate": 1000.0, "gravity": physics.gravity}
        return self.call("set_physics_properties", SetPhysicsProperties, **{**fields, **changes})


if __name__ == "__main__":
    rospy.init_node("gazebo_api_test")
    rostest.rosrun("f1tenth_sim2d", "sim2d_gazebo_api", GazeboApiTest)
