"""`track` of f1tenth_gym 1.0: the lines of a map as arrays."""

from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np

from f1tenth_sim2d.environments.place import Place


@dataclass(frozen=True)
class Line:
    """A closed line as arrays of shape (n,), with the names of f1tenth_gym.

    Attributes:
        ss: distance along the line, m.
        xs, ys: m.
        yaws: rad.
        ks: curvature, 1/m.
        vxs: speed, m/s.
        axs: acceleration, m/s^2.
    """

    ss: np.ndarray
    xs: np.ndarray
    ys: np.ndarray
    yaws: np.ndarray
    ks: np.ndarray
    vxs: np.ndarray
    axs: np.ndarray

    @property
    def n(self) -> int:
        """How many points it has."""
        return len(self.xs)

    def render_waypoints(self, _renderer):
        """For add_render_callback, which calls nothing."""


@dataclass(frozen=True)
class Track:
    """The middle of the road, at 1 m/s, and the raceline, which is the same without X_raceline.csv."""

    centerline: Optional[Line]
    raceline: Optional[Line]


def track_of(place: Place, raceline: Path) -> Track:
    """Read the lines of a place.

    Raises:
        ValueError: a raceline that is no table of s, x, y, psi, kappa, vx, ax.
    """
    centre = None if place.centreline is None else _middle(*place.centreline[:, :2].T)
    return Track(centre, _read(raceline) if raceline.is_file() else centre)


def _middle(x, y):
    to_next = np.hypot(np.roll(x, -1) - x, np.roll(y, -1) - y)
    yaws = np.arctan2(np.roll(y, -1) - np.roll(y, 1), np.roll(x, -1) - np.roll(x, 1))
    turns = (np.roll(yaws, -1) - np.roll(yaws, 1) + np.pi) % (2 * np.pi) - np.pi
    distances = np.concatenate([[0.0], np.cumsum(to_next[:-1])])
    curvature = turns / (to_next + np.roll(to_next, 1))
    return Line(distances, x, y, yaws, curvature, np.ones_like(x), np.zeros_like(x))


def _read(path):
    try:
        return Line(*np.loadtxt(path, delimiter=";", ndmin=2).T)
    except (ValueError, TypeError) as error:
        columns = "s_m; x_m; y_m; psi_rad; kappa_radpm; vx_mps; ax_mps2"
        raise ValueError(f"{path}: found no table of numbers, allowed are lines of {columns}") from error
