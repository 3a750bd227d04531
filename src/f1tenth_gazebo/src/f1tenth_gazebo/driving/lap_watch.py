"""Tells from odometry when a lap is complete."""

import math


class LapWatch:
    """A lap is complete when the car comes past its start again, in the same direction.

    Odometry may have drifted by then: the start counts as a line across the way, `REACH` to either side.
    """

    REACH = 3.0
    """m"""
    MAX_TURN = 1.0
    """Difference from the direction at the start, rad."""
    LEAST_WAY = 12.0
    """No lap is shorter, m."""

    def __init__(self):
        """The first pose is the start."""
        self._start: tuple = ()
        self._last: tuple = ()
        self.way = 0.0
        """Driven so far, m."""

    def passes_start(self, x, y, yaw):
        """Take the next pose of odometry, m and rad; return whether the car has just completed a lap."""
        if not self._start:
            self._start = (x, y, yaw)
        ahead, aside, turn = self._from_start(x, y, yaw)
        before, self._last = self._last, (x, y, ahead)
        if not before:
            return False
        self.way += math.hypot(x - before[0], y - before[1])
        crosses = before[2] < 0.0 <= ahead and abs(aside) < self.REACH and abs(turn) < self.MAX_TURN
        return crosses and self.way > self.LEAST_WAY

    def _from_start(self, x, y, yaw):
        dx, dy = x - self._start[0], y - self._start[1]
        c, s = math.cos(self._start[2]), math.sin(self._start[2])
        return c * dx + s * dy, c * dy - s * dx, math.remainder(yaw - self._start[2], math.tau)
