"""Pure pursuit as a class: the driver `pursuit` where a run knows no ROS 1."""

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from f1tenth_judge.places.raceline import read_raceline
from f1tenth_judge.planner import Command, Observation

_AHEAD, _AHEAD_TIME = 0.6, 0.35  # m, and s: how far ahead it aims, this and this times the speed
_SPEED = 3.0  # m/s
_LATERAL = 4.0  # m/s^2, slower in bends than this allows
_WHEELBASE, _STEERING_MAX = 0.33, 0.4189  # m, rad


class Pursuit:
    """Follows the line that it is told, at its speeds, from `start_at` on."""

    def reset(self, info: Mapping[str, Any]) -> None:
        """Read the line."""
        line = read_raceline(Path(info["line"]))
        self._points = np.column_stack([line.x, line.y])
        self._speeds = np.minimum(line.speed, float(info.get("speed_max", _SPEED)))
        self._start = float(info.get("start_at", 0.0))

    def plan(self, observation: Observation) -> Command:
        """Steer onto the arc that leads to the first point that is far enough ahead."""
        if observation.time < self._start:
            return Command(0.0, 0.0)
        x, y, yaw = observation.pose
        away = np.hypot(*(self._points - (x, y)).T)
        nearest = int(np.argmin(away))
        reach = max(_AHEAD + _AHEAD_TIME * observation.velocity[0], 3 * away[nearest])
        order = (nearest + np.arange(len(away))) % len(away)
        ahead, left = self._seen(order[int(np.argmax(away[order] > reach))], x, y, yaw)
        curvature = 2 * left / max(ahead * ahead + left * left, 1e-9)
        allowed = math.sqrt(_LATERAL / max(abs(curvature), 1e-6))
        steering = min(max(math.atan(_WHEELBASE * curvature), -_STEERING_MAX), _STEERING_MAX)
        return Command(min(float(self._speeds[nearest]), allowed), steering)

    def _seen(self, index: int, x: float, y: float, yaw: float) -> tuple[float, float]:
        """A point of the line as the car sees it, m ahead and to the left."""
        dx, dy = self._points[index] - (x, y)
        return dx * math.cos(yaw) + dy * math.sin(yaw), dy * math.cos(yaw) - dx * math.sin(yaw)
