"""A map as map_saver writes it: NAME.pgm and NAME.yaml."""

import contextlib
import math
import warnings
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import yaml
from PIL import Image

from f1tenth_judge.atomic import write_all
from f1tenth_judge.errors import MapError

RESOLUTION = 0.05
"""m per cell"""
OCCUPIED, UNKNOWN, FREE = 100, -1, 0  # cells of a nav_msgs/OccupancyGrid
_PIXELS_MAX = 100_000_000  # as the simulator
_YAML = """image: {image}
resolution: {resolution:.6f}
origin: [{x:.6f}, {y:.6f}, 0.000000]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196

"""


@dataclass(frozen=True)
class Grid:
    """Pixels of a map, row 0 at the bottom, with the pose of its lower left corner."""

    pixels: np.ndarray
    x: float  # m
    y: float  # m
    resolution: float = RESOLUTION  # m
    free_thresh: float = 0.196  # how dark a free pixel is at most: 0 is white, 1 black
    occupied_thresh: float = 0.65  # and how dark one of a wall is at least
    yaw: float = 0.0  # rad, of its rows

    @property
    def extent(self):
        """What it covers, m: left, right, bottom, top."""
        height, width = (size * self.resolution for size in self.pixels.shape)
        return self.x, self.x + width, self.y, self.y + height

    @cached_property
    def cells(self):
        """Those of a nav_msgs/OccupancyGrid, int8, as map_server makes them from pixels (mode trinary)."""
        dark = (255.0 - self.pixels) / 255.0
        return np.select(
            [dark > self.occupied_thresh, dark < self.free_thresh], [OCCUPIED, FREE], UNKNOWN
        ).astype(np.int8)


def load_map(path, may_be_turned=False):
    """Read a map in map_server's format, dark where something is.

    Args:
        path: of the YAML file.
        may_be_turned: whether the caller heeds Grid.yaw; otherwise a map that is turned is refused.

    Raises:
        MapError: it is not one, or a file of it cannot be read.
    """
    try:
        description = yaml.safe_load(path.read_text(encoding="utf-8"))
        if not isinstance(description, dict):
            raise ValueError("it has no keys")
        pixels = _pixels(path.parent / description["image"])
        x, y, resolution = _placement(description)
        pixels = 255 - pixels if description.get("negate") else pixels
        free, occupied = (
            float(description.get(key, getattr(Grid, key))) for key in ("free_thresh", "occupied_thresh")
        )
        yaw = sum(map(float, description["origin"][2:3]))
        grid = Grid(pixels, x, y, resolution, free, occupied, yaw)
    except (OSError, ValueError, KeyError, TypeError, RecursionError, yaml.YAMLError) as error:
        raise MapError(_problem(path, error)) from error
    if yaw and not may_be_turned:
        raise MapError(f"{path}: its origin is turned by {yaw:g} rad, must not be turned")
    return grid


@contextlib.contextmanager
def _without_warning():
    """Pillow warns of fewer pixels than are too many here."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", Image.DecompressionBombWarning)
        yield


def _pixels(path):
    """Shape (rows, columns), uint8, row 0 at the bottom."""
    try:
        with _without_warning(), Image.open(path) as image:
            width, height = image.size
            if width * height > _PIXELS_MAX:
                raise ValueError(f"{path.name} has {width} x {height} pixels, allowed are 1 to {_PIXELS_MAX}")
            return np.asarray(image.convert("L"))[::-1]
    except Image.DecompressionBombError as error:
        raise ValueError(f"{path.name} has too many pixels, allowed are 1 to {_PIXELS_MAX}") from error


def _placement(description):
    """Where the lower left corner is, x and y (m), and the resolution (m per cell)."""
    x, y, resolution = map(float, (*description["origin"][:2], description["resolution"]))
    if not 0.0 < resolution < math.inf:
        raise ValueError(f"resolution is {resolution:g}, must be above 0 and finite")
    if not (math.isfinite(x) and math.isfinite(y)):
        raise ValueError(f"origin is ({x:g}, {y:g}), must be finite")
    return x, y, resolution


def _problem(path, error):
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename or path}: cannot be read: {error.strerror}"
    text = " ".join(str(error).split())
    return f"{path}: not a map in map_server's format: {text}"


def map_files(grid, stem):
    """What STEM.pgm and STEM.yaml are to hold, by path; STEM is a path without extension."""
    rows, columns = grid.pixels.shape
    header = f"P5\n# CREATOR: make_map {grid.resolution:.3f} m/pix\n{columns} {rows}\n255\n"
    text = _YAML.format(image=f"{stem.name}.pgm", resolution=grid.resolution, x=grid.x, y=grid.y)
    return {
        stem.with_name(f"{stem.name}.pgm"): header.encode() + grid.pixels[::-1].tobytes(),
        stem.with_name(f"{stem.name}.yaml"): text.encode(),
    }


def save_map(grid, stem):
    """Write STEM.pgm and STEM.yaml, both or none.

    Raises:
        OSError: if a file cannot be written.
    """
    write_all(map_files(grid, Path(stem)))
