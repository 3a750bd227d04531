"""The middle of the road that a map shows."""

import math
from dataclasses import replace

import numpy as np
from contourpy import contour_generator
from f1tenth_judge.errors import MapError
from scipy import ndimage

from f1tenth_gazebo.maps.passable import HALF_CAR, is_passable

_LEAST_INSIDE = 0.2
"""m^2, the least that a road goes around; anything smaller stands on it"""
_STEP = 0.1
"""m, between the points that are smoothed"""
_SMOOTH = 0.3
"""m, standard deviation: a contour follows the cells"""
_KEPT = 3
"""Every n-th of them is kept."""


def middle_of_road(grid, start=(0.0, 0.0, 0.0)):
    """The line that is as far from what the road goes around as from what is around it.

    What a car cannot pass is closed: dotted walls are walls. What stands on the road belongs to the side
    that it is nearer to.

    Args:
        grid: the map.
        start: x, y (m) and yaw (rad), on the road and along it.

    Returns:
        Array (n, 4), from the start on: x, y and the widths to the right and to the left, m.

    Raises:
        MapError: no car fits on a road at the start, or it does not lead back to it; does not name the map.
    """
    if not np.all(np.isfinite(start)):
        raise MapError(f"the start is ({', '.join(map(str, start))}), must be finite numbers")
    cell = grid.resolution
    turn = np.array([[math.cos(grid.yaw), -math.sin(grid.yaw)], [math.sin(grid.yaw), math.cos(grid.yaw)]])
    place = (np.array(start[:2]) - (grid.x, grid.y)) @ turn / cell + 1.0  # in cells, of the padded grid
    free = is_passable(replace(grid, pixels=np.pad(grid.pixels, 1)))
    sides = _sides(_road(free, place, start, cell), cell)
    away = [ndimage.distance_transform_edt(~each) * cell for each in sides]
    middle = _smooth(max(contour_generator(z=away[1] - away[0]).lines(0.0), key=len) * cell)
    at = middle.T[::-1] / cell
    points = (middle - cell / 2) @ turn.T + (grid.x, grid.y)
    width = np.minimum(*(ndimage.map_coordinates(each, at, order=1) for each in away)) - cell / 2
    if width.min() < HALF_CAR / 2:
        x, y = points[np.argmin(width)]
        raise MapError(f"the road is too narrow for a car at ({x:.2f}, {y:.2f})")
    return _from_start(np.column_stack([points, width, width]), start)[::_KEPT]


def _road(free, place, start, cell):
    """The cells that a car can cover from the start on."""
    where = f"at the start ({start[0]:g}, {start[1]:g})"
    column, row = np.floor(place).astype(int)
    inside = 0 <= row < free.shape[0] and 0 <= column < free.shape[1]
    if not (inside and free[row, column]):
        raise MapError(f"{where} the map shows no road, must be free")
    room = ndimage.distance_transform_edt(free) * cell - cell / 2
    if room[row, column] < HALF_CAR:
        raise MapError(
            f"{where} the road reaches {room[row, column]:.2f} m to a side, must be {HALF_CAR:g} m"
        )
    parts, _ = ndimage.label(room >= HALF_CAR)
    return ndimage.distance_transform_edt(parts != parts[row, column]) * cell <= HALF_CAR


def _sides(road, cell):
    """What the road goes around, and what is around it, each with what stands on the road on its side."""
    around = ndimage.binary_fill_holes(road)
    holes, count = ndimage.label(around & ~road)
    sizes = np.bincount(holes.ravel(), minlength=2) * cell**2
    sizes[0] = 0.0
    if sizes.max() < _LEAST_INSIDE:
        raise MapError("the road at the start goes around nothing, must lead back to the start for a car")
    inside, outside = holes == np.argmax(sizes), ~around
    islands = set(range(1, count + 1)) - {int(np.argmax(sizes))}
    while islands:
        to = [_distances(each, holes, count) for each in (inside, outside)]
        nearest = min(islands, key=lambda island: min(to[0][island], to[1][island]))
        (inside if to[0][nearest] < to[1][nearest] else outside)[holes == nearest] = True
        islands.remove(nearest)
    return inside, outside


def _distances(side, holes, count):
    """How far a side is from each hole, in cells."""
    return ndimage.minimum(ndimage.distance_transform_edt(~side), holes, np.arange(count + 1))


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
