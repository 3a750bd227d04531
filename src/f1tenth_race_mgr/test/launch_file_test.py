#!/usr/bin/env python3
"""The shipped configuration starts a race that works, by the launch file and in the ways of the thesis."""

import sys
import threading

import pytest
import rospy

from f1tenth_race_mgr.msg import RaceStatus

LIMIT = 120.0  # wall s, against hangs


@pytest.mark.parametrize("car", ["robot1", "robot2", "robot3"])
def test_race_starts_and_finishes(car):
    finished = threading.Event()

    def on_status(message):
        if message.state == RaceStatus.FINISHED:
            finished.set()

    subscriber = rospy.Subscriber(f"/{car}/race_status", RaceStatus, on_status)
    assert finished.wait(LIMIT)
    subscriber.unregister()


if __name__ == "__main__":
    rospy.init_node("launch_file_test")
    junit = [a.replace("--gtest_output=xml:", "--junitxml=") for a in sys.argv if "_output=xml:" in a]
    sys.exit(pytest.main([__file__, *junit]))
