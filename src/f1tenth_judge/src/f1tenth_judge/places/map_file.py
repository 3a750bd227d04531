"""A map as map_saver writes it: NAME.pgm and NAME.yaml."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

import f1tenth_sim2d
from f1tenth_judge.atomic import write_all
from f1tenth_judge.errors import MapError

RESOLUTION = 0.05
"""m per cell"""
OCCUPIED, UNKNOWN, FREE = 100, -1, 0  # cells of a nav_msgs/OccupancyGrid
_BLACK, _GREY, _WHITE = 0, 205, 254  # as map_saver draws them
_OCCUPIED_THRESH, _FREE_THRESH = 0.65, 0.196  # how dark, from white 0 to black 1
_YAML = f"""image: {{image}}
resolution: {{resolution:.6f}}
origin: [{{x:.6f}}, {{y:.6f}}, 0.000000]
negate: 0
occupied_thresh: {_OCCUPIED_THRESH}
free_thresh: {_FREE_THRESH}

"""


@dataclass(frozen=True)
class Grid:
    """Pixels of a map, row 0 at the bottom, with the pose of its lower left corner."""

    pixels: np.ndarray
    x: float  # m
    y: float  # m
    resolution: float = RESOLUTION  # m
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
        known = [dark > _OCCUPIED_THRESH, dark < _FREE_THRESH]
        return np.select(known, [OCCUPIED, FREE], UNKNOWN).astype(np.int8)


def load_map(path, may_be_turned=False):
    """Read a map in map_server's format, dark where something is, as the simulator reads it.

    Args:
        path: of the YAML file.
        may_be_turned: whether the caller heeds Grid.yaw; otherwise a map that is turned is refused.

    Raises:
        MapError: it is not one, or a file of it cannot be read.
    """
    try:
        cells, resolution, (x, y, yaw) = f1tenth_sim2d.read_map(path)
    except f1tenth_sim2d.Error as error:
        raise MapError(str(error)) from error
    if yaw and not may_be_turned:
        raise MapError(f"{path}: its origin is turned by {yaw:g} rad, must not be turned")
    shades = np.select([cells == OCCUPIED, cells == FREE], [_BLACK, _WHITE], _GREY)
    return Grid(shades.astype(np.uint8), x, y, resolution, yaw)


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
