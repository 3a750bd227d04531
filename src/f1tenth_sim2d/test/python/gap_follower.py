"""The driver of the golden laps."""

import math

import numpy as np


class GapFollower:
    """Steers to where it is free farthest, with a window of the car's width swept along the scan."""

    SPEED_MAX = 4.0  # m/s
    SIGHT = 8.0  # m
    HALF_WINDOW = math.radians(9.0)
    LOOK_ASIDE = math.radians(70.0)
    GAIN = 1.2
    STEERING_MAX = 0.4  # rad

    def __init__(self, lidar):
        """Take the Lidar whose scans are given later."""
        angles = np.linspace(lidar.angle_min, lidar.angle_max, lidar.beam_count)
        self._ahead = np.abs(angles) <= self.LOOK_ASIDE
        self._angles = angles[self._ahead]
        self._half = max(1, round(self.HALF_WINDOW / (angles[1] - angles[0])))

    def command(self, ranges):
        """(speed, steering angle), m/s and rad, for a scan, m."""
        ahead = np.clip(ranges[self._ahead], 0.1, self.SIGHT).astype(float)
        padded = np.pad(ahead, self._half, mode="edge")
        free = np.lib.stride_tricks.sliding_window_view(padded, 2 * self._half + 1).min(axis=1)
        aim = float(np.average(self._angles, weights=free**4))
        steering = min(max(self.GAIN * aim, -self.STEERING_MAX), self.STEERING_MAX)
        return self.SPEED_MAX / (1.0 + 2.0 * abs(steering)), steering
