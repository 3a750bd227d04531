#!/usr/bin/env python3
"""race.launch goals:=FILE: race_mgr sends the goals of a lap again and again, and the laps are counted."""

import queue
import sys
import unittest

import rospy
import rostest

from f1tenth_race_mgr.msg import RaceStatus
from f1tenth_scenarios.msg import RaceTiming

PATIENCE = 150.0  # wall s


class RaceGoalsTest(unittest.TestCase):
    def test_car_drives_from_goal_to_goal_beyond_its_first_lap(self):
        timings, states = queue.SimpleQueue(), queue.SimpleQueue()
        rospy.Subscriber("/race_control/timing", RaceTiming, timings.put)
        rospy.Subscriber("/robot1/race_status", RaceStatus, states.put)
        status = states.get(timeout=PATIENCE)
        while status.laps < 1:
            assert status.state in (RaceStatus.WAITING, RaceStatus.RACING), status.text
            status = states.get(timeout=PATIENCE)
        assert status.goals_reached >= status.goals_total == 5
        (car,) = timings.get(timeout=PATIENCE).cars
        assert (car.car, car.laps) == ("robot1", 1)
        assert 3.0 < car.lap_times[0] < 60.0


if __name__ == "__main__":
    rospy.init_node("race_goals_test")
    rostest.rosrun("f1tenth_scenarios", "race_goals_test", RaceGoalsTest, sys.argv)
