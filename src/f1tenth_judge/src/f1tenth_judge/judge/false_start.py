"""Cars that move before the race has begun."""

import math
from collections.abc import Mapping, Sequence
from typing import Optional

from f1tenth_judge.plan.task import Task
from f1tenth_judge.record.observations import RaceState, RaceUpdate
from f1tenth_judge.record.record import STAMP_EPSILON, Record
from f1tenth_judge.scenario.scenario import Scenario

_DISTANCE = 0.05  # m, from where a car was put


class FirstMoves:
    """When each car has left its place, s by car."""

    def __init__(self):
        self.stamps: dict[str, float] = {}
        self._places: dict[str, tuple[float, float]] = {}

    def take(self, stamp: float, car: str, x: float, y: float) -> None:
        """Where a car was in a period (s, m); in order of time."""
        if car not in self.stamps and math.dist((x, y), self._places.setdefault(car, (x, y))) > _DISTANCE:
            self.stamps[car] = stamp


def moves_of(record: Record) -> FirstMoves:
    """The first moves in a record."""
    moves = FirstMoves()
    for track in record.tracks.values():
        for stamp, x, y, _ in track.places():
            moves.take(stamp, track.car, x, y)
            if track.car in moves.stamps:
                break
    return moves


def race_start(updates: Sequence[RaceUpdate]) -> Optional[float]:
    """When the first race began, s; None if none was heard to begin."""
    begun = (each.stamp for each in updates if each.state is RaceState.RACING and not each.goals_reached)
    return min(begun, default=None)


def find_false_start(
    scenario: Scenario, tasks: Mapping[str, Task], moves: FirstMoves, updates: Sequence[RaceUpdate]
) -> Optional[tuple[float, str]]:
    """The first false start of a car that is to wait for the start, s, and in words; nothing without one.

    Before the countdown can be over, a move is one, whatever is heard of the start.
    """
    early = [(stamp, car) for car, stamp in moves.stamps.items() if car in tasks and tasks[car].obeys_start]
    if not early:
        return None
    stamp, car = min(early)
    said = f"false start: {car} moved at {stamp:.3f} s, before"
    if stamp + STAMP_EPSILON < scenario.time_to_start:
        return stamp, f"{said} the countdown of {scenario.time_to_start} s was over"
    start = race_start(updates)
    if start is not None and stamp + STAMP_EPSILON < start:
        return stamp, f"{said} the start at {start:.3f} s"
    return None
