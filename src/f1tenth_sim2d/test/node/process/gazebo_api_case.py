"""What the tests of the services of gazebo_ros have in common."""

import math
import unittest

import rospy
from gazebo_msgs.msg import ModelState
from gazebo_msgs.srv import GetModelState, GetWorldProperties, SetModelState, SpawnModel
from geometry_msgs.msg import Point, Pose, Quaternion
from sim2d_process import LONG, Collector, Sim2d, Stepper, car_description

PERIOD = 25_000_000
BOX = """<robot name="box"><link name="box">
<inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
<collision><geometry><box size="0.4 0.4 0.4"/></geometry></collision></link></robot>"""
FIRST = {"robot1": {"x": 0.0}}


def pose(x, y, yaw=0.0, z=0.0):
    """Return a Pose on the ground."""
    return Pose(Point(x, y, z), Quaternion(0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)))


class GazeboApiCase(unittest.TestCase):
    """A simulator and calls of its services."""

    def start(self, **parameters):
        sim2d = Sim2d(car_description(), **parameters)
        self.addCleanup(sim2d.kill)
        rospy.wait_for_service("/gazebo/set_physics_properties", LONG)
        return sim2d

    def start_lockstep(self, cars, participants=("test",)):
        self.stepper = Stepper()
        self.addCleanup(self.stepper.close)
        sim2d = self.start(lockstep=True, participants=list(participants), cars=cars)
        self.stepper.advance_to(PERIOD)
        return sim2d

    def collect(self, **topics):
        collector = Collector(**topics)
        self.addCleanup(collector.close)
        return collector

    def call(self, name, kind, *arguments, **fields):
        rospy.wait_for_service("/gazebo/" + name, LONG)
        return rospy.ServiceProxy("/gazebo/" + name, kind)(*arguments, **fields)

    def spawn(self, name, xml, x, y, **fields):
        return self.call(
            "spawn_urdf_model",
            SpawnModel,
            model_name=name,
            model_xml=xml,
            initial_pose=pose(x, y, z=0.2),
            **fields,
        )

    def state(self, name, reference=""):
        return self.call("get_model_state", GetModelState, name, reference)

    def put(self, **fields):
        return self.call("set_model_state", SetModelState, ModelState(**fields))

    def names(self):
        return self.call("get_world_properties", GetWorldProperties).model_names

    def run_periods(self, count):
        """Let so many more periods pass, without a driver."""
        self.stepper.advance_to(count * PERIOD)
