"""Whether and when a car passed its goals, from where it was."""

import dataclasses
from collections.abc import Sequence
from typing import Optional

import numpy as np

from f1tenth_scenarios.record.record import CarTrack
from f1tenth_scenarios.scenario.car import Pose


@dataclasses.dataclass(frozen=True)
class GoalPasses:
    """How far a car got through its goals in order."""

    times: tuple[float, ...]  # s, of the goals passed
    wanted: int
    nearest: Optional[float] = None  # m, to the first goal that was not passed, after the one before it

    @property
    def complete(self) -> bool:
        """Whether every goal was passed in order."""
        return len(self.times) == self.wanted


def find_passes(track: CarTrack, goals: Sequence[Pose], tolerance: float, yaw_tolerance: float) -> GoalPasses:
    """Go through the goals in order.

    A goal is passed in the first period, not before the pass of the one before it, in which the car is within
    the tolerances (m, rad).
    """
    times: list[float] = []
    first = 0
    for goal in goals:
        distance = np.hypot(track.x[first:] - goal.x, track.y[first:] - goal.y)
        turn = np.abs((track.yaw[first:] - goal.yaw + np.pi) % (2 * np.pi) - np.pi)
        hits = np.flatnonzero((distance <= tolerance) & (turn <= yaw_tolerance))
        if not len(hits):
            return GoalPasses(tuple(times), len(goals), float(distance.min()) if len(distance) else None)
        first += int(hits[0])
        times.append(float(track.time[first]))
    return GoalPasses(tuple(times), len(goals))
