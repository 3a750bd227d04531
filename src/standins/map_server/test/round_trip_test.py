#!/usr/bin/env python3
"""map_saver and map_server together, as processes: exit codes, messages and a map that survives."""

import contextlib
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import rospy
import rostest
from map_files import random_cells, write_map
from map_server.conversions import to_occupancy_grid
from map_server.grid_map import GridMap
from nav_msgs.msg import OccupancyGrid
from roslib.packages import find_node

TIMEOUT = 20  # s of wall time, for a process that ought to end at once


def command(executable, *arguments):
    return [find_node("map_server", executable)[0], *map(str, arguments)]


def run(executable, *arguments, cwd=None):
    return subprocess.run(
        command(executable, *arguments), cwd=cwd, capture_output=True, text=True, timeout=TIMEOUT, check=False
    )


@contextlib.contextmanager
def running(executable, *arguments):
    process = subprocess.Popen(command(executable, *arguments), stderr=subprocess.PIPE, text=True)
    try:
        yield process
    finally:
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=TIMEOUT)


class RoundTripTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("round_trip_test")
        cls.grid = GridMap(cells=random_cells(11), resolution=0.05, origin=(-3.25, 1.5, 0.5))
        cls.publisher = rospy.Publisher("drawn", OccupancyGrid, latch=True, queue_size=1)
        cls.publisher.publish(to_occupancy_grid(cls.grid, "map", rospy.Time()))

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_map_saved_and_served_again_is_identical_cell_by_cell(self):
        assert run("map_saver", "-f", "circuit1", "map:=drawn", cwd=self.folder).returncode == 0
        assert {path.name for path in self.folder.iterdir()} == {"circuit1.pgm", "circuit1.yaml"}
        with running("map_server", self.folder / "circuit1.yaml", "map:=served"):
            served = rospy.wait_for_message("served", OccupancyGrid, timeout=TIMEOUT)
        assert list(served.data) == self.grid.cells.ravel().tolist()
        assert (served.info.width, served.info.height) == (53, 37)
        assert served.info.resolution == np.float32(0.05)
        assert (served.info.origin.position.x, served.info.origin.position.y) == (-3.25, 1.5)

    def test_saver_that_cannot_write_says_so_and_leaves_nothing(self):
        result = run("map_saver", "-f", self.folder / "none" / "circuit1", "map:=drawn")
        assert result.returncode == 1
        assert f"{self.folder}/none/circuit1.pgm: cannot be written: No such file" in result.stderr
        assert "Traceback" not in result.stderr
        assert list(self.folder.iterdir()) == []

    def test_saver_that_waits_ends_on_an_interrupt(self):
        process = subprocess.Popen(
            command("map_saver", "-f", self.folder / "circuit1", "map:=nobody", "__name:=waiting_saver"),
            stderr=subprocess.PIPE,
            text=True,
        )
        self.wait_for_subscriber("/nobody")
        process.send_signal(signal.SIGINT)
        _, output = process.communicate(timeout=TIMEOUT)
        assert process.returncode == 1
        assert output == "map_saver: ended before a map arrived, nothing is saved\n"
        assert list(self.folder.iterdir()) == []

    def wait_for_subscriber(self, topic):
        probe = rospy.Publisher(topic, OccupancyGrid, queue_size=1)
        self.addCleanup(probe.unregister)
        while probe.get_num_connections() == 0:
            rospy.rostime.wallsleep(0.01)

    def test_server_of_a_missing_file_exits_with_255_and_one_line(self):
        result = run("map_server", self.folder / "none.yaml")
        assert result.returncode == 255
        assert f"{self.folder}/none.yaml: cannot be opened: No such file or directory" in result.stderr
        assert len(result.stderr.splitlines()) == 1

    def test_server_takes_image_and_resolution(self):
        write_map(self.folder, [[254, 0]])
        with running("map_server", self.folder / "map.png", "0.25", "map:=by_image", "_negate:=1"):
            served = rospy.wait_for_message("by_image", OccupancyGrid, timeout=TIMEOUT)
        assert list(served.data) == [100, 0]
        assert served.info.resolution == 0.25


if __name__ == "__main__":
    rostest.rosrun("map_server", "round_trip_test", RoundTripTest, sys.argv)
