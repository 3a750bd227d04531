"""When and where a car left the road."""

import dataclasses
from collections.abc import Iterable, Iterator

import numpy as np

from f1tenth_judge.places.course import Course
from f1tenth_judge.record.record import CarTrack


@dataclasses.dataclass(frozen=True)
class Excursion:
    """A stretch of periods in which a car's base_footprint was beyond the edge of the road."""

    car: str
    start: float  # s
    end: float  # s
    excess: float  # m, beyond the edge, at most
    x: float  # m, where that was
    y: float  # m


def excursions(course: Course, tracks: Iterable[CarTrack]) -> Iterator[Excursion]:
    """Those of each car, in order."""
    for track in tracks:
        beyond = course.excess(track.x, track.y)
        bounds = np.flatnonzero(np.diff(np.concatenate([[False], beyond > 0.0, [False]])))
        for first, after in bounds.reshape(-1, 2):
            worst = first + int(np.argmax(beyond[first:after]))
            times = float(track.time[first]), float(track.time[after - 1])
            place = float(track.x[worst]), float(track.y[worst])
            yield Excursion(track.car, *times, float(beyond[worst]), *place)
