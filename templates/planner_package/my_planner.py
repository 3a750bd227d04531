"""Steers to where the lidar sees most room: the planner as a class, which needs no ROS."""

import numpy as np
from f1tenth_judge.planner import Command

SIGHT = 6.0  # m
BESIDE = 40  # beams to either side that must be free as well, for the car's width


class FollowTheGap:
    """Answers each scan."""

    def reset(self, info):
        """Take the speed (m/s, straight ahead) if one is given."""
        self.speed = float(info.get("speed", 2.0))

    def plan(self, observation):
        """Look at what is ahead."""
        angles = observation.scan.angles
        ahead = np.abs(angles) < 1.3
        ranges = np.pad(np.minimum(observation.scan.ranges, SIGHT)[ahead], BESIDE, "edge")
        free = np.lib.stride_tricks.sliding_window_view(ranges, 2 * BESIDE + 1).min(axis=1)
        direction = float(np.average(angles[ahead], weights=free**3))
        return Command(self.speed * max(0.5, 1.0 - 2.0 * abs(direction)), 1.5 * direction)
