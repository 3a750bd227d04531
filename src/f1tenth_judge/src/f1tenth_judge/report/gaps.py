"""How far the cars of a race are apart, along the road."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from f1tenth_judge.record.record import Record

_SPACING = 0.2  # m, between the places on the road that are told apart
_AT_ONCE = 256  # places that are looked for, so that memory for their distances is small


def gaps_to_leader(record: Record, road: Sequence) -> dict[str, np.ndarray]:
    """How far each car is behind the one that has come farthest, m, in its own periods; 0 for that one.

    `road`: points (m) of its closed middle, in driving order. Empty for a single car, or without a road.
    """
    tracks = [track for track in record.tracks.values() if len(track.time)]
    if len(tracks) < 2 or not len(road):
        return {}
    ways = {track.car: way_along(track.x, track.y, road) for track in tracks}
    gaps = {}
    for own in tracks:
        at = [np.interp(own.time, other.time, ways[other.car]) for other in tracks]
        gaps[own.car] = np.max(at, axis=0) - ways[own.car]
    return gaps


def way_along(xs: np.ndarray, ys: np.ndarray, road: ArrayLike) -> np.ndarray:
    """How far along a road places (m) are, m; adds up from lap to lap, begins at most half a lap away from 0.

    `road` as of gaps_to_leader.
    """
    points = np.asarray(road, dtype=float)
    closed = np.vstack([points, points[:1]])
    at = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(closed, axis=0).T))])
    places = np.arange(0.0, at[-1], _SPACING)
    line_x, line_y = (np.interp(places, at, closed[:, column]) for column in (0, 1))
    nearest = [
        np.argmin((line_x - x[:, None]) ** 2 + (line_y - y[:, None]) ** 2, axis=1)
        for x, y in zip(*(np.split(each, range(_AT_ONCE, len(each), _AT_ONCE)) for each in (xs, ys)))
    ]
    way = np.unwrap(places[np.concatenate(nearest)], period=at[-1])
    return way - at[-1] * np.round(way[0] / at[-1])
