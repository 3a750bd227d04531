#!/usr/bin/env python3
"""The launch file with the shipped configuration starts a race that works."""

import sys
import threading

import pytest
import rospy

from f1tenth_race_mgr.msg import RaceStatus

LIMIT = 120.0  # wall s, against hangs


def test_the_launch_file_starts_a_race_that_finishes():
    finished = threading.Event()

    def on_status(message):
        if message.state == RaceStatus.FINISHED:
            finished.set()

    subscriber = rospy.Subscriber("/robot1/race_status", RaceStatus, on_status)
    assert finished.wait(LIMIT)
    subscriber.unregister()


if __name__ == "__main__":
    rospy.init_node("launch_file_test")
    junit = [a.replace("--gtest_output=xml:", "--junitxml=") for a in sys.argv if "_output=xml:" in a]
    sys.exit(pytest.main([__file__, *junit]))
