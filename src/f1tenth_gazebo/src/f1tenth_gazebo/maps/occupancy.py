"""An occupancy grid from the section of a world: walls, what can be reached from the start, and the rest."""

import math
from functools import partial

import numpy as np
from f1tenth_judge.errors import CircuitError
from f1tenth_judge.places.map_file import RESOLUTION, Grid
from scipy import ndimage

MARGIN = 0.5
"""Width of the unknown border around everything solid, m."""
_SAMPLES = 5
_CELLS_MAX = 100_000_000

OCCUPIED, UNKNOWN, FREE = 0, 205, 254
"""Pixel values, as map_saver writes them."""


def occupancy_grid(outlines, circles):
    """Map what is solid (any cell it reaches into), and as free what can be reached from the origin.

    Args:
        outlines: polygons as arrays of (x, y) in m.
        circles: (x, y, radius) in m.

    Raises:
        CircuitError: if nothing is solid, the origin is inside of something solid or the road is not closed.
    """
    occupied, low = occupied_cells(outlines, circles, RESOLUTION)
    return grid_of(occupied, _reachable(occupied, low), low, RESOLUTION)


def open_grid(outlines, circles, extent):
    """Map what is solid in a rectangle, and all else there as free.

    Args:
        outlines, circles: as for occupancy_grid.
        extent: x and y of its lower left corner, x and y of its upper right one, m.

    Raises:
        CircuitError: no rectangle, or one of too many cells.
    """
    low, high = np.array(extent[:2]), np.array(extent[2:])
    cells = (high - low) / RESOLUTION
    if not (np.isfinite(cells).all() and cells.min() >= 1.0 and cells.prod() <= _CELLS_MAX):
        raise CircuitError(
            f"the extent is {', '.join(f'{each:g}' for each in extent)}, must be XMIN YMIN XMAX YMAX with "
            f"each maximum above its minimum, of at most {_CELLS_MAX} cells of {RESOLUTION} m"
        )
    occupied, low = occupied_cells(outlines, circles, RESOLUTION, (low, high))
    return grid_of(occupied, ~occupied, low, RESOLUTION)


def occupied_cells(outlines, circles, resolution, bounds=None):
    """(which cells something solid reaches into, row 0 at the bottom; the lower left corner of the grid, m).

    Args:
        outlines, circles: as for occupancy_grid.
        resolution: edge of a cell, m.
        bounds: the lower left and the upper right corner, m; default: around everything, with a margin.

    Raises:
        CircuitError: if nothing is solid, and there are no bounds.
    """
    low, high = _bounds(outlines, circles, resolution) if bounds is None else bounds
    occupied = np.zeros(tuple(int(n) for n in np.ceil((high - low) / resolution - 1e-9))[::-1], dtype=bool)
    for outline in outlines:
        is_inside = partial(_in_polygon, outline)
        _fill(occupied, low, resolution, outline.min(axis=0), outline.max(axis=0), is_inside)
    for x, y, radius in circles:
        centre = np.array([x, y])
        is_inside = partial(_in_circle, centre, radius)
        _fill(occupied, low, resolution, centre - radius, centre + radius, is_inside)
    return occupied, low


def grid_of(occupied, free, low, resolution):
    """The Grid of cells that are occupied, free (where not occupied) or else unknown."""
    pixels = np.full(occupied.shape, UNKNOWN, dtype=np.uint8)
    pixels[free] = FREE
    pixels[occupied] = OCCUPIED
    return Grid(pixels, float(low[0]), float(low[1]), resolution)


def _bounds(outlines, circles, resolution):
    points = [*outlines]
    points += [np.array([[x - r, y - r], [x + r, y + r]]) for x, y, r in circles]
    if not points:
        raise CircuitError("nothing is solid at this height")
    everything = np.concatenate(points)
    low = np.floor((everything.min(axis=0) - MARGIN) / resolution + 1e-9) * resolution
    return low, everything.max(axis=0) + MARGIN


def _fill(occupied, origin, resolution, low, high, contains):
    """Mark the cells between low and high of which a shape contains a sample."""
    first = np.maximum(np.floor((low - origin) / resolution).astype(int), 0)
    last = np.minimum(np.ceil((high - origin) / resolution).astype(int) + 1, occupied.shape[::-1])
    if (last <= first).any():
        return
    x, y = (
        origin[i] + (np.arange(first[i] * _SAMPLES, last[i] * _SAMPLES) + 0.5) * (resolution / _SAMPLES)
        for i in (0, 1)
    )
    samples = contains(x[np.newaxis, :], y[:, np.newaxis])
    shape = (last[1] - first[1], _SAMPLES, last[0] - first[0], _SAMPLES)
    occupied[first[1] : last[1], first[0] : last[0]] |= samples.reshape(shape).any(axis=(1, 3))


def _in_polygon(outline, x, y):
    """Even-odd rule."""
    inside = np.zeros(np.broadcast(x, y).shape, dtype=bool)
    for (ax, ay), (bx, by) in zip(outline, np.roll(outline, -1, axis=0)):
        if ay != by:
            crosses = (ay > y) != (by > y)
            inside ^= crosses & (x < ax + (y - ay) * (bx - ax) / (by - ay))
    return inside


def _in_circle(centre, radius, x, y):
    return (x - centre[0]) ** 2 + (y - centre[1]) ** 2 < radius**2


def _reachable(occupied, low):
    column, row = (math.floor(-at / RESOLUTION) for at in low)
    if not (0 <= row < occupied.shape[0] and 0 <= column < occupied.shape[1]) or occupied[row, column]:
        raise CircuitError("the start (0.0, 0.0) is not on free ground")
    labels, _ = ndimage.label(~occupied)
    reachable = labels == labels[row, column]
    if reachable[[0, -1], :].any() or reachable[:, [0, -1]].any():
        raise CircuitError("the walls around the start (0.0, 0.0) have a gap; --extent maps an open world")
    return reachable
