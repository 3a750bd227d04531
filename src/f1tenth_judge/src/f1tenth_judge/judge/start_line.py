"""Counting laps at a line: by direction, with the time between two samples interpolated."""

import math
from collections.abc import Sequence
from typing import Optional

from f1tenth_judge.record.record import CarTrack
from f1tenth_judge.scenario.scenario import StartLine

_Place = tuple[float, float, float]  # time (s), x, y (m)


class _Line:
    """A line, and when a car crosses it."""

    def __init__(self, line: StartLine):
        self._line = line
        self._cosine, self._sine = math.cos(line.yaw), math.sin(line.yaw)

    def is_ahead(self, place: _Place) -> bool:
        """Whether a place is beyond the line, in its direction, or on it."""
        return self._coordinates(place)[0] >= 0

    def crossing(self, before: _Place, now: _Place) -> Optional[float]:
        """When a car crossed between two places, s; nothing if it did not, or beside the line's ends."""
        (before_along, before_across), (along, across) = map(self._coordinates, (before, now))
        if (before_along >= 0) == (along >= 0):
            return None
        part = before_along / (before_along - along)
        if abs(before_across + part * (across - before_across)) > self._line.width / 2:
            return None
        return before[0] + part * (now[0] - before[0])

    def _coordinates(self, place: _Place) -> tuple[float, float]:
        """Along the direction of the line's crossing, and to its left, m."""
        dx, dy = place[1] - self._line.x, place[2] - self._line.y
        return self._cosine * dx + self._sine * dy, self._cosine * dy - self._sine * dx


class LapCounter:
    """Follows one car. A lap ends when the line is crossed in its direction, and the next one begins.

    A car that goes back over the line has to cross it once more before the next crossing counts. A car that
    starts behind the line does not end a lap by crossing it first. Where the way round is known, a lap counts
    only if the car came through every gate on it, in order.
    """

    def __init__(self, line: StartLine, start: float, gates: Sequence[StartLine] = ()):
        """`start`: time (s) at which the first lap begins."""
        self._line = _Line(line)
        self._gates = [_Line(gate) for gate in gates]
        self._passed = 0  # gates since the line
        self._began = start
        self._before: Optional[_Place] = None
        self._level = 0  # laps ahead of the line
        self.lap_times: list[float] = []  # s

    def update(self, time: float, x: float, y: float) -> None:
        """Take the place (m) of the car at a time (s)."""
        before, now = self._before, (time, x, y)
        self._before = now
        if before is None:
            self._level = 0 if self._line.is_ahead(now) else -1
            return
        self._pass_gates(before, now)
        crossing = self._line.crossing(before, now)
        if crossing is None:
            return
        if not self._line.is_ahead(now):
            self._level -= 1
        elif self._level < len(self.lap_times):
            self._level += 1
        elif self._passed == len(self._gates):
            self._level += 1
            self._passed = 0
            self.lap_times.append(crossing - self._began)
            self._began = crossing

    def _pass_gates(self, before: _Place, now: _Place) -> None:
        while self._passed < len(self._gates):
            gate = self._gates[self._passed]
            if gate.crossing(before, now) is None or not gate.is_ahead(now):
                return
            self._passed += 1


def times_of_laps(
    line: StartLine, track: CarTrack, start: float, gates: Sequence[StartLine] = ()
) -> list[float]:
    """How long the laps of a track took, s; `start` and `gates` as of LapCounter."""
    counter = LapCounter(line, start, gates)
    for time, x, y, _ in track.places():
        counter.update(time, x, y)
    return counter.lap_times
