"""Drives by the camera alone: towards where the floor is free the farthest.

f1tenth race circuit1 --planner free_floor.py:FreeFloor
"""

import numpy as np

COLUMNS = 16  # pixels that are looked at together
SIDE = 0.22  # m, that the middle of the car keeps from what is not floor
LOOK_AHEAD = 1.2  # m
WHEELBASE = 0.33  # m


class FreeFloor:
    """Looks at depths only."""

    def reset(self, info):
        """Learn how the first eye looks."""
        eye = info["eyes"][0]
        self._rows = np.arange(int(eye.middle_y) + 3, eye.height)
        # m, depth at which a row sees the floor
        self._floor = eye.pose[2] * eye.focal_y / (self._rows - eye.middle_y)
        columns = np.arange(eye.width // COLUMNS) * COLUMNS + (COLUMNS - 1) / 2
        self._directions = np.arctan((eye.middle_x - columns) / eye.focal_x)  # rad, to the left

    def plan(self, observation):
        """(speed, m/s, steering angle, rad) for a picture."""
        reach = self._reach(observation.depth)
        # What stands beside a direction, nearer than its own end, must leave room for the car.
        apart = np.abs(self._directions[:, None] - self._directions)
        in_the_way = np.sin(np.minimum(apart, np.pi / 2)) * reach < SIDE
        clear = np.where(in_the_way, reach, np.inf).min(axis=1)
        best = np.argmax(clear - 0.1 * np.abs(self._directions))
        steering = np.arctan(2.0 * WHEELBASE * np.sin(self._directions[best]) / LOOK_AHEAD)
        return np.clip(0.6 * clear[best], 0.8, 2.5), steering

    def _reach(self, depth):
        """How far the floor reaches, m, for blocks of columns."""
        is_floor = np.abs(depth[self._rows] / self._floor[:, None] - 1.0) < 0.03
        blocks = is_floor[:, : len(self._directions) * COLUMNS].reshape(len(self._rows), -1, COLUMNS)
        is_free = blocks.all(axis=2)
        reach = np.where(is_free.any(axis=0), self._floor[is_free.argmax(axis=0)], 0.0)
        return reach / np.cos(self._directions)
