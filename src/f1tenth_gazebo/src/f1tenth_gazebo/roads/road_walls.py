"""The walls of a road: boxes along the edges of the ground that it covers."""

import math

import numpy as np
from f1tenth_judge.reference.car_limits import CAR_WIDTH
from shapely.geometry import MultiPoint, Polygon
from shapely.geometry.polygon import orient
from shapely.ops import unary_union

from f1tenth_gazebo.worlds.walls import THICKNESS, Wall, wall_chain

MATERIAL = "Gazebo/Grey"
_TOLERANCE = 0.01
"""How far a wall of straight pieces may be off the edge that it follows, m; never into the road."""
_ROUNDING = 0.1
"""Radius of corners of walls, m."""
_RAGGED_PIECES = (0.3, 1.0)
"""Length of the pieces of a ragged wall, m."""
_GAPS = (0.1, CAR_WIDTH - 0.03)
"""m; no car gets through."""


def road_ground(line, widths):
    """The Polygon that a road covers, with the infield as its hole; or None if the road meets itself."""
    aside = 0.5 * widths[:, np.newaxis] * line.normals()
    sections = np.stack([line.points - aside, line.points + aside], axis=1)
    pieces = np.concatenate([sections, np.roll(sections, -1, axis=0)], axis=1)
    # Where the bend is tighter than half of the width, the sections cross: hence the hull.
    ground = unary_union([MultiPoint(piece).convex_hull for piece in pieces])
    if ground.geom_type != "Polygon":
        return None
    holes = [hole for hole in ground.interiors if Polygon(hole).area > 0.01]
    return Polygon(ground.exterior, holes) if len(holes) == 1 else None


def road_walls(rng, ground, options):
    """((outer walls, inner walls), the Polygon between their middles), or None if they would touch."""
    # Out and back rounds corners that point at the road: boxes that meet at a sharp angle reach beyond it.
    away = _TOLERANCE + THICKNESS / 2.0
    middles = ground.buffer(away + _ROUNDING, join_style=2).buffer(-_ROUNDING, 4).simplify(_TOLERANCE / 2.0)
    if middles.geom_type != "Polygon":
        return None
    # So oriented that the road is on the left of either ring.
    middles = orient(middles)
    rings = [np.array(ring.coords)[:-1] for ring in (middles.exterior, *middles.interiors)]
    if len(rings) != 2:
        return None
    if options.raggedness > 0.0:
        rings = [_ragged(rng, ring, options.raggedness) for ring in rings]
    inside = Polygon(rings[0], [rings[1]])
    if not inside.is_valid:
        return None
    return [wall_chain([*map(tuple, ring)], MATERIAL, closed=True) for ring in rings], inside


def with_gaps(rng, walls, count):
    """The walls with gaps at random places."""
    for _ in range(count):
        width = rng.uniform(*_GAPS)
        long_enough = [i for i, wall in enumerate(walls) if wall.length > width + 0.1]
        if not long_enough:
            break
        i = int(rng.choice(long_enough))
        walls[i : i + 1] = _split(walls[i], rng.uniform(0.05, walls[i].length - width - 0.05), width)
    return walls


def corners_of(wall):
    """The outline of a wall's box, m: shape (4, 2)."""
    along = 0.5 * wall.length * np.array([math.cos(wall.yaw), math.sin(wall.yaw)])
    across = 0.5 * THICKNESS * np.array([-math.sin(wall.yaw), math.cos(wall.yaw)])
    middle = np.array([wall.x, wall.y])
    corners = [-along - across, along - across, along + across, -along + across]
    return middle + np.array(corners)


def _ragged(rng, ring, raggedness):
    """The ring with corners at uneven distances, each moved away from the road by up to raggedness."""
    edges = np.roll(ring, -1, axis=0) - ring
    places = []
    for point, edge in zip(ring, edges):
        length = math.hypot(*edge)
        at = 0.0
        while at < length:
            places.append(point + edge * (at / length))
            at += rng.uniform(*_RAGGED_PIECES)
    places = _apart(np.array(places), 0.5 * _RAGGED_PIECES[0])
    return places + rng.uniform(0.0, raggedness, (len(places), 1)) * _outward(places)


def _apart(places, least):
    kept = [places[0]]
    for place in places[1:]:
        if math.hypot(*(place - kept[-1])) >= least:
            kept.append(place)
    return np.array(kept if math.hypot(*(kept[-1] - kept[0])) >= least else kept[:-1])


def _outward(places):
    """Unit vectors to the right of a ring, shape (n, 2)."""
    along = np.roll(places, -1, axis=0) - np.roll(places, 1, axis=0)
    along /= np.hypot(*along.T)[:, np.newaxis]
    return np.column_stack([along[:, 1], -along[:, 0]])


def _split(wall, start, width):
    """What is left of a wall with a gap that begins `start` m from its own start."""
    return [_part(wall, 0.0, start), _part(wall, start + width, wall.length)]


def _part(wall, start, end):
    middle = 0.5 * (start + end) - 0.5 * wall.length
    x, y = wall.x + middle * math.cos(wall.yaw), wall.y + middle * math.sin(wall.yaw)
    return Wall(x, y, wall.yaw, end - start, wall.material)
