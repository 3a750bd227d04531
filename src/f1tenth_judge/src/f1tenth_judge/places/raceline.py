"""A line to drive along, with the speed at each of its points."""

import dataclasses
import math
from pathlib import Path

import numpy as np

from f1tenth_judge.places.course import Course, read_course
from f1tenth_judge.places.numbers import read_numbers

RACELINE = "_raceline.csv"  # ending of a file's name
COLUMNS = "s_m; x_m; y_m; psi_rad; kappa_radpm; vx_mps; ax_mps2"
# m: half the car, and how far walls in a map and drivers are off their lines.
_MARGIN = 0.6


@dataclasses.dataclass(frozen=True)
class Raceline:
    """A closed line: arrays of shape (n,), the last point is joined to the first."""

    x: np.ndarray  # m
    y: np.ndarray  # m
    speed: np.ndarray  # m/s; infinite where the line does not say
    room: float = 0.05  # m, by which a car may leave it: a raceline goes close to walls

    @property
    def lap_time(self) -> float:
        """A lap along it at its speeds, s."""
        way = np.hypot(np.roll(self.x, -1) - self.x, np.roll(self.y, -1) - self.y)
        return float((2.0 * way / (self.speed + np.roll(self.speed, -1))).sum())


def kept_inside(line: Raceline, course: Course) -> Raceline:
    """The line where it is far enough from the road's edges for a car; elsewhere moved towards the middle."""
    x, y = course.inside(line.x, line.y, _MARGIN)
    return dataclasses.replace(line, x=x, y=y)


def read_raceline(path: Path) -> Raceline:
    """Read a raceline of the F1TENTH community (X_raceline.csv), or the middle of a course.

    Raises:
        ScenarioError: with the file, the line and what is wrong there.
    """
    if not path.name.endswith(RACELINE):
        course = read_course(path)
        room = float(np.minimum(course.left, course.right).min()) / 3
        return Raceline(course.x, course.y, np.full(len(course.x), math.inf), room)
    table = read_numbers(path, ";", COLUMNS)
    table = table[np.any(table[:, 1:3] != np.roll(table[:, 1:3], 1, axis=0), axis=1)]
    return Raceline(table[:, 1], table[:, 2], table[:, 5])
