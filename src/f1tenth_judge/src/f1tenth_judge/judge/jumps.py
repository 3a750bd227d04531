"""Jumps of a car: between two periods it was put elsewhere, as nothing that drives is."""

from collections.abc import Iterator, Sequence

import numpy as np

from f1tenth_judge.record.interventions import Intervention, Jump
from f1tenth_judge.record.record import STAMP_EPSILON, CarTrack, Record

# On top of what the greater of the two speeds explains.
_ROOM, _TURN = 0.05, 0.2  # m, rad


def find_jumps(record: Record, interventions: Sequence[Intervention]) -> list[Intervention]:
    """Those of all cars for which the simulator has noted no intervention, in the order of time."""
    found = [each for track in record.tracks.values() for each in _jumps(track, interventions)]
    return sorted(found, key=lambda each: each.stamp)


def _jumps(track: CarTrack, interventions: Sequence[Intervention]) -> Iterator[Jump]:
    period, way = np.diff(track.time), np.hypot(np.diff(track.x), np.diff(track.y))
    turn = np.abs((np.diff(track.yaw) + np.pi) % (2 * np.pi) - np.pi)
    is_jump = (way > _most(track.speed) * period + _ROOM) | (turn > _most(track.yaw_rate) * period + _TURN)
    for index in np.flatnonzero(is_jump):
        before, stamp = float(track.time[index]), float(track.time[index + 1])
        # What is pressed together is pushed apart.
        touches = track.contacts[index] or track.contacts[index + 1]
        if not touches and not any(
            before - STAMP_EPSILON <= each.stamp <= stamp + STAMP_EPSILON for each in interventions
        ):
            yield Jump(stamp, "jump", "", track.car, float(way[index]), float(turn[index]), stamp - before)


def _most(values: np.ndarray) -> np.ndarray:
    """The greater magnitude of each two neighbours."""
    return np.maximum(np.abs(values[:-1]), np.abs(values[1:]))
