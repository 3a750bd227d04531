"""Compares a map that a car has made with the true section of its world."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

NEAR = 0.10
"""m"""
_STEP = 0.02
"""Of the samples along a wall, m."""
_BEFORE = (0.1, 0.2, 0.3)
"""A true wall counts if the map is free so far before it, m: nobody can map what no car can see."""


@dataclass(frozen=True)
class MapCheck:
    """How far a map and its world agree."""

    cells_near_walls: float
    """Share of the wall cells within NEAR of a true wall."""
    walls_near_cells: float
    """Share of the true walls that were in sight within NEAR of a wall cell."""
    worst_cell: float
    """Distance of the wall cell that is farthest from a true wall, m."""

    @property
    def passed(self):
        """Whether at least 97 % agree, both ways."""
        return min(self.cells_near_walls, self.walls_near_cells) >= 0.97


def check_map(grid, outlines, circles):
    """Compare a map with a section of its world.

    Args:
        grid: the map.
        outlines, circles: from World.section at the height of the lidar.
    """
    cells = _centres(grid)
    sides = [*map(along, outlines), *(_around(*circle) for circle in circles)]
    walls, normals = (np.concatenate(each) for each in zip(*sides))
    seen = np.zeros(len(walls), bool)
    for away in _BEFORE:
        seen |= _is_free(walls + away * normals, grid)
    to_wall = cKDTree(walls).query(cells)[0]
    to_cell = cKDTree(cells).query(walls[seen])[0]
    return MapCheck(float((to_wall <= NEAR).mean()), float((to_cell <= NEAR).mean()), float(to_wall.max()))


def _is_free(points, grid):
    columns, rows = np.floor((points - (grid.x, grid.y)) / grid.resolution).astype(int).T
    pixels = grid.pixels
    inside = (columns >= 0) & (rows >= 0) & (columns < pixels.shape[1]) & (rows < pixels.shape[0])
    return inside & (pixels[np.where(inside, rows, 0), np.where(inside, columns, 0)] == 254)


def _centres(grid):
    """Of the wall cells, m."""
    rows, columns = np.nonzero(grid.pixels == 0)
    return np.column_stack([columns + 0.5, rows + 0.5]) * grid.resolution + (grid.x, grid.y)


def along(outline):
    """Samples along a closed outline that has its solid on the left, and the directions away from that."""
    samples, normals = [], []
    for a, b in zip(outline, np.roll(outline, -1, axis=0)):
        length = np.linalg.norm(b - a)
        count = max(1, int(length / _STEP))
        samples.append(a + np.linspace(0.0, 1.0, count, endpoint=False)[:, np.newaxis] * (b - a))
        normals.append(np.tile(np.array([b[1] - a[1], a[0] - b[0]]) / length, (count, 1)))
    return np.concatenate(samples), np.concatenate(normals)


def _around(x, y, radius):
    angles = np.linspace(0.0, 2.0 * np.pi, max(8, int(2.0 * np.pi * radius / _STEP)))
    normals = np.column_stack([np.cos(angles), np.sin(angles)])
    return np.array([x, y]) + radius * normals, normals
