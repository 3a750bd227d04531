"""Whether what a car has seen would fit another place as well."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from f1tenth_gazebo.maps.map_file import Grid
from f1tenth_gazebo.poses import Pose
from scipy.ndimage import distance_transform_edt, map_coordinates
from scipy.optimize import minimize

from f1tenth_studies.drives.rms import rms

_FAR = 0.3  # m from a wall; what is farther away counts as this


@dataclass(frozen=True)
class View:
    """What was seen at a place."""

    points: np.ndarray  # (n, 2), m, in the frame of the car
    place: Pose


def is_alike(grid: Grid, views: Sequence[View], here: Pose, there: Pose) -> bool:
    """Whether all that was seen lies on the walls of a map, and would as well if the whole way lay elsewhere.

    A map is right to half a cell: each view may be that much farther from the walls (RMS).

    Args:
        grid: the map
        views: on the way, at their true places
        here: a place on the way
        there: where this would be, to about half a metre; the best place around it counts
    """
    away = _distances(grid)
    points = [_at(view.place, view.points) for view in views]
    on_map = np.array([rms(away(each)) for each in points])

    def elsewhere(moved: np.ndarray) -> np.ndarray:
        motion = *moved[:2], there[2] - here[2] + moved[2]
        return np.array([rms(away(_at(motion, each - here[:2]))) for each in points])

    start = np.array([*there[:2], 0.0])
    corners = np.vstack([start, start + np.diag([0.1, 0.1, 0.03])])  # m, m, rad
    options = {"initial_simplex": corners, "fatol": 1e-5}
    best = minimize(lambda moved: rms(elsewhere(moved)), start, method="Nelder-Mead", options=options)
    tolerance = grid.resolution / 2
    return bool(np.all(on_map <= 2 * tolerance) and np.all(elsewhere(best.x) <= on_map + tolerance))


def _at(pose: Pose, points: np.ndarray) -> np.ndarray:
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return points @ np.array([[c, s], [-s, c]]) + pose[:2]


def _distances(grid: Grid) -> Callable[[np.ndarray], np.ndarray]:
    """A function of points (n, 2) in m: how far each is from where a wall begins, m."""
    wall = grid.cells == 100
    cells = np.where(wall, 0.5 - distance_transform_edt(wall), distance_transform_edt(~wall) - 0.5)

    def away(points: np.ndarray) -> np.ndarray:
        columns, rows = ((points - (grid.x, grid.y)) / grid.resolution - 0.5).T
        distances = (
            map_coordinates(cells, [rows, columns], order=1, cval=_FAR / grid.resolution) * grid.resolution
        )
        return np.minimum(np.abs(distances), _FAR)

    return away
