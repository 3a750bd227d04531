"""Goals for one lap: poses on the centreline, in driving order."""

import math
from dataclasses import dataclass

SPACING = 6.5
"""Distance from one goal to the next that is aimed at, m."""
MAX_SHIFT = 0.75
"""How far a goal may be moved along the lap to lie on a straight, m."""
PAST_START = 1.0
"""Distance of the last goal behind the start line, m."""
_STEP = 0.05


@dataclass(frozen=True)
class Goal:
    """A pose in the map frame."""

    x: float  # m
    y: float  # m
    yaw: float  # rad


class Lap:
    """The centreline by the distance driven from the start line."""

    def __init__(self, vertices):
        """Take the vertices of `centreline()`, which begin at the end of the start straight."""
        self._points = [(0.0, 0.0)] + [(v.x, v.y) for v in vertices] + [(0.0, 0.0)]
        self._in_bend = [False] + [v.in_bend for v in vertices] + [False]
        self._distances = [0.0]
        for (ax, ay), (bx, by) in zip(self._points, self._points[1:]):
            self._distances.append(self._distances[-1] + math.hypot(bx - ax, by - ay))

    @property
    def length(self):
        """Length of the lap, m."""
        return self._distances[-1]

    def pose(self, distance):
        """Pose on the centreline after this distance, m, in driving direction."""
        distance %= self.length
        i = max(k for k, d in enumerate(self._distances[:-1]) if d <= distance)
        (ax, ay), (bx, by) = self._points[i], self._points[i + 1]
        part = (distance - self._distances[i]) / (self._distances[i + 1] - self._distances[i])
        return Goal(ax + part * (bx - ax), ay + part * (by - ay), math.atan2(by - ay, bx - ax))

    def straightness(self, distance):
        """How far the nearest bend is, m; in a bend, minus the distance to its nearer end."""
        return min(max(begin - distance, distance - end) for begin, end in self._bends())

    def _bends(self):
        """Begin and end of each bend, m from the start line."""
        bends = []
        for i in range(1, len(self._points)):
            if self._in_bend[i] and not self._in_bend[i - 1]:
                bends.append([self._distances[i], self._distances[i]])
            elif self._in_bend[i]:
                bends[-1][1] = self._distances[i]
        return bends


def lap_goals(vertices):
    """Goals of one lap, the last of them a little behind the start line."""
    lap = Lap(vertices)
    count = round((lap.length + PAST_START) / SPACING)
    spacing = (lap.length + PAST_START) / count
    goals = [lap.pose(_best_place(lap, i * spacing)) for i in range(1, count)]
    return [*goals, lap.pose(PAST_START)]


def _best_place(lap, distance):
    """The straightest place near a distance; a metre from the bend is straight enough."""
    steps = round(MAX_SHIFT / _STEP)
    shifts = sorted((i * _STEP for i in range(-steps, steps + 1)), key=abs)
    return max((distance + shift for shift in shifts), key=lambda place: min(1.0, lap.straightness(place)))


def goals_text(goals, circuit_name):
    """A goals file."""
    lines = ["frame_id: map", f"# One lap of {circuit_name}: x (m) y (m) yaw (rad)"]
    lines += [f"{goal.x:.3f} {goal.y:.3f} {goal.yaw:.4f}" for goal in goals]
    return "\n".join(lines) + "\n"
