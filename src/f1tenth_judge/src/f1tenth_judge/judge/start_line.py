"""Counting laps at a line: by direction, with the time between two samples interpolated."""

import math
from collections.abc import Sequence
from typing import Optional

from f1tenth_judge.record.record import CarTrack
from f1tenth_judge.scenario.scenario import StartLine


class _Line:
    """When a car crosses a line."""

    def __init__(self, line: StartLine):
        self._line = line
        self._cosine, self._sine = math.cos(line.yaw), math.sin(line.yaw)
        self._before: Optional[tuple[float, float, float]] = None
        self.is_behind = False  # whether the car is ahead of crossing the line in its direction

    def crossing(self, time: float, x: float, y: float) -> Optional[float]:
        """When the line was crossed since the place before, s; nothing if it was not, or beside its ends."""
        along, across = self._coordinates(x, y)
        crossing = self._between(time, along, across)
        self._before = time, along, across
        self.is_behind = along < 0
        return crossing

    def _coordinates(self, x, y):
        """Along the direction of the line's crossing, and to its left, m."""
        dx, dy = x - self._line.x, y - self._line.y
        return self._cosine * dx + self._sine * dy, self._cosine * dy - self._sine * dx

    def _between(self, time, along, across) -> Optional[float]:
        if self._before is None or (self._before[1] >= 0) == (along >= 0):
            return None
        before_time, before_along, before_across = self._before
        part = before_along / (before_along - along)
        if abs(before_across + part * (across - before_across)) > self._line.width / 2:
            return None
        return before_time + part * (time - before_time)


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
        self._level: Optional[int] = None  # laps ahead of the line
        self.lap_times: list[float] = []  # s

    def update(self, time: float, x: float, y: float) -> None:
        """Take the place (m) of the car at a time (s)."""
        self._pass_gates(time, x, y)
        crossing = self._line.crossing(time, x, y)
        if self._level is None:
            self._level = -1 if self._line.is_behind else 0
        if crossing is None:
            return
        if self._line.is_behind:
            self._level -= 1
        elif self._level < len(self.lap_times):
            self._level += 1
        elif self._passed == len(self._gates):
            self._level += 1
            self._passed = 0
            self.lap_times.append(crossing - self._began)
            self._began = crossing

    def _pass_gates(self, time, x, y) -> None:
        for number, gate in enumerate(self._gates):
            crossed = gate.crossing(time, x, y) is not None and not gate.is_behind
            self._passed += crossed and number == self._passed


def times_of_laps(
    line: StartLine, track: CarTrack, start: float, gates: Sequence[StartLine] = ()
) -> list[float]:
    """How long the laps of a track took, s; `start` and `gates` as of LapCounter."""
    counter = LapCounter(line, start, gates)
    for time, x, y, _ in track.places():
        counter.update(time, x, y)
    return counter.lap_times
