#!/usr/bin/env python3
"""The launch file starts a countdown that works."""

import sys

import pytest
import rospy
from std_msgs.msg import Int32

LIMIT = 120.0  # wall s, against hangs


def test_the_launch_file_gives_the_start_signal():
    assert rospy.wait_for_message("/time_to_start", Int32, LIMIT).data == 0


if __name__ == "__main__":
    rospy.init_node("launch_file_test")
    junit = [a.replace("--gtest_output=xml:", "--junitxml=") for a in sys.argv if "_output=xml:" in a]
    sys.exit(pytest.main([__file__, *junit]))
