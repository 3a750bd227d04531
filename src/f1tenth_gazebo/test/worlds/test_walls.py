"""Walls must close the road, be as far apart as the circuit says, and leave the openings they should."""

import math

import pytest
from f1tenth_gazebo.worlds.openings import blocks, place_openings
from f1tenth_gazebo.worlds.walls import HEIGHT, THICKNESS, Wall, road_walls
from f1tenth_judge.errors import CircuitError
from f1tenth_judge.places.centreline import centreline
from f1tenth_judge.places.circuit import Circuit, Corner, Opening, OpeningKind, Point
from shapely.geometry import Point as ShapelyPoint
from shapely.geometry import Polygon
from shapely.ops import unary_union


def square(width=2.0, radius=2.0, **keywords):
    corners = [(5, 0), (5, 10), (-5, 10), (-5, 0)]
    return Circuit(tuple(Corner(Point(*at), radius, width) for at in corners), name="square", **keywords)


def opening(kind, x, y, width):
    return Opening(OpeningKind(kind), Point(x, y), width)


def outline(wall):
    along = (math.cos(wall.yaw) * wall.length / 2, math.sin(wall.yaw) * wall.length / 2)
    across = (-math.sin(wall.yaw) * THICKNESS / 2, math.cos(wall.yaw) * THICKNESS / 2)
    signs = ((1, 1), (-1, 1), (-1, -1), (1, -1))
    return Polygon(
        [(wall.x + a * along[0] + b * across[0], wall.y + a * along[1] + b * across[1]) for a, b in signs]
    )


def test_walls_are_two_closed_rings_with_the_road_between():
    circuit = square()
    solid = unary_union([outline(wall) for wall in road_walls(circuit, centreline(circuit))])
    outer, inner = sorted(solid.geoms, key=lambda ring: -ring.area)
    assert [len(outer.interiors), len(inner.interiors)] == [1, 1]
    assert Polygon(outer.interiors[0]).contains(Polygon(inner.exterior))


@pytest.mark.parametrize("width", [1.2, 1.7, 2.5])
def test_faces_are_as_far_apart_as_the_road_is_wide(width):
    circuit = square(width)
    vertices = centreline(circuit)
    solid = unary_union([outline(wall) for wall in road_walls(circuit, vertices)])
    middles = [((a.x + b.x) / 2, (a.y + b.y) / 2) for a, b in zip(vertices, vertices[1:])]
    distances = [solid.distance(ShapelyPoint(middle)) for middle in middles]
    assert min(distances) == pytest.approx(width / 2, abs=1e-6)
    assert max(distances) == pytest.approx(width / 2, abs=1e-3)


def test_a_bend_too_tight_for_its_road_is_refused():
    circuit = square(width=2.5, radius=1.3)
    with pytest.raises(CircuitError, match=r"square: the bend near .* is too tight for a road 2.5 m wide"):
        road_walls(circuit, centreline(circuit))


def test_a_window_leaves_wall_below_above_and_beside_it():
    parts = blocks(Wall(0, 0, 0, 6, ""), [(1.0, opening("window", 1, 0, 2.0))])
    assert [(p.start, p.end, p.bottom, p.top) for p in parts] == [
        (-3.0, 0.0, 0.0, HEIGHT),
        (-0.001, 2.001, 0.0, 1.0),
        (-0.001, 2.001, 2.2, HEIGHT),
        (2.0, 3.0, 0.0, HEIGHT),
    ]


def test_a_door_leaves_nothing_at_the_height_of_the_car():
    parts = blocks(Wall(0, 0, 0, 6, ""), [(-1.0, opening("door", -1, 0, 0.9))])
    assert [(p.start, p.end) for p in parts if p.bottom < 0.2] == [(-3.0, -1.45), (-0.55, 3.0)]


def test_an_opening_goes_into_the_nearest_wall_facing_either_way():
    walls = [Wall(0, 1, math.pi, 6, ""), Wall(0, -1, 0, 6, "")]
    circuit = square(openings=(opening("door", 1.0, 0.8, 0.9), opening("window", 1.0, -0.8, 0.9)))
    placed = place_openings(circuit, walls)
    assert {index: round(places[0][0], 9) for index, places in placed.items()} == {0: -1.0, 1: 1.0}


def test_an_opening_that_does_not_fit_is_refused():
    circuit = square(openings=(opening("door", 2.5, -1, 0.9),))
    with pytest.raises(CircuitError, match=r"openings\[0\]: 0.9 m do not fit into .* is 6.00 m long"):
        place_openings(circuit, [Wall(0, -1, 0, 6, "")])
