"""Pure pursuit of a line: steer onto the circle that leads to a point of it some way ahead.

R. C. Coulter, Implementation of the Pure Pursuit Path Tracking Algorithm, CMU-RI-TR-92-01, 1992.
"""

import dataclasses
import math

import numpy as np

from f1tenth_scenarios.scenario.raceline import Raceline

_SPACING = 0.05  # m, between the points that are looked through


@dataclasses.dataclass(frozen=True)
class PursuitOptions:
    """How the driver drives; the defaults are for the F1/10 car."""

    speed_max: float = 3.0  # m/s
    lookahead_min: float = 0.6  # m
    lookahead_time: float = 0.35  # s, adds this times the speed
    lateral_acceleration: float = 4.0  # m/s^2, slower in bends than this allows
    wheelbase: float = 0.33  # m
    steering_max: float = 0.4189  # rad


class PurePursuit:
    """Gives speed and steering for a pose."""

    def __init__(self, line: Raceline, options: PursuitOptions):
        self._options = options
        self._x, self._y, self._speed = _resampled(line)

    def command(self, x: float, y: float, yaw: float, speed: float) -> tuple[float, float]:
        """Speed (m/s) and steering angle (rad) at a pose of base_footprint (m, rad) and a speed (m/s)."""
        options = self._options
        nearest = int(np.argmin(np.hypot(self._x - x, self._y - y)))
        reach = options.lookahead_min + options.lookahead_time * max(speed, 0.0)
        ahead = (nearest + round(reach / _SPACING)) % len(self._x)
        curvature = _curvature_to(self._x[ahead] - x, self._y[ahead] - y, yaw)
        steering = math.atan(options.wheelbase * curvature)
        allowed = math.sqrt(options.lateral_acceleration / max(abs(curvature), 1e-6))
        limit = options.steering_max
        return min(options.speed_max, float(self._speed[ahead]), allowed), max(-limit, min(limit, steering))


def _curvature_to(dx: float, dy: float, yaw: float) -> float:
    """Of the circle through the car, along its heading, and a point away from it, 1/m."""
    left = math.cos(yaw) * dy - math.sin(yaw) * dx
    return 2 * left / max(dx * dx + dy * dy, 1e-9)


def _resampled(line: Raceline):
    """The closed line at equal steps."""
    x, y, speed = (np.append(values, values[0]) for values in (line.x, line.y, line.speed))
    along = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    places = np.arange(0.0, along[-1], _SPACING)
    fastest = np.where(np.isfinite(speed), speed, 1e3)
    return (np.interp(places, along, values) for values in (x, y, fastest))
