"""Walls as Gazebo's Building Editor has them: straight boxes, one link each."""

import math
from dataclasses import dataclass

from f1tenth_judge.errors import CircuitError

THICKNESS = 0.15
"""m"""
HEIGHT = 2.5
"""m"""


@dataclass(frozen=True)
class Wall:
    """A straight wall that stands on the ground. Its centre is (x, y), its length runs along yaw."""

    x: float  # m
    y: float  # m
    yaw: float  # rad
    length: float  # m
    material: str


def road_walls(circuit, vertices):
    """Both walls of the road, their faces half the road's width from the centreline.

    Raises:
        CircuitError: if a bend is too tight for its road: the inner wall would run backwards.
    """
    walls = []
    for side, material in ((1, circuit.left_material), (-1, circuit.right_material)):
        points = _offset(vertices, side)
        _check_direction(circuit, vertices, points)
        walls += wall_chain(points, material, closed=True)
    return walls


def wall_chain(points, material, closed):
    """Walls along a polyline. At each vertex they are lengthened until their outer edges meet (a mitre)."""
    count = len(points)
    starts = range(-1, count - 1) if closed else range(count - 1)
    return [_wall(points, i, material, closed) for i in starts]


def _offset(vertices, side):
    """The line in the middle of the wall on the left (1) or right (-1) side."""
    points = []
    count = len(vertices)
    for i, vertex in enumerate(vertices):
        before, after = vertices[i - 1], vertices[(i + 1) % count]
        heading_in = math.atan2(vertex.y - before.y, vertex.x - before.x)
        turn = math.remainder(math.atan2(after.y - vertex.y, after.x - vertex.x) - heading_in, math.tau)
        distance = side * (vertex.width + THICKNESS) / 2 / math.cos(turn / 2)
        normal = heading_in + turn / 2 + math.pi / 2
        points.append((vertex.x + distance * math.cos(normal), vertex.y + distance * math.sin(normal)))
    return points


def _check_direction(circuit, vertices, points):
    for i, vertex in enumerate(vertices):
        along = (vertex.x - vertices[i - 1].x, vertex.y - vertices[i - 1].y)
        wall = (points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1])
        if along[0] * wall[0] + along[1] * wall[1] <= 0:
            raise CircuitError(
                f"{circuit.name}: the bend near ({vertex.x:.1f}, {vertex.y:.1f}) is too tight for a road "
                f"{vertex.width} m wide: its inner wall has no room"
            )


def _wall(points, i, material, closed):
    count = len(points)
    a, b = points[i], points[i + 1]
    yaw = math.atan2(b[1] - a[1], b[0] - a[0])
    start = _mitre(points[i - 1], a, b) if closed or i > 0 else THICKNESS / 2
    end = _mitre(a, b, points[(i + 2) % count]) if closed or i + 2 < count else THICKNESS / 2
    length = math.hypot(b[0] - a[0], b[1] - a[1]) + start + end
    middle = length / 2 - start
    return Wall(a[0] + middle * math.cos(yaw), a[1] + middle * math.sin(yaw), yaw, length, material)


def _mitre(a, b, c):
    turn = math.remainder(
        math.atan2(c[1] - b[1], c[0] - b[0]) - math.atan2(b[1] - a[1], b[0] - a[0]), math.tau
    )
    return THICKNESS / 2 * math.tan(abs(turn) / 2)
