"""Every shipped world: exact scans from random places against shapely and a reader of its own."""

import math
import sys
from pathlib import Path

import numpy as np
import pytest
from sdf_slices import slice_world
from shapely.geometry import LineString, Point
from shapely.ops import unary_union

import f1tenth_sim2d

PACKAGE = Path(__file__).parents[2]
sys.path.insert(0, str(PACKAGE / "bench"))

from sim2d_bench.cars import F1TENTH, bare_lidar  # noqa: E402
from sim2d_bench.places import REPOSITORY  # noqa: E402

SHIPPED = REPOSITORY / "src" / "f1tenth_gazebo"
WORLDS = sorted((SHIPPED / "worlds").glob("*.world"))
LIDAR_HEIGHT = 0.16  # m
PLACES = 12
EVERY = 7  # beams
LARGEST_ERROR = 0.001  # m
ROOM = 0.05  # m, from a place to the next wall


class Scenery:
    """The section of a world file at the height of the lidar, as exact geometry."""

    def __init__(self, path):
        polygons, self.circles = slice_world(path, SHIPPED / "models", LIDAR_HEIGHT)
        self.walls = unary_union(polygons)

    def is_free(self, x, y):
        beside_circles = all(math.hypot(x - cx, y - cy) > radius + ROOM for cx, cy, radius in self.circles)
        return beside_circles and self.walls.distance(Point(x, y)) > ROOM

    def range(self, x, y, angle):
        end = (x + F1TENTH.range_max * math.cos(angle), y + F1TENTH.range_max * math.sin(angle))
        hit = LineString([(x, y), end]).intersection(self.walls)
        nearest = math.inf if hit.is_empty else hit.distance(Point(x, y))
        return min([nearest, *(self._to_circle(x, y, angle, *circle) for circle in self.circles)])

    @staticmethod
    def _to_circle(x, y, angle, centre_x, centre_y, radius):
        along = (centre_x - x) * math.cos(angle) + (centre_y - y) * math.sin(angle)
        aside = (centre_y - y) * math.cos(angle) - (centre_x - x) * math.sin(angle)
        if along < 0.0 or abs(aside) > radius:
            return math.inf
        return along - math.sqrt(radius**2 - aside**2)


def places(scenery, random):
    """Random free poses in the bounds of the world's walls, some of them right beside a wall."""
    low_x, low_y, high_x, high_y = scenery.walls.bounds
    found = []
    while len(found) < PLACES:
        x, y = random.uniform(low_x - 1, high_x + 1), random.uniform(low_y - 1, high_y + 1)
        if scenery.is_free(x, y):
            found.append((x, y, random.uniform(-math.pi, math.pi)))
    return found


def grazes(scenery, x, y, angle):
    """Whether a beam passes so near to a corner or along a face that the last bits decide what it hits."""
    before, after = (scenery.range(x, y, angle + turn) for turn in (-1e-7, 1e-7))
    return abs(before - after) > 1e-4 if math.isfinite(before + after) else before != after


@pytest.mark.parametrize("path", WORLDS, ids=[path.stem for path in WORLDS])
def test_scan_is_exact_from_random_places(path):
    world = f1tenth_sim2d.load_world(str(path))
    scenery = Scenery(path)
    simulation = f1tenth_sim2d.Simulation(world)
    simulation.add_car(bare_lidar(F1TENTH), None, 1000.0, 1000.0)
    angles = np.linspace(-F1TENTH.max_angle, F1TENTH.max_angle, F1TENTH.samples)
    seen = 0
    for x, y, yaw in places(scenery, np.random.default_rng(11)):
        simulation.place_car(0, x, y, yaw)
        ranges = simulation.scan(0, exact=True)
        for beam in range(0, F1TENTH.samples, EVERY):
            expected = scenery.range(x, y, yaw + angles[beam])
            if grazes(scenery, x, y, yaw + angles[beam]):
                continue
            assert ranges[beam] == pytest.approx(expected, abs=LARGEST_ERROR), (x, y, yaw, beam)
            seen += math.isfinite(expected)
    assert seen > PLACES * F1TENTH.samples / EVERY / 4, "most places see walls"
