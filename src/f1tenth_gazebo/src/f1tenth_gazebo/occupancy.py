"""An occupancy grid from the section of a world: walls, what can be reached from the start, and the rest."""

import math
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from f1tenth_gazebo.errors import CircuitError

RESOLUTION = 0.05
"""m per cell"""
MARGIN = 0.5
"""Width of the unknown border around everything solid, m."""
_SAMPLES = 5

OCCUPIED, UNKNOWN, FREE = 0, 205, 254
"""Pixel values, as map_saver writes them."""


@dataclass(frozen=True)
class Grid:
    """Pixels of a map, row 0 at the bottom, with the pose of its lower left corner."""

    pixels: np.ndarray
    x: float  # m
    y: float  # m


def occupancy_grid(outlines, circles, start=(0.0, 0.0)):
    """Map what is solid (any cell it reaches into), and as free what can be reached from the start.

    Args:
        outlines: polygons as arrays of (x, y) in m.
        circles: (x, y, radius) in m.
        start: (x, y) in m, a place on the road.

    Raises:
        CircuitError: if nothing is solid, the start is inside of something solid or the road is not closed.
    """
    low, high = _bounds(outlines, circles)
    shape = tuple(int(n) for n in np.ceil((high - low) / RESOLUTION - 1e-9))[::-1]
    solid = np.zeros((shape[0] * _SAMPLES, shape[1] * _SAMPLES), dtype=bool)
    for outline in outlines:
        _fill(solid, low, outline.min(axis=0), outline.max(axis=0), _InPolygon(outline))
    for x, y, radius in circles:
        centre = np.array([x, y])
        _fill(solid, low, centre - radius, centre + radius, _InCircle(x, y, radius))
    occupied = solid.reshape(shape[0], _SAMPLES, shape[1], _SAMPLES).any(axis=(1, 3))

    pixels = np.full(shape, UNKNOWN, dtype=np.uint8)
    pixels[_reachable(occupied, low, start)] = FREE
    pixels[occupied] = OCCUPIED
    return Grid(pixels, float(low[0]), float(low[1]))


def _bounds(outlines, circles):
    points = [*outlines]
    points += [np.array([[x - r, y - r], [x + r, y + r]]) for x, y, r in circles]
    if not points:
        raise CircuitError("nothing is solid at this height")
    everything = np.concatenate(points)
    low = np.floor((everything.min(axis=0) - MARGIN) / RESOLUTION + 1e-9) * RESOLUTION
    return low, everything.max(axis=0) + MARGIN


def _fill(solid, origin, low, high, contains):
    """Mark the samples between low and high that a shape contains."""
    step = RESOLUTION / _SAMPLES
    first = np.maximum(np.floor((low - origin) / step).astype(int), 0)
    last = np.minimum(np.ceil((high - origin) / step).astype(int) + 1, solid.shape[::-1])
    x = origin[0] + (np.arange(first[0], last[0]) + 0.5) * step
    y = origin[1] + (np.arange(first[1], last[1]) + 0.5) * step
    solid[first[1] : last[1], first[0] : last[0]] |= contains(x[np.newaxis, :], y[:, np.newaxis])


class _InPolygon:
    def __init__(self, outline):
        self._edges = list(zip(outline, np.roll(outline, -1, axis=0)))

    def __call__(self, x, y):
        """Even-odd rule."""
        inside = np.zeros(np.broadcast(x, y).shape, dtype=bool)
        for (ax, ay), (bx, by) in self._edges:
            if ay != by:
                crosses = (ay > y) != (by > y)
                inside ^= crosses & (x < ax + (y - ay) * (bx - ax) / (by - ay))
        return inside


class _InCircle:
    def __init__(self, x, y, radius):
        self._x, self._y, self._radius = x, y, radius

    def __call__(self, x, y):
        return (x - self._x) ** 2 + (y - self._y) ** 2 < self._radius**2


def _reachable(occupied, low, start):
    column, row = (math.floor((start[i] - low[i]) / RESOLUTION) for i in (0, 1))
    if not (0 <= row < occupied.shape[0] and 0 <= column < occupied.shape[1]) or occupied[row, column]:
        raise CircuitError(f"the start ({start[0]}, {start[1]}) is not on free ground")
    labels, _ = ndimage.label(~occupied)
    reachable = labels == labels[row, column]
    if reachable[[0, -1], :].any() or reachable[:, [0, -1]].any():
        raise CircuitError(f"the walls around the start ({start[0]}, {start[1]}) have a gap")
    return reachable
