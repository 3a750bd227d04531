#!/usr/bin/env python3
"""What is done to the running simulation is noted with its caller, and no reset destroys what was."""

import json
import pathlib

import rosgraph
import rospy
import rostest
from gazebo_api_case import BOX, FIRST, GazeboApiCase, pose
from gazebo_msgs.msg import ModelState
from gazebo_msgs.srv import DeleteModel, SpawnModel
from sim2d_process import Driver, Sim2d, car_description, wait_for_subscriber
from std_srvs.srv import Empty

SECOND = 1_000_000_000
WALL_AHEAD = (
    "<robot name='block'><link name='block'><inertial><mass value='500'/>"
    "<inertia ixx='9' ixy='0' ixz='0' iyy='9' iyz='0' izz='9'/></inertial>"
    "<collision><geometry><box size='0.2 4 1'/></geometry></collision></link></robot>"
)


# Services that change something, and those that only tell; a new one needs a place here, and the tests below.
CHANGES = {
    "delete_model",
    "pause_physics",
    "reset_simulation",
    "reset_world",
    "set_model_state",
    "set_physics_properties",
    "spawn_sdf_model",
    "spawn_urdf_model",
    "unpause_physics",
}
QUESTIONS = {
    "get_link_state",
    "get_model_properties",
    "get_model_state",
    "get_physics_properties",
    "get_world_properties",
}
TOPICS = {"/gazebo/set_model_state", "/robot1/cmd_vel", "/robot1/drive", "/sim2d/done"}
SDF_BOX = (
    "<sdf version='1.6'><model name='chest'><link name='chest'><collision name='chest'><geometry>"
    "<box><size>0.1 0.1 0.1</size></box></geometry></collision></link></model></sdf>"
)


class InterventionsTest(GazeboApiCase):
    def start_recorded(self):
        self.sim2d = self.start_lockstep(FIRST, participants=("robot1", "test"))
        driver = Driver("robot1", self.stepper)
        self.addCleanup(driver.close)
        return driver

    def interventions(self):
        return [json.loads(line) for line in self.sim2d.interventions_file.read_text().splitlines()]

    def test_every_change_is_noted_with_its_time_and_caller(self):
        driver = self.start_recorded()
        driver.drive_to(SECOND, linear_x=0.5)
        assert self.spawn("box", BOX, 2.0, 2.0).success
        assert self.put(model_name="box", pose=pose(2.0, -2.0)).success
        assert self.call("spawn_sdf_model", SpawnModel, "chest", SDF_BOX, "", pose(4.0, 2.0), "").success
        self.call("pause_physics", Empty)
        self.call("unpause_physics", Empty)
        assert self.call("delete_model", DeleteModel, "box").success
        self.call("reset_world", Empty)
        self.call("reset_simulation", Empty)
        seen = self.interventions()
        assert [(each["kind"], each["model"]) for each in seen] == [
            ("spawn_urdf_model", "box"),
            ("set_model_state", "box"),
            ("spawn_sdf_model", "chest"),
            ("pause_physics", ""),
            ("unpause_physics", ""),
            ("delete_model", "box"),
            ("reset_world", ""),
            ("reset_simulation", ""),
        ]
        assert {(each["time"], each["caller"]) for each in seen} == {(1.0, rospy.get_name())}

    def test_nothing_that_others_can_call_or_send_is_missing_here(self):
        self.start_recorded()
        _, heard, served = rosgraph.Master("/test").getSystemState()
        services = {name for name, nodes in served if nodes == ["/sim2d"] and name.startswith("/gazebo/")}
        assert {each.removeprefix("/gazebo/") for each in services} == {*CHANGES, *QUESTIONS}
        assert {topic for topic, nodes in heard if "/sim2d" in nodes} == TOPICS

    def test_place_given_on_the_topic_is_noted_too(self):
        self.start_recorded()
        publisher = rospy.Publisher("/gazebo/set_model_state", ModelState, queue_size=1)
        self.addCleanup(publisher.unregister)
        wait_for_subscriber(publisher)
        publisher.publish(ModelState(model_name="robot1", pose=pose(1.0, 0.0)))
        while abs(self.state("robot1").pose.position.x - 1.0) > 1e-6:
            pass
        assert [(each["kind"], each["model"]) for each in self.interventions()] == [
            ("set_model_state", "robot1")
        ]

    def test_what_is_refused_changes_nothing_and_is_not_noted(self):
        self.start_recorded()
        assert not self.call("delete_model", DeleteModel, "nobody").success
        assert not self.put(model_name="nobody", pose=pose(0.0, 0.0)).success
        assert self.interventions() == []

    def test_contact_just_before_a_reset_stays_on_record(self):
        driver = self.start_recorded()
        assert self.spawn("block", WALL_AHEAD, 1.0, 0.0).success
        driver.drive_to(2 * SECOND, linear_x=2.0)
        self.call("reset_simulation", Empty)
        self.stepper.restart()
        driver.drive_to(SECOND // 2, linear_x=0.0)
        assert self.sim2d.stop() == 0
        before = pathlib.Path(f"{self.sim2d.record_file}.before_reset_1").read_text()
        assert ",block," in before
        assert ",block," not in self.sim2d.record_file.read_text()

    def test_file_that_cannot_be_written_is_an_error(self):
        sim2d = Sim2d(car_description(), interventions="/nowhere/interventions.jsonl")
        self.addCleanup(sim2d.kill)
        assert sim2d.wait() == 2
        assert "interventions: cannot write /nowhere/interventions.jsonl" in sim2d.stderr


if __name__ == "__main__":
    rospy.init_node("interventions_test")
    rostest.rosrun("f1tenth_sim2d", "sim2d_interventions", InterventionsTest)
