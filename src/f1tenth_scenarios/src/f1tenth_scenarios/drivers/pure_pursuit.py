"""Pure pursuit of a line: steer onto the circle that leads to a point of it some way ahead.

R. C. Coulter, Implementation of the Pure Pursuit Path Tracking Algorithm, CMU-RI-TR-92-01, 1992.
"""

import dataclasses
import math

import numpy as np
from f1tenth_judge.places.raceline import Raceline

from workspace_support import maths

_SPACING = 0.05  # m, between the points that are looked through
_SMOOTHING = 1.0  # m, over which a line's curvature is averaged
_AHEAD = 2.0  # m, in which bends shorten the lookahead


@dataclasses.dataclass(frozen=True)
class PursuitOptions:
    """How the driver drives; the defaults are for the F1/10 car."""

    speed_max: float = 3.0  # m/s
    lookahead_min: float = 0.6  # m
    lookahead_time: float = 0.35  # s, adds this times the speed
    reaction_time: float = 0.2  # s, bends do not make the lookahead shorter than this times the speed
    lateral_acceleration: float = 4.0  # m/s^2, slower in bends than this allows
    braking: float = 4.0  # m/s^2, with which it slows down in time
    wheelbase: float = 0.33  # m
    steering_max: float = 0.4189  # rad


class PurePursuit:
    """Gives speed and steering for a pose."""

    def __init__(self, line: Raceline, options: PursuitOptions):
        self._options = options
        self._x, self._y, speed = _resampled(line)
        curvature = np.abs(_curvature(self._x, self._y))
        bends = np.sqrt(options.lateral_acceleration / np.maximum(curvature, 1e-6))
        self._speed = _slow_in_time(np.minimum(speed, bends), options.braking)
        self._longest = _longest_chords(curvature, line.room)

    def command(self, x: float, y: float, yaw: float, speed: float) -> tuple[float, float]:
        """Speed (m/s) and steering angle (rad) at a pose of base_footprint (m, rad) and a speed (m/s)."""
        options = self._options
        distances = maths.hypot(self._x - x, self._y - y)
        nearest = int(np.argmin(distances))
        reach = self._reach(nearest, float(distances[nearest]), max(speed, 0.0))
        ahead = (nearest + round(reach / _SPACING)) % len(self._x)
        curvature = _curvature_to(self._x[ahead] - x, self._y[ahead] - y, yaw)
        steering = maths.atan(options.wheelbase * curvature)
        allowed = math.sqrt(options.lateral_acceleration / max(abs(curvature), 1e-6))
        limit = options.steering_max
        return min(options.speed_max, float(self._speed[nearest]), allowed), max(-limit, min(limit, steering))

    def _reach(self, nearest: int, distance: float, speed: float) -> float:
        """How far ahead on the line the car aims, m."""
        options = self._options
        usual = options.lookahead_min + options.lookahead_time * speed
        in_bends = max(float(self._longest[nearest]), options.lookahead_min, options.reaction_time * speed)
        # A car beside the line comes back at a small angle, so as not to overshoot.
        return max(min(usual, in_bends), 3 * distance)


def _curvature_to(dx: float, dy: float, yaw: float) -> float:
    """Of the circle through the car, along its heading, and a point away from it, 1/m."""
    left = maths.cos(yaw) * dy - maths.sin(yaw) * dx
    return 2 * left / max(dx * dx + dy * dy, 1e-9)


def _resampled(line: Raceline):
    """The closed line at equal steps."""
    x, y, speed = (np.append(values, values[0]) for values in (line.x, line.y, line.speed))
    along = np.concatenate([[0.0], np.cumsum(maths.hypot(np.diff(x), np.diff(y)))])
    # So that the last step, back to the first point, is as long as all others.
    places = np.linspace(0.0, along[-1], max(round(along[-1] / _SPACING), 3), endpoint=False)
    fastest = np.where(np.isfinite(speed), speed, 1e3)
    return (np.interp(places, along, values) for values in (x, y, fastest))


def _curvature(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Of a closed line at equal steps, averaged, 1/m."""
    half = round(_SMOOTHING / 2 / _SPACING)
    ahead = maths.atan2(np.roll(y, -half) - y, np.roll(x, -half) - x)
    behind = np.roll(ahead, half)
    return ((ahead - behind + np.pi) % (2 * np.pi) - np.pi) / (half * _SPACING)


def _longest_chords(curvature: np.ndarray, room: float) -> np.ndarray:
    """How long a chord may be that begins at each point and leaves the line by no more than `room`, m."""
    count = round(_AHEAD / _SPACING)
    wrapped = np.concatenate([curvature, curvature[:count]])
    greatest = np.lib.stride_tricks.sliding_window_view(wrapped, count + 1).max(axis=1)
    return np.sqrt(8 * room / np.maximum(greatest[: len(curvature)], 1e-6))


def _slow_in_time(speed: np.ndarray, braking: float) -> np.ndarray:
    """Speeds (m/s) at equal steps of a closed line that can be kept with that braking (m/s^2)."""
    found = speed * speed
    gain = 2 * braking * _SPACING
    for _ in range(2):  # the second time around, the beginning is known
        for index in range(len(found) - 1, -1, -1):
            found[index] = min(found[index], found[(index + 1) % len(found)] + gain)
    return np.sqrt(found)
