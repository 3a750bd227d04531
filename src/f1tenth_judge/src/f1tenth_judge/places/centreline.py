"""The centreline of a circuit: a polygon whose bends are short straight pieces."""

import math
from dataclasses import dataclass
from typing import Optional

from f1tenth_judge.errors import CircuitError

MAX_TURN = math.radians(12.0)
"""Largest turn from one piece of the centreline to the next, rad."""


@dataclass(frozen=True)
class Vertex:
    """A vertex of the centreline, where the road is `width` wide (m)."""

    x: float  # m
    y: float  # m
    width: float  # m
    bend: Optional[int]  # number of the corner that is rounded off here


def centreline(circuit):
    """Vertices of the closed centreline in driving order, from the end of the start straight on.

    Bends are tangential polygons: each piece touches the arc, so straights run into bends without a kink.

    Raises:
        CircuitError: if two bends need more room than there is between their corners.
    """
    _check_room_for_bends(circuit)
    corners = circuit.corners
    vertices = []
    for i, corner in enumerate(corners):
        vertices += _rounded(i, corners[i - 1], corner, corners[(i + 1) % len(corners)])
    return vertices


def _turn(before, corner, after):
    heading_in = math.atan2(corner.at.y - before.at.y, corner.at.x - before.at.x)
    heading_out = math.atan2(after.at.y - corner.at.y, after.at.x - corner.at.x)
    return heading_in, math.remainder(heading_out - heading_in, math.tau)


def _tangent_length(before, corner, after):
    _, turn = _turn(before, corner, after)
    return corner.radius * math.tan(abs(turn) / 2)


def _check_room_for_bends(circuit):
    corners = circuit.corners
    count = len(corners)
    lengths = [_tangent_length(corners[i - 1], corners[i], corners[(i + 1) % count]) for i in range(count)]
    for i in range(count):
        a, b = corners[i - 1], corners[i]
        distance = math.hypot(b.at.x - a.at.x, b.at.y - a.at.y)
        if lengths[i - 1] + lengths[i] > distance + 1e-9:
            raise CircuitError(
                f"{circuit.name}: corners[{(i - 1) % count}] and corners[{i}]: their bends need "
                f"{lengths[i - 1] + lengths[i]:.3f} m of the {distance:.3f} m between them"
            )


def _rounded(number, before, corner, after):
    heading, turn = _turn(before, corner, after)
    if turn == 0.0:
        return [Vertex(corner.at.x, corner.at.y, corner.width, bend=None)]
    pieces = math.ceil(abs(turn) / MAX_TURN - 1e-9)
    step = turn / pieces
    reach = corner.radius * math.tan(abs(turn) / 2)
    half = corner.radius * math.tan(abs(step) / 2)
    x = corner.at.x - (reach - half) * math.cos(heading)
    y = corner.at.y - (reach - half) * math.sin(heading)
    vertices = [Vertex(x, y, corner.width, bend=number)]
    for i in range(1, pieces):
        x += 2 * half * math.cos(heading + i * step)
        y += 2 * half * math.sin(heading + i * step)
        vertices.append(Vertex(x, y, corner.width, bend=number))
    return vertices
