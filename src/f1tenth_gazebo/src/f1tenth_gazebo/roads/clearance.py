"""How far a line is from what stands on either side of it."""

import numpy as np
from scipy.spatial import cKDTree

from f1tenth_gazebo.sampling import along


def clearance(points, walls, islands):
    """Distance from each point to the nearest of the walls and islands, m.

    Too large by up to half a step between samples.

    Args:
        points: shape (n, 2), m.
        walls: outlines, arrays of shape (k, 2), m.
        islands: (x, y, radius) in m.
    """
    to_wall = cKDTree(np.concatenate([along(outline)[0] for outline in walls])).query(points)[0]
    to_islands = [np.hypot(*(points - (x, y)).T) - radius for x, y, radius in islands]
    return np.min([to_wall, *to_islands], axis=0)
