"""Aligns a world with a map of it, as trajectories are aligned with the truth to judge their shape alone.

The frame of a map begins where its first pose believes itself to be: a turn of the whole map about it says
nothing about the map's shape. Benchmarks of SLAM align poses with the truth for that: Sturm et al., A
Benchmark for the Evaluation of RGB-D SLAM Systems, IROS 2012, section IV.B.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from f1tenth_gazebo.maps.map_check import are_in_sight, true_walls, wall_cells
from f1tenth_gazebo.poses import composed

_REACH = 0.5
"""m, to the wall that a cell may belong to."""
_ROUNDS = 30
_SETTLED = 1e-6
"""m and rad"""


@dataclass(frozen=True)
class Alignment:
    """How a map lies in its world: a point p of the map is at R(turn) p + (x, y)."""

    x: float = 0.0
    """m"""
    y: float = 0.0
    """m"""
    turn: float = 0.0
    """rad"""

    def section_on_map(self, outlines, circles):
        """A section of the world as check_map takes it, moved onto the map."""
        return (
            [self._on_map(outline) for outline in outlines],
            [(*self._on_map(np.array([x, y])), radius) for x, y, radius in circles],
        )

    def _on_map(self, points):
        c, s = math.cos(self.turn), math.sin(self.turn)
        return (points - (self.x, self.y)) @ np.array([[c, -s], [s, c]])

    def after(self, x, y, turn):
        """The alignment of a map that is moved like this first."""
        return Alignment(*composed((self.x, self.y, self.turn), (x, y, turn)))


def aligned(grid, outlines, circles):
    """Return the Alignment that fits the wall cells to the walls, by the squares of their distances.

    Begins where the map says that it is (iterated closest points, along the normals of the walls), for maps
    that lie within a quarter of a metre of the truth. Arguments and errors as of check_map.
    """
    cells = wall_cells(grid)
    found = Alignment()
    for _ in range(_ROUNDS):
        walls, normals = true_walls(*found.section_on_map(outlines, circles))
        # The back of a wall may be nearer to its cells, and faces the other way.
        seen = are_in_sight(walls, normals, grid)
        step = _step_towards(walls.data[seen], normals[seen], cells)
        found = found.after(*step)
        if np.abs(step).max() < _SETTLED:
            break
    return found


def _step_towards(walls, normals, cells):
    """The small motion (x, y, turn) that brings cells nearer to their walls."""
    away, nearest = cKDTree(walls).query(cells, distance_upper_bound=_REACH)
    mine, hit = cells[away < _REACH], nearest[away < _REACH]
    off = ((mine - walls[hit]) * normals[hit]).sum(axis=1)
    swing = mine[:, 0] * normals[hit, 1] - mine[:, 1] * normals[hit, 0]
    x, y, turn = np.linalg.lstsq(np.column_stack([normals[hit], swing]), -off, rcond=None)[0]
    return float(x), float(y), float(turn)
