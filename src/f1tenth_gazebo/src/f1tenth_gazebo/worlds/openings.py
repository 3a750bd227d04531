"""Doors and windows: which boxes are left of a wall around them."""

import math
from dataclasses import dataclass

from f1tenth_judge.errors import CircuitError
from f1tenth_judge.places.circuit import OPENING_HEIGHTS

from f1tenth_gazebo.worlds.walls import HEIGHT

_MARGIN = 0.2
"""Least length of wall beside an opening, m."""
_OVERLAP = 0.001
"""Overlap of the blocks below and above an opening with those beside it, m: rounding must leave no slit."""


@dataclass(frozen=True)
class Block:
    """A box of a wall: from `start` to `end` along it (m from its middle), from `bottom` to `top` (m)."""

    start: float
    end: float
    bottom: float
    top: float


def place_openings(circuit, walls):
    """Openings by the index of their wall: (place along the wall in m from its middle, Opening).

    Raises:
        CircuitError: if an opening finds no wall that is long enough.
    """
    placed: dict = {}
    for number, opening in enumerate(circuit.openings):
        index = min(range(len(walls)), key=lambda i: _distance(walls[i], opening))
        along, _ = _in_wall(walls[index], opening)
        if abs(along) + opening.width / 2 + _MARGIN > walls[index].length / 2:
            raise CircuitError(
                f"{circuit.name}: openings[{number}]: {opening.width} m do not fit into the wall nearest to "
                f"({opening.near.x}, {opening.near.y}), which is {walls[index].length:.2f} m long"
            )
        placed.setdefault(index, []).append((along, opening))
    return placed


def blocks(wall, openings):
    """What is left of a wall around its openings."""
    left = []
    start = -wall.length / 2
    for along, opening in sorted(openings, key=lambda placed: placed[0]):
        bottom, top = OPENING_HEIGHTS[opening.kind]
        begin, end = along - opening.width / 2, along + opening.width / 2
        left.append(Block(start, begin, 0.0, HEIGHT))
        if bottom > 0:
            left.append(Block(begin - _OVERLAP, end + _OVERLAP, 0.0, bottom))
        left.append(Block(begin - _OVERLAP, end + _OVERLAP, top, HEIGHT))
        start = end
    left.append(Block(start, wall.length / 2, 0.0, HEIGHT))
    return left


def _in_wall(wall, opening):
    dx, dy = opening.near.x - wall.x, opening.near.y - wall.y
    along = dx * math.cos(wall.yaw) + dy * math.sin(wall.yaw)
    across = -dx * math.sin(wall.yaw) + dy * math.cos(wall.yaw)
    return along, across


def _distance(wall, opening):
    along, across = _in_wall(wall, opening)
    return math.hypot(max(0.0, abs(along) - wall.length / 2), across)
