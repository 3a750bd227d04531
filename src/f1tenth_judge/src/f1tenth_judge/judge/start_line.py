"""Counting laps at a line: by direction, with the time between two samples interpolated."""

import math
from typing import Optional

from f1tenth_judge.record.record import CarTrack
from f1tenth_judge.scenario.scenario import StartLine


class LapCounter:
    """Follows one car. A lap ends when the line is crossed in its direction, and the next one begins.

    A car that goes back over the line has to cross it once more before the next crossing counts. A car that
    starts behind the line does not end a lap by crossing it first.
    """

    def __init__(self, line: StartLine, start: float):
        """`start`: time (s) at which the first lap begins."""
        self._line = line
        self._cosine, self._sine = math.cos(line.yaw), math.sin(line.yaw)
        self._began = start
        self._before: Optional[tuple[float, float, float]] = None
        self._level: Optional[int] = None  # laps ahead of the line
        self.lap_times: list[float] = []  # s

    def update(self, time: float, x: float, y: float) -> None:
        """Take the place (m) of the car at a time (s)."""
        along, across = self._coordinates(x, y)
        if self._level is None:
            self._level = 0 if along >= 0 else -1
        crossing = self._crossing(time, along, across)
        self._before = time, along, across
        if crossing is None:
            return
        self._level += 1 if along >= 0 else -1
        if self._level > len(self.lap_times):
            self.lap_times.append(crossing - self._began)
            self._began = crossing

    def _coordinates(self, x, y):
        """Along the direction of the line's crossing, and to its left, m."""
        dx, dy = x - self._line.x, y - self._line.y
        return self._cosine * dx + self._sine * dy, self._cosine * dy - self._sine * dx

    def _crossing(self, time, along, across) -> Optional[float]:
        """When the line was crossed since the sample before, s; nothing if it was not, or beside its ends."""
        if self._before is None or (self._before[1] >= 0) == (along >= 0):
            return None
        before_time, before_along, before_across = self._before
        part = before_along / (before_along - along)
        if abs(before_across + part * (across - before_across)) > self._line.width / 2:
            return None
        return before_time + part * (time - before_time)


def times_of_laps(line: StartLine, track: CarTrack, start: float) -> list[float]:
    """How long the laps of a track took, s; `start` as of LapCounter."""
    counter = LapCounter(line, start)
    for time, x, y, _ in track.places():
        counter.update(time, x, y)
    return counter.lap_times
