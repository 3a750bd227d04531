"""The middle of the road that a map shows."""

import math

import numpy as np
from contourpy import contour_generator
from scipy import ndimage

from f1tenth_gazebo.errors import MapError
from f1tenth_gazebo.maps.map_file import Grid

_FREE = 206
"""Pixels from which a cell is free, as map_server's free_thresh of 0.196 has it."""
_LEAST_INSIDE = 0.2
"""m^2, that a road goes around"""
_STEP = 0.1
"""m, between the points that are smoothed"""
_SMOOTH = 0.3
"""m, standard deviation: a contour follows the cells"""
_KEPT = 3
"""Every which of them is kept."""


def middle_of_road(grid, start=(0.0, 0.0, 0.0)):
    """The line that is as far from what the road goes around as from what is around it.

    Islands on the road, which are smaller than what it goes around, are taken for road.

    Args:
        grid: the map.
        start: x, y (m) and yaw (rad), on the road and along it.

    Returns:
        Array (n, 4), from the start on: x, y and the widths to the right and to the left, m.

    Raises:
        MapError: there is no road at the start, or it does not lead back to it; does not name the map.
    """
    cell = grid.resolution
    grid = Grid(np.pad(grid.pixels, 1), grid.x - cell, grid.y - cell, cell)
    away = [ndimage.distance_transform_edt(~each) * cell for each in _sides(grid, start)]
    middle = _smooth(max(contour_generator(z=away[1] - away[0]).lines(0.0), key=len) * cell)
    widths = [ndimage.map_coordinates(each, middle.T[::-1] / cell, order=1) - cell / 2 for each in away]
    return _from_start(middle + (grid.x + cell / 2, grid.y + cell / 2), widths, start)[::_KEPT]


def _sides(grid, start):
    """What the road goes around, and what is around it."""
    free = grid.pixels >= _FREE
    parts, _ = ndimage.label(free)
    column, row = (math.floor((at - low) / grid.resolution) for at, low in zip(start, (grid.x, grid.y)))
    rows, columns = free.shape
    if not (0 <= row < rows and 0 <= column < columns and free[row, column]):
        raise MapError(f"at the start ({start[0]:g}, {start[1]:g}) the map shows no road, must be free")
    road = parts == parts[row, column]
    around = ndimage.binary_fill_holes(road)
    holes, _ = ndimage.label(around & ~road)
    sizes = np.bincount(holes.ravel(), minlength=2)[1:]
    if sizes.max() * grid.resolution**2 < _LEAST_INSIDE:
        raise MapError("the road at the start goes around nothing, must lead back to the start")
    return holes == np.argmax(sizes) + 1, ~around


def _smooth(points):
    """The same closed line, with points at even distances."""
    ways = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    even = np.linspace(0.0, ways[-1], max(3, round(ways[-1] / _STEP)), endpoint=False)
    sampled = np.column_stack([np.interp(even, ways, each) for each in points.T])
    return ndimage.gaussian_filter1d(sampled, _SMOOTH / _STEP, axis=0, mode="wrap")


def _from_start(points, widths, start):
    """The same line from the start on, with its widths to the right and to the left."""
    to_inside, to_outside = widths
    first = np.argmin(np.hypot(*(points - start[:2]).T))
    points, to_inside, to_outside = (
        np.roll(each, -first, axis=0) for each in (points, to_inside, to_outside)
    )
    heading = points[1] - points[-1]
    if heading @ (math.cos(start[2]), math.sin(start[2])) < 0.0:
        points, to_inside, to_outside = (
            np.roll(each[::-1], 1, axis=0) for each in (points, to_inside, to_outside)
        )
    x, y = points.T
    is_inside_left = np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) > 0.0
    right, left = (to_outside, to_inside) if is_inside_left else (to_inside, to_outside)
    return np.column_stack([points, right, left])
