"""Whether and when a car passed its goals, from where it was."""

from collections.abc import Sequence
from typing import Optional

import numpy as np

from f1tenth_judge.record.record import CarTrack
from f1tenth_judge.scenario.car import Pose


class GoalPasses:
    """How far a car has got through its goals in order.

    A goal is passed in the first period, not before the pass of the one before it, in which the car is within
    the tolerances (m, rad).
    """

    def __init__(self, goals: Sequence[Pose], tolerance: float, yaw_tolerance: float):
        self._goals, self._tolerance, self._yaw_tolerance = goals, tolerance, yaw_tolerance
        self.wanted = len(goals)
        self.times: list[float] = []  # s, of the goals passed
        self.nearest: Optional[float] = None  # m, to the next goal, since the pass before

    @property
    def complete(self) -> bool:
        """Whether every goal was passed in order."""
        return len(self.times) == self.wanted

    def update(self, time: float, x: float, y: float, yaw: float) -> None:
        """Take the place of the car in a period (s, m, rad); in order of time."""
        while not self.complete:
            goal = self._goals[len(self.times)]
            distance = float(np.hypot(x - goal.x, y - goal.y))
            turn = abs((yaw - goal.yaw + np.pi) % (2 * np.pi) - np.pi)
            if not (distance <= self._tolerance and turn <= self._yaw_tolerance):
                self.nearest = distance if self.nearest is None else min(self.nearest, distance)
                return
            self.times.append(time)
            self.nearest = None


def find_passes(track: CarTrack, goals: Sequence[Pose], tolerance: float, yaw_tolerance: float) -> GoalPasses:
    """How far a car has got where its track ends."""
    passes = GoalPasses(goals, tolerance, yaw_tolerance)
    for place in track.places():
        passes.update(*place)
    return passes
