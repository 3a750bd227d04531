#!/usr/bin/env python3
"""The nodes' interface, and that a bag gives the same map every time."""

import itertools
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import pytest
import rosbag
import rospy
import rostest
from nav_msgs.msg import MapMetaData, OccupancyGrid
from nav_msgs.srv import GetMap
from played_car import PERIOD, drive, mounting
from played_simulator import PATIENCE, Simulator
from std_msgs.msg import Float64

PERIODS = 60


def replay(bag, *arguments):
    """Run slam_gmapping_replay in a namespace of its own, so that it does not meet the node."""
    command = ["rosrun", "gmapping", "slam_gmapping_replay"]
    command += ["_base_frame:=base_footprint", "_linearUpdate:=0.2", "_xmin:=-1", "_ymin:=-1"]
    command += ["_xmax:=1", "_ymax:=1", "--bag_filename", str(bag), *arguments]
    environment = {**os.environ, "ROS_NAMESPACE": "replay"}
    return subprocess.run(
        command, env=environment, capture_output=True, text=True, timeout=PATIENCE, check=False
    )


class SlamGmappingTest(unittest.TestCase):
    """One drive for all tests."""

    @classmethod
    def setUpClass(cls):
        """Drive through the room."""
        cls.simulator = Simulator(mounting())
        cls.simulator.wait_for_listeners()
        cls.simulator.run(drive(PERIODS))
        cls.transforms = cls.simulator.transforms_until(rospy.Time.from_sec(2.5))
        cls.map = rospy.wait_for_message("map", OccupancyGrid, PATIENCE)
        cls.folder = tempfile.TemporaryDirectory()
        cls.bag = Path(cls.folder.name) / "drive.bag"
        with rosbag.Bag(str(cls.bag), "w") as bag:
            bag.write("/tf_static", mounting(), rospy.Time(1))
            for stamp, messages in drive(PERIODS):
                for topic, message in messages:
                    bag.write(topic, message, stamp)

    @classmethod
    def tearDownClass(cls):
        """Remove the bag."""
        cls.folder.cleanup()

    def cell(self, x, y):
        info = self.map.info
        column = int((x - info.origin.position.x) // info.resolution)
        row = int((y - info.origin.position.y) // info.resolution)
        return self.map.data[column + row * info.width]

    def test_map_is_latched_and_has_three_kinds_of_cells(self):
        assert set(self.map.data) == {-1, 0, 100}
        assert self.map.header.frame_id == "map"
        assert self.map.info.resolution == pytest.approx(0.05)
        assert [self.cell(1.0, 0.0), self.cell(5.02, 0.0), self.cell(6.5, 0.0)] == [0, 100, -1]

    def test_metadata_and_entropy_are_latched(self):
        assert rospy.wait_for_message("map_metadata", MapMetaData, PATIENCE) == self.map.info
        assert rospy.wait_for_message("slam_gmapping/entropy", Float64, PATIENCE).data >= 0.0

    def test_service_returns_the_map(self):
        rospy.wait_for_service("dynamic_map", PATIENCE)
        stamps = (rospy.Time.from_sec(3.0 + i * PERIOD) for i in itertools.count())
        answer = self.simulator.call(rospy.ServiceProxy("dynamic_map", GetMap), stamps)
        assert answer.map.data == self.map.data

    def test_transform_is_there_from_the_start_and_corrects_odometry(self):
        transforms = self.transforms
        assert transforms[0].header.stamp.to_sec() == 1.05
        assert transforms[0].transform.translation.x == 0.0
        assert transforms[0].child_frame_id == "odom"
        steps = {
            round((b.header.stamp - a.header.stamp).to_sec(), 3) for a, b in zip(transforms, transforms[1:])
        }
        assert steps == {0.05}
        assert transforms[-1].transform.translation.x == pytest.approx(-0.028, abs=0.02)

    def test_same_bag_and_seed_give_the_same_map(self):
        files = []
        for i in range(2):
            stem = Path(self.folder.name) / f"map{i}"
            save = f"rosrun map_server map_saver -f {stem}"
            result = replay(self.bag, "--seed", "4", "--scan_topic", "/scan", "--on_done", save)
            assert result.returncode == 0, result.stderr
            files.append(stem.with_suffix(".pgm").read_bytes())
        assert files[0] == files[1]

    def test_wrong_options_are_answered_in_one_line(self):
        for arguments, words in [
            (["--seed", "x"], '--seed: found "x", must be a whole number of at most 9 digits'),
            (
                ["--speed", "1"],
                "--speed: there is no such option; usage: slam_gmapping_replay --bag_filename FILE",
            ),
            (["--on_done"], "--on_done: found nothing behind it; usage"),
            (["--scan_topic", "/none"], "drive.bag: there is no scan on /none"),
            (["--on_done", "false"], "--on_done: this command has failed: false"),
        ]:
            result = replay(self.bag, *arguments)
            assert result.returncode == 1
            lines = [line for line in result.stderr.splitlines() if line.startswith("slam_gmapping_replay: ")]
            assert len(lines) == 1, result.stderr
            assert words in lines[0]

    def test_file_that_is_no_bag_is_refused(self):
        result = replay("/dev/null")
        assert result.returncode == 1
        assert "slam_gmapping_replay: " in result.stderr

    def test_parameter_of_a_wrong_type_is_refused(self):
        self.addCleanup(rospy.delete_param, "/replay/slam_gmapping/iterations")
        result = replay(self.bag, "_iterations:=many")
        assert result.returncode == 1
        message = 'parameter /replay/slam_gmapping/iterations: found "many", must be a whole number'
        assert message in result.stderr


if __name__ == "__main__":
    rospy.init_node("slam_gmapping_test")
    rostest.rosrun("gmapping", "slam_gmapping_test", SlamGmappingTest)
