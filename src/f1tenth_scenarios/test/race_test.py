#!/usr/bin/env python3
"""race.launch: planners of others drive, and are timed live."""

import queue
import sys
import unittest

import rospy
import rostest

from f1tenth_scenarios.msg import RaceTiming

PATIENCE = 150.0  # wall s


class RaceTest(unittest.TestCase):
    def test_both_cars_complete_laps_and_are_in_order(self):
        timings = queue.SimpleQueue()
        rospy.Subscriber("/race_control/timing", RaceTiming, timings.put)
        timing = timings.get(timeout=PATIENCE)
        while any(not car.lap_times for car in timing.cars):
            timing = timings.get(timeout=PATIENCE)
        assert timing.laps == 100
        assert sorted(car.car for car in timing.cars) == ["robot1", "robot2"]
        leader, second = timing.cars
        assert leader.laps >= second.laps >= 1
        for car in timing.cars:
            assert len(car.lap_times) == car.laps
            assert not car.finished
            assert 3.0 < car.lap_times[0] < 60.0
            assert car.finish <= timing.header.stamp.to_sec()


if __name__ == "__main__":
    rospy.init_node("race_test")
    rostest.rosrun("f1tenth_scenarios", "race_test", RaceTest, sys.argv)
