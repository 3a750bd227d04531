#!/usr/bin/env python3
"""The nodes' interface, and that a bag gives the same map every time."""

import itertools
import math
import os
import subprocess
import tempfile
import threading
import unittest
from pathlib import Path

import pytest
import rosbag
import rospy
import rostest
from nav_msgs.msg import MapMetaData, OccupancyGrid
from nav_msgs.srv import GetMap
from played_car import PERIOD, drive, mounting, scan
from played_simulator import PATIENCE, Simulator
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float64

PERIODS = 60


def replay(bag, *arguments):
    """Run slam_gmapping_replay in a namespace of its own, so that it does not meet the node."""
    command = ["rosrun", "gmapping", "slam_gmapping_replay"]
    command += ["_base_frame:=/base_footprint", "_linearUpdate:=0.2", "_xmin:=-1", "_ymin:=-1"]
    command += ["_xmax:=1", "_ymax:=1", "--bag_filename", str(bag), *arguments]
    environment = {**os.environ, "ROS_NAMESPACE": "replay"}
    return subprocess.run(
        command, env=environment, capture_output=True, text=True, timeout=PATIENCE, check=False
    )


def record(path, messages):
    """Write a bag. messages: triples of topic, message and stamp."""
    with rosbag.Bag(str(path), "w") as bag:
        bag.write("/tf_static", mounting(), rospy.Time(1))
        for topic, message, stamp in messages:
            bag.write(topic, message, stamp)


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
        record(cls.bag, [(*sent, stamp) for stamp, messages in drive(PERIODS) for sent in messages])

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
        empty = Path(self.folder.name) / "empty.bag"
        empty.touch()
        result = replay(empty)
        assert result.returncode == 1
        assert f"slam_gmapping_replay: {empty}: " in result.stderr

    def test_damaged_bag_is_refused(self):
        damaged = Path(self.folder.name) / "damaged.bag"
        name = b"\x06\x00\x00\x00/laser"  # the frame of a scan, behind its length
        assert name in self.bag.read_bytes()
        damaged.write_bytes(self.bag.read_bytes().replace(name, b"\xff\xff\xff\x7f/laser"))
        result = replay(damaged)
        assert result.returncode == 1
        assert f"slam_gmapping_replay: {damaged}: " in result.stderr

    def test_bag_whose_scans_get_no_transform_is_refused(self):
        self.addCleanup(rospy.delete_param, "/replay/slam_gmapping/odom_frame")
        result = replay(self.bag, "_odom_frame:=nowhere")
        assert result.returncode == 1
        reason = "there is no transform from nowhere to laser"
        assert f"drive.bag: none of {PERIODS} scans on /scan is of use: {reason}" in result.stderr

    def test_bag_whose_scans_make_no_sense_is_refused(self):
        endless = Path(self.folder.name) / "endless.bag"
        messages = [(*sent, stamp) for stamp, both in drive(3) for sent in both]
        for topic, message, _ in messages:
            if topic == "/scan":
                message.range_max = math.inf
        record(endless, messages)
        result = replay(endless)
        assert result.returncode == 1
        reason = "range_max: found inf, must be a finite number above 0"
        assert f"A scan at 1.000 s is left out: {reason}" in result.stderr + result.stdout
        assert f"endless.bag: none of 3 scans on /scan is of use: {reason}" in result.stderr

    def test_scans_that_still_wait_at_the_end_are_said(self):
        late = Path(self.folder.name) / "late.bag"
        stamp = rospy.Time(2)
        messages = [(*sent, stamp) for stamp, both in drive(3) for sent in both]
        record(late, [*messages, ("/scan", scan(0.0, stamp), stamp)])
        result = replay(late)
        assert result.returncode == 0
        reason = "there is no transform from odom to laser"
        assert f"The last scans are left out, 1: {reason} for them" in result.stderr + result.stdout

    def test_node_says_what_it_waits_for(self):
        publisher = rospy.Publisher("/lonely/scan", LaserScan, queue_size=1, latch=True)
        node = subprocess.Popen(
            ["rosrun", "gmapping", "slam_gmapping", "__ns:=lonely"], stderr=subprocess.PIPE, text=True
        )
        stop = threading.Timer(PATIENCE, node.kill)
        stop.start()
        assert any("Still waiting for scans on /lonely/scan" in line for line in node.stderr)
        message = scan(0.0, rospy.Time(1))
        message.header.frame_id = "lidar"
        publisher.publish(message)
        words = "Still waiting for a transform from odom to lidar, the frame of the scans"
        assert any(words in line for line in node.stderr)
        stop.cancel()
        node.kill()
        node.communicate()

    def test_wrong_parameters_are_refused(self):
        for name, value, complaint in [
            ("iterations", "many", 'iterations: found "many", must be a whole number'),
            ("tf_delay", "1e10", "tf_delay: found 10000000000, must be a number >= 0 and <= 1e+09"),
            ("delta", "1e-4", "delta: found 0.0001, must be at least 0.001"),
            (
                "xmax",
                "1e9",
                "xmin, xmax, ymin, ymax, delta: found 8e+11, must be at most 4e+08 cells",
            ),
        ]:
            result = replay(self.bag, f"_{name}:={value}")
            rospy.delete_param(f"/replay/slam_gmapping/{name}")
            assert result.returncode == 1
            assert f"parameter /replay/slam_gmapping/{complaint}" in result.stderr


if __name__ == "__main__":
    rospy.init_node("slam_gmapping_test")
    rostest.rosrun("gmapping", "slam_gmapping_test", SlamGmappingTest)
