"""Places to drive in: circuits, worlds and maps."""

import functools
import re
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

import f1tenth_sim2d
from f1tenth_sim2d.environments.data import data_path

_IMAGE = re.compile(r"""^image\s*:\s*(["']?)(?P<name>.*?)\1\s*(#.*)?$""", re.MULTILINE)
_COLUMNS = "x_m, y_m, w_tr_right_m, w_tr_left_m"


@dataclass(frozen=True)
class Place:
    """A world, and the road through it if there is one."""

    name: str
    world: Any
    """f1tenth_sim2d.World"""
    course: Any
    """f1tenth_sim2d.Course, or None"""
    centreline: Any
    """array of shape (n, 4): x, y, width to the right and to the left, m; or None"""

    def half_width(self, distance):
        """The lesser of the road's two half widths at a distance (m) along the course, m."""
        return self._at(distance, self._half_widths)

    def width_to_the(self, side, distance):
        """Width of the road to the "right" or to the "left" of the course at a distance (m) along it, m."""
        return self._at(distance, self.centreline[:, 2 if side == "right" else 3])

    def _at(self, distance, widths):
        return float(np.interp(distance, self._along, widths, period=self.course.length))

    @functools.cached_property
    def _along(self):
        steps = np.hypot(*np.diff(self.centreline[:, :2], axis=0).T)
        return np.concatenate([[0.0], np.cumsum(steps)])

    @functools.cached_property
    def _half_widths(self):
        return self.centreline[:, 2:].min(axis=1)


def circuits():
    """Names of the circuits."""
    return sorted(path.stem for path in data_path("f1tenth_gazebo/worlds").glob("*.world"))


def find_place(place):
    """Load a place.

    Args:
        place: the name of a circuit, or the path of a .world file or of a map's .yaml file. Its course is
            that of X_centerline.csv beside X.world, X.yaml or X_map.yaml, in the form of f1tenth_racetracks.

    Raises:
        ValueError: no such place.
        f1tenth_sim2d.LoadError: a file that cannot be used.
    """
    path = Path(place if isinstance(place, (str, PathLike)) else "")
    if str(place) in circuits():
        path = data_path(f"f1tenth_gazebo/worlds/{place}.world")
    elif path.suffix.lower() not in {".world", ".yaml"} or not path.is_file():
        raise ValueError(
            f"place: found {str(place)!r}, allowed are {', '.join(circuits())}, "
            "and paths of .world files and of maps' .yaml files"
        )
    path = path.resolve()
    return _load(path, tuple(map(_stamp, (path, _image(path), _table(path)))))


def _stamp(path):
    return path.stat().st_mtime_ns if path.is_file() else None


def _table(path):
    """Path of the centreline, whether it is there or not."""
    return path.with_name(path.stem.removesuffix("_map") + "_centerline.csv")


def _image(path):
    """Path of a map's image, or that of the world itself."""
    found = _IMAGE.search(path.read_text(errors="replace")) if path.suffix.lower() == ".yaml" else None
    return path if found is None else path.parent / found["name"]


@functools.lru_cache(maxsize=8)
def _load(path, _changed):
    world = f1tenth_sim2d.load_world(str(path), [str(data_path("f1tenth_gazebo/models"))])
    table = _table(path)
    if not table.is_file():
        return Place(path.stem, world, None, None)
    centreline = _read_centreline(table)
    try:
        return Place(path.stem, world, f1tenth_sim2d.Course(centreline[:, :2]), centreline)
    except f1tenth_sim2d.Error as error:
        raise ValueError(f"{table}: {error}") from error


def _read_centreline(path):
    rows = f1tenth_sim2d.read_centreline(path)
    if rows.shape[1] < 4:
        raise ValueError(f"{path}: gives no widths of the road, allowed are lines of {_COLUMNS}")
    return rows
