"""The course of a race: a closed centreline and how far the road reaches on either side of it."""

import dataclasses
import math
from pathlib import Path

import numpy as np

import f1tenth_sim2d
from f1tenth_judge.errors import FileError, ScenarioError, as_scenario_error
from f1tenth_judge.places.centreline import centreline
from f1tenth_judge.places.circuit_file import load_circuit

_LEAST_POINTS = 3  # of a closed line
_LEAST_GAP = 5.0  # steps between its other points, by which the ends of an open one are apart

_STEP = 0.01  # m, of a look for the edge of the road


@dataclasses.dataclass(frozen=True)
class Course:
    """Arrays of shape (n,), one value per vertex; the last vertex is joined to the first."""

    x: np.ndarray  # m
    y: np.ndarray  # m
    right: np.ndarray  # m, from the centreline to the road's edge
    left: np.ndarray  # m

    def excess(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """How far points (m) lie beyond the nearest edge of the road, m; 0 on the road."""
        return np.array([self._excess(*point) for point in zip(x, y)])

    @property
    def length(self) -> float:
        """Of the centreline, m."""
        return float(np.hypot(*self._ahead()).sum())

    def inside(self, x: np.ndarray, y: np.ndarray, margin: float) -> tuple[np.ndarray, np.ndarray]:
        """Points (m) moved towards the centreline until they are `margin` (m) from the edges of the road."""
        moved = [self._inside(*point, margin) for point in zip(x, y)]
        return np.array([each[0] for each in moved]), np.array([each[1] for each in moved])

    def _inside(self, x: float, y: float, margin: float) -> tuple[float, float]:
        index, part, off_x, off_y = self._foot(x, y)
        is_left = self._ahead()[0][index] * off_y - self._ahead()[1][index] * off_x > 0
        width = self._between(self.left if is_left else self.right, part)[index]
        distance = float(np.hypot(off_x, off_y))
        excess = 1 - min(1.0, max(width - margin, 0.0) / max(distance, 1e-9))
        return x - excess * off_x, y - excess * off_y

    def nearest(self, x: float, y: float) -> tuple[float, float]:
        """The place of the centreline that is nearest to a point, m."""
        _, _, off_x, off_y = self._foot(x, y)
        return x - off_x, y - off_y

    def widths(self, x: float, y: float) -> tuple[float, float]:
        """How far the road reaches to the right and to the left of the centreline where it is nearest, m."""
        index, part, _, _ = self._foot(x, y)
        return float(self._between(self.right, part)[index]), float(self._between(self.left, part)[index])

    def reach(self, x: float, y: float, direction: float, most: float) -> float:
        """How far the road goes on from a point on it (m) in a direction (rad), m; to a centimetre."""
        for count in range(round(most / _STEP)):
            way = (count + 1) * _STEP
            if self._excess(x + way * math.cos(direction), y + way * math.sin(direction)):
                return count * _STEP
        return most

    def direction(self, x: float, y: float, yaw: float) -> float:
        """The heading (rad) of the road at a point, turned as `yaw` is: in a corner, halfway round it."""
        half = sum(self.widths(x, y)) / 2
        ahead_x, ahead_y, _ = self.ahead_of(x, y, yaw, half)
        back_x, back_y, _ = self.ahead_of(x, y, yaw + math.pi, half)
        return math.atan2(ahead_y - back_y, ahead_x - back_x)

    def runs_along(self, x: float, y: float, yaw: float) -> bool:
        """Whether a heading (rad) at a point (m) goes with the centreline and not against it."""
        index = self._foot(x, y)[0]
        ahead_x, ahead_y = self._ahead()
        return bool(ahead_x[index] * math.cos(yaw) + ahead_y[index] * math.sin(yaw) >= 0.0)

    def ahead_of(self, x: float, y: float, yaw: float, way: float) -> tuple[float, float, float]:
        """The pose (m, rad) a distance `way` (m) along the centreline from a pose, in its direction."""
        index, part, _, _ = self._foot(x, y)
        along = self.along()
        here = along[index] + part * (along[index + 1] - along[index])
        is_along = self.runs_along(x, y, yaw)
        place = (here + (way if is_along else -way)) % along[-1]
        there_x, there_y, heading = (float(each[0]) for each in self.poses_at(np.array([place])))
        return there_x, there_y, heading if is_along else math.remainder(heading + math.pi, math.tau)

    def along(self) -> np.ndarray:
        """How far along the centreline each vertex is, and the first one again, m: shape (n + 1,)."""
        return np.concatenate([[0.0], np.cumsum(np.hypot(*self._ahead()))])

    def poses_at(self, places: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Poses (m, rad) on the centreline at distances (m) along it; headed as the piece leading there."""
        x, y, along = np.append(self.x, self.x[0]), np.append(self.y, self.y[0]), self.along()
        pieces = np.clip(np.searchsorted(along, places) - 1, 0, len(along) - 2)
        headings = np.arctan2(np.diff(y), np.diff(x))[pieces]
        return np.interp(places, along, x), np.interp(places, along, y), headings

    def _excess(self, x: float, y: float) -> float:
        part, off_x, off_y = self._nearest(x, y)
        is_left = self._ahead()[0] * off_y - self._ahead()[1] * off_x > 0
        width = np.where(is_left, self._between(self.left, part), self._between(self.right, part))
        return max(0.0, float((np.hypot(off_x, off_y) - width).min()))

    def _ahead(self) -> tuple[np.ndarray, np.ndarray]:
        """From each vertex to the next one, m."""
        return np.roll(self.x, -1) - self.x, np.roll(self.y, -1) - self.y

    def _nearest(self, x: float, y: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The nearest place on the piece behind each vertex: which part of it, and from there to x, y (m)."""
        ahead_x, ahead_y = self._ahead()
        squares = np.maximum(ahead_x**2 + ahead_y**2, 1e-12)
        part = np.clip(((x - self.x) * ahead_x + (y - self.y) * ahead_y) / squares, 0.0, 1.0)
        return part, x - self.x - part * ahead_x, y - self.y - part * ahead_y

    def _foot(self, x: float, y: float) -> tuple[int, float, float, float]:
        """The place of the centreline nearest to a point: piece, part of it, and from there to x, y (m)."""
        part, off_x, off_y = self._nearest(x, y)
        index = int(np.argmin(np.hypot(off_x, off_y)))
        return index, part[index], off_x[index], off_y[index]

    @staticmethod
    def _between(values, part):
        return values + part * (np.roll(values, -1) - values)


def read_course(path: Path) -> Course:
    """Read a circuit of f1tenth_gazebo (YAML) or a centreline of the F1TENTH community (X_centerline.csv).

    Raises:
        ScenarioError: with the file, the line and what is wrong there.
    """
    return _from_circuit(path) if path.suffix == ".yaml" else _from_table(path)


def _from_circuit(path):
    with as_scenario_error(FileError):
        vertices = centreline(load_circuit(path))
    x, y, width = np.array([(each.x, each.y, each.width) for each in vertices]).T
    return Course(x, y, width / 2, width / 2)


def _from_table(path):
    with as_scenario_error(f1tenth_sim2d.Error):
        rows = f1tenth_sim2d.read_centreline(path)
    count, columns = rows.shape
    if columns != 4 or count < _LEAST_POINTS:
        raise ScenarioError(
            f"{path}: found {count} different points of {columns} numbers, must be at least {_LEAST_POINTS}:"
            " x_m, y_m, w_tr_right_m, w_tr_left_m"
        )
    course = Course(*rows.T)
    if problem := _problem(course):
        raise ScenarioError(f"{path}: {problem}")
    return course


def _problem(course: Course) -> str:
    """Why a line is not the middle of a road that leads back to its beginning; empty if it may be."""
    widths = course.right + course.left
    if course.length <= widths.max():
        return f"is {course.length:.3g} m long for a road {widths.max():.3g} m wide; all numbers must be in m"
    *steps, gap = np.diff(course.along())
    if gap > max(widths[0], _LEAST_GAP * max(steps)):
        return f"its ends are {gap:.3g} m apart, other points at most {max(steps):.3g} m; it must be closed"
    return ""
