"""A driver without a map: of the arcs it could drive, it takes those with the longest way ahead.

Not the gap follower of f1tenth_sim2d/examples: this one must get round every circuit untouched, and so
simulates 41 arcs. That one steers into the widest gap, as most do, at a quarter of the cost,
because the benchmarks need a driver that is well known and costs little beside the simulator.
"""

import math
from dataclasses import dataclass

import numpy as np

from workspace_support import maths


@dataclass(frozen=True)
class GapFollowerOptions:
    """What the driver may do, and what it drives."""

    speed: float = 1.5
    """On a straight, m/s."""
    max_lateral_acceleration: float = 0.6
    """In bends, m/s^2."""
    stopping_acceleration: float = 2.0
    """Braking that must be able to stop the car within the way ahead, m/s^2."""
    max_steering_angle: float = 0.4
    """rad, to either side."""
    wheelbase: float = 0.33
    """m"""
    lidar_x: float = 0.275
    """Of the lidar ahead of the rear axle, m."""
    front_x: float = 0.43
    """Of the bumper ahead of the rear axle, m."""
    clearances: tuple = (0.22, 0.32, 0.45, 0.6, 0.8)
    """Distances from the car's middle that ought to be free, m; the least is half its width and some."""
    sight: float = 4.5
    """Way ahead that counts, m."""

    def __post_init__(self):
        """Raise ValueError for a value that makes no sense."""
        for name, value in vars(self).items():
            if not min(np.atleast_1d(value), default=0.0) > 0.0:
                raise ValueError(f"{name}: found {value}, must be above 0")


class GapFollower:
    """Answers scans with commands; keeps nothing from one scan to the next."""

    ARCS = 41
    BEAMS = 270
    """About that many beams are looked at: one per degree finds whatever stands on a road."""
    HALF_WIDTH = 0.14
    """Half width of the zone before the bumper in which something stops the car, m: less than half of the
    car's 0.31 m, because the drives were tuned with it."""
    DECISIVENESS = 12
    """How much more better ways count than worse ones in the mean of the steering angles."""

    def __init__(self, angle_min, angle_increment, beam_count, options=None):
        """Take the geometry of the scans: rad, 0 is ahead, left is positive."""
        self._options = options = options or GapFollowerOptions()
        self._step = max(1, beam_count // self.BEAMS)
        angles = angle_min + angle_increment * np.arange(0, beam_count, self._step)
        self._directions = np.column_stack([maths.cos(angles), maths.sin(angles)])
        self._steering = np.linspace(-options.max_steering_angle, options.max_steering_angle, self.ARCS)
        self._curvatures = maths.tan(self._steering) / options.wheelbase

    def command(self, ranges):
        """(speed, steering angle) for a scan's ranges.

        Args:
            ranges: array of shape (beam_count,), m; inf where nothing is hit.

        Returns:
            m/s and rad, left is positive.
        """
        points = self._points(np.asarray(ranges))
        ways = self._ways(points)
        weights = maths.pow(ways.mean(axis=1), self.DECISIVENESS)
        if not weights.any() or self._is_before_bumper(points):
            return 0.0, 0.0
        steering = float(np.average(self._steering, weights=weights))
        way = float(np.interp(steering, self._steering, ways[:, 0]))
        return self._speed(steering, way), steering

    def _points(self, ranges):
        """What is hit, from below the rear axle, m: shape (n, 2)."""
        ranges = ranges[:: self._step].astype(float)
        hit = np.isfinite(ranges)
        points = ranges[hit, np.newaxis] * self._directions[hit]
        points[:, 0] += self._options.lidar_x
        return points

    def _ways(self, points):
        """How far the bumper can go on each arc with each clearance, m: shape (ARCS, clearances)."""
        options = self._options
        aside, along = self._beside_arcs(points)
        ahead = along > options.front_x
        ways = []
        for clearance in options.clearances:
            blocked = ahead & (np.abs(aside) < clearance)
            ways.append(
                np.where(blocked, along - options.front_x, options.sight).min(axis=1, initial=options.sight)
            )
        return np.column_stack(ways)

    def _beside_arcs(self, points):
        """Distance of each point from each arc, and its place along the arc, m: both (ARCS, n)."""
        x, y = points[:, 0], points[:, 1]
        k = self._curvatures[:, np.newaxis]
        # Signed distance from the circle through the origin with curvature k, without dividing by k.
        square = k * (x * x + y * y) - 2.0 * y
        aside = square / (1.0 + np.sqrt(1.0 + k * square))
        angle = maths.atan2(k * x, 1.0 - k * y)
        along = np.where(np.abs(k) < 1e-6, x, angle / np.where(np.abs(k) < 1e-6, 1.0, k))
        return aside, along

    def _is_before_bumper(self, points):
        """Whether something is so near that it counts as beside the car on every arc."""
        ahead = (points[:, 0] > self._options.lidar_x) & (points[:, 0] <= self._options.front_x)
        return bool((ahead & (np.abs(points[:, 1]) < self.HALF_WIDTH)).any())

    def _speed(self, steering, way):
        options = self._options
        curvature = abs(maths.tan(steering)) / options.wheelbase
        bend = math.sqrt(options.max_lateral_acceleration / max(curvature, 1e-6))
        stop = math.sqrt(2.0 * options.stopping_acceleration * max(way, 0.0))
        return min(options.speed, bend, stop)
