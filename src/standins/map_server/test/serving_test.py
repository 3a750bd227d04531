#!/usr/bin/env python3
"""The node map_server, asked as a user would ask it."""

import subprocess
import sys
import unittest
from pathlib import Path

import rospy
import rostest
from nav_msgs.msg import MapMetaData, OccupancyGrid
from nav_msgs.srv import GetMap, LoadMap, LoadMapResponse

DATA = "package://map_server/test/data"
HERE = Path(__file__).resolve().parent
SMALL = [-1, 0, 0, 100]
INVERTED = [100, 100, 100, 0]


def receive(topic, kind):
    """Subscribe anew, so that only a latched message arrives."""
    return rospy.wait_for_message(topic, kind)


class MapServerTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("serving_test")
        # The services are there before the map is published; waiting for them by name would need a clock.
        receive("map", OccupancyGrid)
        cls.static_map = rospy.ServiceProxy("static_map", GetMap)
        cls.change_map = rospy.ServiceProxy("change_map", LoadMap)

    def setUp(self):
        self.change_map(f"{DATA}/small.yaml")

    def test_late_subscriber_gets_the_map_without_a_clock(self):
        message = receive("map", OccupancyGrid)
        assert list(message.data) == SMALL
        assert message.header.frame_id == "floor"
        assert message.header.stamp.is_zero()

    def test_late_subscriber_gets_the_metadata(self):
        message = receive("map_metadata", MapMetaData)
        assert (message.width, message.height, message.resolution) == (2, 2, 0.5)
        assert (message.origin.position.x, message.origin.position.y) == (-1.0, 2.0)

    def test_static_map_returns_the_map(self):
        assert list(self.static_map().map.data) == SMALL

    def test_change_map_serves_the_new_map_everywhere(self):
        response = self.change_map(f"{DATA}/inverted.yaml")
        assert response.result == LoadMapResponse.RESULT_SUCCESS
        assert list(response.map.data) == INVERTED
        assert list(self.static_map().map.data) == INVERTED
        assert list(receive("map", OccupancyGrid).data) == INVERTED
        assert receive("map_metadata", MapMetaData).resolution == 0.25

    def assert_change_fails(self, url, result):
        assert self.change_map(url).result == result
        assert list(self.static_map().map.data) == SMALL

    def test_change_to_a_missing_file_keeps_the_map(self):
        self.assert_change_fails(f"{DATA}/none.yaml", LoadMapResponse.RESULT_MAP_DOES_NOT_EXIST)

    def test_change_to_a_missing_package_keeps_the_map(self):
        self.assert_change_fails("package://no_such/a.yaml", LoadMapResponse.RESULT_MAP_DOES_NOT_EXIST)

    def test_change_to_wrong_metadata_keeps_the_map(self):
        self.assert_change_fails(f"{DATA}/missing_key.yaml", LoadMapResponse.RESULT_INVALID_MAP_METADATA)

    def test_change_to_a_wrong_image_keeps_the_map(self):
        self.assert_change_fails(f"{DATA}/broken_image.yaml", LoadMapResponse.RESULT_INVALID_MAP_DATA)

    def test_frame_that_is_no_name_is_refused(self):
        program = HERE.parent / "scripts" / "map_server"
        command = [sys.executable, program, HERE / "data" / "small.yaml", "_frame_id:=7"]
        answer = subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False)
        assert answer.returncode == 255
        assert "/frame_id: found 7, allowed is the name of a frame\n" in answer.stderr
        assert answer.stderr.count("\n") == 1


if __name__ == "__main__":
    rostest.rosrun("map_server", "serving_test", MapServerTest, sys.argv)
