#!/usr/bin/env python3
"""Wrong inputs: one clear line on stderr, exit code 2, and the same line in the result file."""

import os
import re
import signal
import subprocess
import unittest

import rospy
import rostest
from sim2d_process import Sim2d, car_description, executable

PLUGIN = """
<gazebo><plugin name="unknown" filename="libno_such_plugin.so"><tag>1</tag></plugin></gazebo>
"""


class BadInputTest(unittest.TestCase):
    def setUp(self):
        rospy.set_param("/robot1", {})

    def refused(self, description="", **parameters):
        """Return the one line that a start with these parameters ends with."""
        sim2d = Sim2d(car_description() if description == "" else description, **parameters)
        self.addCleanup(sim2d.kill)
        assert sim2d.wait() == 2, sim2d.stderr
        lines = [line for line in sim2d.stderr.splitlines() if "FATAL" in line]
        assert len(lines) == 1, sim2d.stderr
        assert "Traceback" not in sim2d.stderr
        error = re.sub("\\x1b\\[[0-9;]*m", "", lines[0]).split("]: ", 1)[1]
        if sim2d.result_file.exists():
            assert sim2d.result()["reason"] == "bad_input"
            assert sim2d.result()["error"] == error
        return error

    def test_parameter_of_wrong_type(self):
        error = self.refused(real_time_factor="fast")
        assert error == (
            'parameter /sim2d/real_time_factor: found "fast", '
            "must be a number that is 0 (as fast as it goes) or >= 1e-06"
        )

    def test_unknown_parameter(self):
        assert self.refused(gui=True).startswith("parameter /sim2d/gui: unknown; allowed: world, cars, ")

    def test_no_description(self):
        assert self.refused(description=None) == (
            "parameter /robot1/robot_description: not set, expected the URDF or SDF text of the car"
        )

    def test_malformed_description(self):
        assert self.refused(description="<robot").startswith("/robot1/robot_description: ")

    def test_no_such_world(self):
        assert "/no/such.world" in self.refused(world="/no/such.world")

    def test_start_that_is_not_free(self):
        error = self.refused(cars={"robot1": {"x": 3.9}})
        assert "robot1" in error
        assert "walls" in error

    def test_vehicle_file_that_is_missing(self):
        assert "/no/such.yaml" in self.refused(cars={"robot1": {"vehicle": "/no/such.yaml"}})

    def test_record_that_cannot_be_written(self):
        assert self.refused(record="/no/such/folder/record.csv") == (
            "record: cannot write /no/such/folder/record.csv: No such file or directory"
        )

    def test_result_file_that_cannot_be_written(self):
        sim2d = Sim2d(car_description(), result_file="/no/such/folder/result.json", lockstep=True)
        self.addCleanup(sim2d.kill)
        rospy.wait_for_service("/gazebo/get_model_state", 60.0)
        sim2d.send(signal.SIGINT)
        assert sim2d.wait() == 2
        assert "result_file: cannot write /no/such/folder/result.json.tmp: No such file" in sim2d.stderr

    def test_unknown_plugin_is_one_warning_and_no_error(self):
        sim2d = Sim2d(car_description(PLUGIN), lockstep=True)
        self.addCleanup(sim2d.kill)
        rospy.wait_for_service("/gazebo/get_model_state", 60.0)
        assert sim2d.stop() == 0
        warnings = [line for line in sim2d.stderr.splitlines() if "libno_such_plugin.so" in line]
        assert len(warnings) == 1
        assert "left out" in warnings[0]

    def test_no_master(self):
        node = subprocess.run(
            [executable("f1tenth_sim2d", "sim2d")],
            env={**os.environ, "ROS_MASTER_URI": "http://localhost:1"},
            capture_output=True,
            text=True,
            timeout=60,
        )
        assert node.returncode == 2
        assert "no ROS master at http://localhost:1: start roscore, or set ROS_MASTER_URI" in node.stderr


if __name__ == "__main__":
    rospy.init_node("bad_input_test")
    rostest.rosrun("f1tenth_sim2d", "sim2d_bad_input", BadInputTest)
