"""Tells from poses in the map when a lap is complete, and when enough of it has been seen twice."""

import math

from workspace_support import maths

REACH = 3.0
"""Half the length of the line across the start, m: a map may have drifted until its loop is closed."""
MAX_TURN = 1.0
"""Difference from the direction at the start in which the line is crossed, rad."""
LEAST_WAY = 12.0
"""The least length of a lap, m."""
OVERLAP = 10.0
"""Way beyond the start, m: what has been seen twice closes the map."""
BEND = 0.5
"""Turn beyond the start, rad. A straight looks alike everywhere: a bend tells how far along it the car is."""
BEHIND_BEND = 8.0
"""Way beyond that bend, m."""
MOST_OVERLAP = 100.0
"""Way beyond the start without a bend, m."""
PATIENCE = 30.0
"""Time in which a car that makes progress drives `STEP`, s."""
STEP = 0.5
"""m"""


class LapError(RuntimeError):
    """There will be no lap; the message says why."""


class LapWatch:
    """A lap is complete when the car comes past its start again, in the same direction."""

    def __init__(self, time_limit):
        """The first pose is the start; the time limit is from there to the end, s."""
        self._time_limit = time_limit
        self._start: tuple = ()
        self._last: tuple = ()
        self._progress = (0.0, 0.0)
        self._end = math.inf
        self._has_turned = False
        self.way = 0.0
        """Driven so far, m."""
        self.lap: float | None = None
        """Length of the lap, once it is complete, m."""

    @property
    def is_over(self):
        """Whether the lap is complete and enough of it was seen twice."""
        return self.way > self._end

    def take(self, time, x, y, yaw):
        """Take the next pose in the map: s, m and rad.

        Raises:
            LapError: if the car stands still, or the time limit is exceeded.
        """
        if not self._start:
            self._start = (time, x, y, yaw)
            self._progress = (time, 0.0)
        ahead, aside, turn = self._from_start(x, y, yaw)
        before, self._last = self._last or (x, y, ahead), (x, y, ahead)
        self.way += maths.hypot(x - before[0], y - before[1])
        crosses = before[2] < 0.0 <= ahead and abs(aside) < REACH and abs(turn) < MAX_TURN
        if self.lap is None and crosses and self.way > LEAST_WAY:
            self.lap = self.way
            self._end = self.way + MOST_OVERLAP
        if self.lap is not None and not self._has_turned and abs(turn) > BEND:
            self._has_turned = True
            self._end = max(self.lap + OVERLAP, self.way + BEHIND_BEND)
        self._check(time, x, y)

    def _check(self, time, x, y):
        since, way = self._progress
        if self.way - way > STEP:
            self._progress = (time, self.way)
        elif time - since > PATIENCE and not self.is_over:
            raise LapError(f"the car has stood still for {PATIENCE:.0f} s, {self._place(x, y)}")
        if time - self._start[0] > self._time_limit:
            what = "no lap is complete" if self.lap is None else "not enough was seen twice"
            raise LapError(f"{what} after {self._time_limit:.0f} s, {self._place(x, y)}")

    def _place(self, x, y):
        return f"at ({x:.1f}, {y:.1f}), {self.way:.1f} m of way from the start"

    def _from_start(self, x, y, yaw):
        _, start_x, start_y, start_yaw = self._start
        dx, dy = x - start_x, y - start_y
        c, s = maths.cos(start_yaw), maths.sin(start_yaw)
        return c * dx + s * dy, c * dy - s * dx, math.remainder(yaw - start_yaw, math.tau)
