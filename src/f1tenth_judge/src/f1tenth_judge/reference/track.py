"""A closed race track as a line with the room to both sides."""

from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.ndimage import gaussian_filter1d

from f1tenth_judge.places import lookup
from f1tenth_judge.places.course import read_course

SPACING = 0.25  # m, between points of a track
# On a long road they are farther apart: the time for its race line grows with the cube of their number.
_MOST_POINTS = 800
# The bends of a circuit's centreline are polygons, whose kinks would count as curvature.
_SMOOTHING = 0.35  # m, standard deviation
_MAP, _CENTRELINE = "_map.yaml", "_centerline.csv"


def load_track(name: str) -> np.ndarray:
    """Read a track.

    Args:
        name: a circuit of f1tenth_gazebo, or the path of a centreline file (`X_centerline.csv`) or of the map
            beside it (`X_map.yaml`)

    Returns:
        (n, 4): x, y of the line in the map frame, room to its right and left (m); in driving order, about
        SPACING apart or 800 of them, without the first point at the end again.

    Raises:
        ScenarioError: there is no such track, or its file is wrong.
    """
    if name.endswith(_MAP):
        name = name.removesuffix(_MAP) + _CENTRELINE
    file = lookup.course_file(name, Path())
    course = read_course(file)
    rows = np.column_stack([course.x, course.y, course.right, course.left])
    if file.suffix == ".csv":
        return resampled(rows)
    # A circuit is described from the end of its start straight on, and a lap must not begin in a bend.
    return _rounded(np.vstack([[0.0, 0.0, *rows[0, 2:]], rows]))


def resampled(rows: np.ndarray) -> np.ndarray:
    """The same track, smooth between its points, with points as far apart as those of load_track."""
    closed, at, distances = _places(rows)
    line = CubicSpline(at, closed[:, :2], bc_type="periodic")(distances)
    return np.column_stack([line, *_between(closed, at, distances, (2, 3))])


def _rounded(rows: np.ndarray) -> np.ndarray:
    """The same track, straight between its points but rounded at them; points spaced as by load_track."""
    closed, at, distances = _places(rows)
    line = np.column_stack(_between(closed, at, distances, (0, 1)))
    line = gaussian_filter1d(line, _SMOOTHING / distances[1], axis=0, mode="wrap")
    return np.column_stack([line, *_between(closed, at, distances, (2, 3))])


def _places(rows: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The closed track, how far along each of its points lies, and where points are to lie; m."""
    closed = np.vstack([rows, rows[:1]])
    at = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(closed[:, :2], axis=0).T))])
    count = min(round(at[-1] / SPACING), _MOST_POINTS)
    return closed, at, np.arange(count) * at[-1] / count


def _between(closed, at, distances, columns) -> list[np.ndarray]:
    return [np.interp(distances, at, closed[:, column]) for column in columns]
