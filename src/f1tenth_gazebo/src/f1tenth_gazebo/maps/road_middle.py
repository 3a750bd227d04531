"""The middle of the road that a map shows."""

import math
from dataclasses import replace

import numpy as np
from contourpy import contour_generator
from f1tenth_judge.errors import MapError
from scipy import ndimage

_LEAST_INSIDE = 0.2
"""m^2, the least that a road goes around; anything smaller lies on it"""
_STEP = 0.1
"""m, between the points that are smoothed"""
_SMOOTH = 0.3
"""m, standard deviation: a contour follows the cells"""
_KEPT = 3
"""Every n-th of them is kept."""


def middle_of_road(grid, start=(0.0, 0.0, 0.0)):
    """The line that is as far from what the road goes around as from what is around it.

    Args:
        grid: the map.
        start: x, y (m) and yaw (rad), on the road and along it.

    Returns:
        Array (n, 4), from the start on: x, y and the widths to the right and to the left, m.

    Raises:
        MapError: there is no road at the start, it does not lead back to it, or something stands in its
            middle; does not name the map.
    """
    if not np.all(np.isfinite(start)):
        raise MapError(f"the start is ({', '.join(map(str, start))}), must be finite numbers")
    cell = grid.resolution
    grid = replace(grid, pixels=np.pad(grid.pixels, 1), x=grid.x - cell, y=grid.y - cell)
    inside, outside, others = _sides(grid, start)
    away = [ndimage.distance_transform_edt(~each) * cell for each in (inside, outside)]
    middle = _smooth(max(contour_generator(z=away[1] - away[0]).lines(0.0), key=len) * cell)
    at = middle.T[::-1] / cell
    points = middle + (grid.x + cell / 2, grid.y + cell / 2)
    blocked = points[ndimage.map_coordinates(others.astype(np.uint8), at, order=0) > 0]
    if len(blocked):
        where = f"({blocked[0, 0]:.2f}, {blocked[0, 1]:.2f})"
        raise MapError(
            f"something stands in the middle of the road at {where}; it may go around one thing only"
        )
    width = np.minimum(*(ndimage.map_coordinates(each, at, order=1) for each in away)) - cell / 2
    return _from_start(np.column_stack([points, width, width]), start)[::_KEPT]


def _sides(grid, start):
    """What the road goes around, what is around it, and what else is large and stands on it."""
    free = grid.cells == 0
    parts, _ = ndimage.label(free)
    column, row = (math.floor((at - low) / grid.resolution) for at, low in zip(start, (grid.x, grid.y)))
    rows, columns = free.shape
    if not (0 <= row < rows and 0 <= column < columns and free[row, column]):
        raise MapError(f"at the start ({start[0]:g}, {start[1]:g}) the map shows no road, must be free")
    road = parts == parts[row, column]
    around = ndimage.binary_fill_holes(road)
    holes, _ = ndimage.label(around & ~road)
    sizes = np.bincount(holes.ravel(), minlength=2) * grid.resolution**2
    sizes[0] = 0.0
    if sizes.max() < _LEAST_INSIDE:
        raise MapError("the road at the start goes around nothing, must lead back to the start")
    inside = holes == np.argmax(sizes)
    return inside, ~around, (sizes >= _LEAST_INSIDE)[holes] & ~inside


def _smooth(points):
    """The same closed line, with points at even distances."""
    ways = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    even = np.linspace(0.0, ways[-1], max(3, round(ways[-1] / _STEP)), endpoint=False)
    sampled = np.column_stack([np.interp(even, ways, each) for each in points.T])
    return ndimage.gaussian_filter1d(sampled, _SMOOTH / _STEP, axis=0, mode="wrap")


def _from_start(rows, start):
    """The same line from the start on, in the direction that it faces."""
    rows = np.roll(rows, -np.argmin(np.hypot(*(rows[:, :2] - start[:2]).T)), axis=0)
    heading = rows[1, :2] - rows[-1, :2]
    is_against = heading @ (math.cos(start[2]), math.sin(start[2])) < 0.0
    return np.roll(rows[::-1], 1, axis=0) if is_against else rows
