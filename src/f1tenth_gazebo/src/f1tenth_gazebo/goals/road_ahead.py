"""Where a car starts in a world, and where its road leads from there."""

import math

import numpy as np
from f1tenth_judge.places.centreline_file import centreline_beside
from f1tenth_judge.places.circuit import Pose

import f1tenth_sim2d

_SPACING = 3.0  # m, between the places at which the direction is shown


def road_ahead(world):
    """Poses along the road in driving order; the first is the start. Only a start where no road is known.

    Args:
        world: path of a .world file or of the .yaml file of a map

    Raises:
        f1tenth_sim2d.LoadError: the centreline beside it cannot be read.
    """
    table = centreline_beside(world)
    if not table.is_file():
        return [Pose(0.0, 0.0, 0.0)]
    return _along_points(f1tenth_sim2d.read_centreline(table)[:, :2])


def _along_points(points):
    closed = np.vstack([points, points[:1]])
    steps = np.diff(closed, axis=0)
    at = np.concatenate([[0.0], np.cumsum(np.hypot(*steps.T))])
    chosen = [int(np.searchsorted(at, place)) for place in np.arange(0.0, at[-1], _SPACING)]
    return [
        Pose(float(points[i][0]), float(points[i][1]), math.atan2(steps[i][1], steps[i][0]))
        for i in chosen
        if i < len(points)
    ]
