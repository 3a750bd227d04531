"""A closed race track as a line with the room to both sides."""

import warnings
from pathlib import Path

import numpy as np
from f1tenth_gazebo.centreline import centreline
from f1tenth_gazebo.circuit_file import load_circuit
from f1tenth_gazebo.errors import CircuitError
from f1tenth_gazebo.lap import Lap
from scipy.interpolate import CubicSpline
from scipy.ndimage import gaussian_filter1d

from f1tenth_scenarios import places
from f1tenth_scenarios.errors import ScenarioError

SPACING = 0.25  # m, between points of a track
# The bends of a centreline are polygons, whose kinks would count as curvature.
_SMOOTHING = 0.35  # m, standard deviation


def load_track(name: str) -> np.ndarray:
    """Read a track.

    Args:
        name: a circuit of f1tenth_gazebo, or the path of a centreline file (`X_centerline.csv`)

    Returns:
        (n, 4): x, y of the line in the map frame, room to its right and left (m); in driving order,
        about SPACING apart, without the first point at the end again.

    Raises:
        ScenarioError: there is no such track, or its file is wrong.
    """
    return _read_centreline(Path(name)) if name.endswith(".csv") else _sample_circuit(name)


def _sample_circuit(name):
    folder = places.package_path(places.GAZEBO_PACKAGE) / "circuits"
    path = folder / f"{name}.yaml"
    if not path.is_file():
        known = ", ".join(sorted(each.stem for each in folder.glob("*.yaml")))
        raise ScenarioError(
            f"no circuit '{name}'; there are: {known}, or give the path of a centreline (.csv)"
        )
    try:
        vertices = centreline(load_circuit(path))
    except CircuitError as error:
        raise ScenarioError(str(error)) from error
    lap = Lap(vertices)
    count = round(lap.length / SPACING)
    distances = np.arange(count) * lap.length / count
    points = np.array([(pose.x, pose.y) for pose in map(lap.pose, distances)])
    half_width = _width_at(vertices, distances, lap.length) / 2
    points = gaussian_filter1d(points, _SMOOTHING / SPACING, axis=0, mode="wrap")
    return np.column_stack([points, half_width, half_width])


def _width_at(vertices, distances, length):
    points = np.array([(0.0, 0.0)] + [(vertex.x, vertex.y) for vertex in vertices])
    at = np.cumsum(np.hypot(*np.diff(points, axis=0).T))
    return np.interp(distances, at, [vertex.width for vertex in vertices], period=length)


def _read_centreline(path):
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # of an empty file, which the shape tells
            rows = np.loadtxt(path, delimiter=",", comments="#", ndmin=2)
    except (OSError, ValueError) as error:
        raise ScenarioError(f"{path}: {' '.join(str(error).split())}") from error
    if rows.shape[0] < 4 or rows.shape[1] != 4 or not np.isfinite(rows).all():
        raise ScenarioError(
            f"{path}: {rows.shape[0]} rows of {rows.shape[1]} numbers, must be at least 4 rows of"
            " x_m, y_m, w_tr_right_m, w_tr_left_m"
        )
    return resampled(rows)


def resampled(rows: np.ndarray) -> np.ndarray:
    """The same track with points SPACING apart."""
    closed = np.vstack([rows, rows[:1]])
    at = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(closed[:, :2], axis=0).T))])
    count = round(at[-1] / SPACING)
    distances = np.arange(count) * at[-1] / count
    line = CubicSpline(at, closed[:, :2], bc_type="periodic")(distances)
    room = np.column_stack([np.interp(distances, at, closed[:, column]) for column in (2, 3)])
    return np.column_stack([line, room])
