"""How far a line is from what stands on either side of it."""

import numpy as np
from scipy.spatial import cKDTree

_STEP = 0.02
"""Between samples of an outline, m."""


def clearance(points, walls, islands):
    """Distance from each point to the nearest of the walls and islands, m.

    Up to half a step between samples too much.

    Args:
        points: shape (n, 2), m.
        walls: outlines, arrays of shape (k, 2), m.
        islands: (x, y, radius) in m.
    """
    to_wall = cKDTree(np.concatenate([along(outline) for outline in walls])).query(points)[0]
    to_islands = [np.hypot(*(points - (x, y)).T) - radius for x, y, radius in islands]
    return np.min([to_wall, *to_islands], axis=0)


def along(outline):
    """Samples along a closed outline."""
    samples = []
    for a, b in zip(outline, np.roll(outline, -1, axis=0)):
        count = max(1, int(np.hypot(*(b - a)) / _STEP))
        samples.append(a + np.linspace(0.0, 1.0, count, endpoint=False)[:, np.newaxis] * (b - a))
    return np.concatenate(samples)
