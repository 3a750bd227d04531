"""Every shipped world: exact scans from random places against shapely and a reader of its own."""

import math
from pathlib import Path

import numpy as np
import pytest
from sdf_slices import slice_world
from shapely.geometry import LineString, Point
from shapely.ops import unary_union

import f1tenth_sim2d

SHIPPED = Path(__file__).parents[3] / "f1tenth_gazebo"
WORLDS = sorted((SHIPPED / "worlds").glob("*.world"))
LIDAR_HEIGHT = 0.16  # m
BEAMS = 1081
MAX_ANGLE = 0.75 * math.pi  # rad, to both sides
RANGE_MAX = 10.0  # m
# A car that is only a lidar, so that it fits anywhere: what it could touch with is far above all walls.
LIDAR = f"""<sdf version="1.7"><model name="lidar"><link name="base_footprint">
<collision name="bead"><pose>0 0 50 0 0 0</pose>
<geometry><sphere><radius>0.001</radius></sphere></geometry></collision>
<sensor name="lidar" type="ray"><pose>0 0 {LIDAR_HEIGHT} 0 0 0</pose><update_rate>40</update_rate><ray>
  <scan><horizontal>
    <samples>{BEAMS}</samples><min_angle>{-MAX_ANGLE}</min_angle><max_angle>{MAX_ANGLE}</max_angle>
  </horizontal></scan>
  <range><min>0</min><max>{RANGE_MAX}</max></range>
</ray>
<plugin name="laser" filename="libgazebo_ros_laser.so">
  <topicName>scan</topicName><frameName>laser</frameName>
</plugin></sensor></link></model></sdf>"""
PLACES = 12
EVERY = 29  # beams
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
        end = (x + RANGE_MAX * math.cos(angle), y + RANGE_MAX * math.sin(angle))
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
    simulation.add_car(f1tenth_sim2d.load_car(LIDAR, "lidar", "bare lidar"), None, 1000.0, 1000.0)
    angles = np.linspace(-MAX_ANGLE, MAX_ANGLE, BEAMS)
    seen = 0
    for x, y, yaw in places(scenery, np.random.default_rng(11)):
        simulation.place_car(0, x, y, yaw)
        ranges = simulation.scan(0, exact=True)
        for beam in range(0, BEAMS, EVERY):
            expected = scenery.range(x, y, yaw + angles[beam])
            if grazes(scenery, x, y, yaw + angles[beam]):
                continue
            assert ranges[beam] == pytest.approx(expected, abs=LARGEST_ERROR), (x, y, yaw, beam)
            seen += math.isfinite(expected)
    assert seen > PLACES * BEAMS / EVERY / 4, "most places see walls"
