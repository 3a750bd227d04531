"""What laps of a road without a raceline are compared with: along its middle, at the limit of friction."""

import math

import numpy as np

from f1tenth_judge.places.course import Course
from f1tenth_judge.reference.car_limits import GRAVITY, Limits
from f1tenth_judge.reference.track import resampled


def middle_lap(course: Course, limits: Limits) -> float:
    """Time of the fastest flying lap along the middle, s."""
    track = resampled(np.column_stack([course.x, course.y, course.right, course.left]))
    x, y = track[:, 0], track[:, 1]
    steps = np.hypot(np.roll(x, -1) - x, np.roll(y, -1) - y)
    curvature = np.minimum(_curvature(x, y), limits.max_curvature)
    grip = limits.friction * GRAVITY
    speed = np.minimum(limits.max_speed, np.sqrt(grip / np.maximum(curvature, 1e-6)))
    # Braking is speeding up backwards in time, but not by the motor. The second round joins end and begin.
    for _ in range(2):
        speed = _reached(speed, steps, curvature, limits, limits.switch_speed)
        backwards = _reached(speed[::-1], np.roll(steps[::-1], -1), curvature[::-1], limits, math.inf)
        speed = backwards[::-1]
    return float((2.0 * steps / (speed + np.roll(speed, -1))).sum())


def _curvature(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """1/m at each point of a closed line: by the turn between the steps that meet there."""
    way = np.column_stack([np.roll(x, -1) - x, np.roll(y, -1) - y])
    before = np.roll(way, 1, axis=0)
    turn = np.arctan2(before[:, 0] * way[:, 1] - before[:, 1] * way[:, 0], (before * way).sum(axis=1))
    return np.abs(turn) / ((np.hypot(*way.T) + np.hypot(*before.T)) / 2.0)


def _reached(
    allowed: np.ndarray, steps: np.ndarray, curvature: np.ndarray, limits: Limits, switch_speed: float
) -> np.ndarray:
    """Speeds that are reached from each point to the next, none above what is allowed."""
    speed, grip = allowed.copy(), limits.friction * GRAVITY
    for i in range(len(speed)):
        used = min(1.0, speed[i] ** 2 * curvature[i] / grip)
        along = min(limits.max_acceleration * min(1.0, switch_speed / speed[i]), grip)
        gained = 2.0 * along * math.sqrt(1.0 - used * used) * steps[i]
        following = (i + 1) % len(speed)
        speed[following] = min(speed[following], math.sqrt(speed[i] ** 2 + gained))
    return speed
