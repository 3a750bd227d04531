"""Compares a map that a car has made with the true section of its world."""

from dataclasses import dataclass

import numpy as np
from f1tenth_judge.errors import MapError
from scipy.spatial import cKDTree

from f1tenth_gazebo.sampling import along, around

_NEAR = 0.05
"""m, plus a cell of the map: how far a wall cell may be from a wall"""
_BEFORE = (0.1, 0.2, 0.3)
"""m; a true wall counts if the map is free this far before it, with no other wall between: what no car sees,
nobody can map."""
_TOUCHING = 0.01
"""m"""


@dataclass(frozen=True)
class MapCheck:
    """How far a map and its world agree."""

    cells_near_walls: float
    """Share of the wall cells that are near to a true wall."""
    walls_near_cells: float
    """Share of the true walls that were in sight and near to a wall cell."""
    worst_cell: float
    """Distance of the wall cell that is farthest from a true wall, m."""
    near: float
    """What counts as near, m: a cell of the map and 0.05 m."""

    @property
    def passed(self):
        """Whether at least 97 % agree, both ways."""
        return min(self.cells_near_walls, self.walls_near_cells) >= 0.97


def check_map(grid, outlines, circles):
    """Compare a map with a section of its world.

    Args:
        grid: the map.
        outlines, circles: from World.section at the height of the lidar.

    Raises:
        MapError: there is nothing to compare; names neither the map nor the world.
    """
    cells = wall_cells(grid)
    walls, normals = true_walls(outlines, circles)
    in_sight = walls.data[are_in_sight(walls, normals, grid)]
    to_wall = walls.query(cells)[0]
    to_cell = cKDTree(cells).query(in_sight)[0]
    near = grid.resolution + _NEAR
    return MapCheck(
        float((to_wall <= near).mean()), float((to_cell <= near).mean()), float(to_wall.max()), near
    )


def wall_cells(grid):
    """The middles of the wall cells of a map, (n, 2) in m.

    Raises:
        MapError: there are none.
    """
    rows, columns = np.nonzero(grid.cells == 100)
    _expect_some(rows, "the map has no wall cell (black), must have some")
    return np.column_stack([columns + 0.5, rows + 0.5]) * grid.resolution + (grid.x, grid.y)


def true_walls(outlines, circles):
    """A tree of points on the walls of a section of a world, (n, 2) in m, and the directions away, (n, 2).

    Raises:
        MapError: there are none.
    """
    sides = [*map(along, outlines), *(around(*circle) for circle in circles)]
    _expect_some(sides, "the world has nothing at the height of the lidar, must have walls there")
    walls, normals = (np.concatenate(each) for each in zip(*sides))
    return cKDTree(walls), normals


def are_in_sight(walls, normals, grid):
    """Whether the road of a map lies before each of the true_walls, with no other wall between, (n,).

    Raises:
        MapError: it lies before none.
    """
    seen = np.zeros(walls.n, bool)
    for away in _BEFORE:
        to_nearest = walls.query(walls.data + away / 2 * normals)[0]
        seen |= (to_nearest > away / 2 - _TOUCHING) & _is_free(walls.data + away * normals, grid)
    _expect_some(
        walls.data[seen], "no wall of the world has a free cell (white) of the map before it, some must"
    )
    return seen


def _expect_some(values, problem):
    if not len(values):
        raise MapError(problem)


def _is_free(points, grid):
    columns, rows = np.floor((points - (grid.x, grid.y)) / grid.resolution).astype(int).T
    cells = grid.cells
    inside = (columns >= 0) & (rows >= 0) & (columns < cells.shape[1]) & (rows < cells.shape[0])
    return inside & (cells[np.where(inside, rows, 0), np.where(inside, columns, 0)] == 0)
