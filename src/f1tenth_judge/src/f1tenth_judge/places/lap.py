"""The centreline by the distance driven."""

import bisect
import math

from f1tenth_judge.places.circuit import Pose

MIN_STRAIGHT = 0.8
"""The least length of a straight between two bends, m."""


class Lap:
    """One lap along the centreline, from the start line to the start line."""

    def __init__(self, vertices):
        """Take the vertices of `centreline()`, which begin at the end of the start straight."""
        self._points = [(0.0, 0.0)] + [(v.x, v.y) for v in vertices] + [(0.0, 0.0)]
        self._distances = [0.0]
        for (ax, ay), (bx, by) in zip(self._points, self._points[1:]):
            self._distances.append(self._distances[-1] + math.hypot(bx - ax, by - ay))
        self._bends = _bends(vertices, self._distances[1:])

    @property
    def length(self):
        """Length of the lap, m."""
        return self._distances[-1]

    def pose(self, distance):
        """Pose on the centreline after this distance, m, in driving direction."""
        distance %= self.length
        i = bisect.bisect_right(self._distances, distance) - 1
        (ax, ay), (bx, by) = self._points[i], self._points[i + 1]
        part = (distance - self._distances[i]) / (self._distances[i + 1] - self._distances[i])
        return Pose(ax + part * (bx - ax), ay + part * (by - ay), math.atan2(by - ay, bx - ax))

    def straightness(self, distance):
        """How far the nearest bend is, m; in a bend, minus the distance to its nearer end."""
        return min(max(begin - distance, distance - end) for begin, end in self._bends)


def _bends(vertices, distances):
    """Begin and end of each bend, m from the start line; without a straight between, two count as one."""
    bends: list = []
    number = None
    for vertex, distance in zip(vertices, distances):
        if vertex.bend is None:
            continue
        if bends and (vertex.bend == number or distance - bends[-1][1] < MIN_STRAIGHT):
            bends[-1][1] = distance
        else:
            bends.append([distance, distance])
        number = vertex.bend
    return bends
