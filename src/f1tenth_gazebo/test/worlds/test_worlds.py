"""Every shipped world must be a circuit that a car can race on."""

import math

import pytest
import shipped
from shapely.geometry import LineString, Point, Polygon

LENGTHS = (30.0, 120.0)
WIDTHS = (1.2, 2.5)


def free_width(name, pose):
    """Widest free stretch across the road, m."""
    reach = 1.5
    across = (-math.sin(pose.yaw) * reach, math.cos(pose.yaw) * reach)
    line = LineString([(pose.x - across[0], pose.y - across[1]), (pose.x + across[0], pose.y + across[1])])
    free = line.difference(shipped.solid(name))
    stretches = [
        part for part in getattr(free, "geoms", [free]) if part.distance(Point(pose.x, pose.y)) < 0.4
    ]
    return max(part.length for part in stretches)


@pytest.mark.parametrize("name", shipped.NAMES)
class TestWorld:
    def test_loads_without_a_warning_but_of_the_light(self, name):
        assert [w for w in shipped.world(name).warnings if "<light>" not in w] == []

    def test_has_the_length_of_a_race_circuit(self, name):
        assert LENGTHS[0] <= shipped.lap(name).length <= LENGTHS[1]

    def test_is_closed_for_car_and_lidar(self, name):
        for height in (0.03, 0.1, shipped.LIDAR_HEIGHT):
            start = Point(0, 0)
            hull = shipped.solid(name, height).convex_hull.buffer(1.0)
            free = hull.difference(shipped.solid(name, height))
            (road,) = [part for part in free.geoms if part.contains(start)]
            assert not road.intersects(hull.boundary)

    def test_leads_around_back_to_the_start(self, name):
        lap = shipped.lap(name)
        driven = [lap.pose(i * lap.length / 500) for i in range(500)]
        assert len(Polygon([(p.x, p.y) for p in driven]).buffer(0).bounds) == 4
        total = sum(
            math.remainder(b.yaw - a.yaw, 2 * math.pi) for a, b in zip(driven, [*driven[1:], driven[0]])
        )
        assert total == pytest.approx(2 * math.pi)

    def test_is_wide_enough_everywhere_and_nowhere_too_wide(self, name):
        lap = shipped.lap(name)
        widths = [free_width(name, lap.pose(i * 0.1)) for i in range(int(lap.length / 0.1))]
        assert min(widths) >= WIDTHS[0] - 1e-3
        # A door to a room is no wider road.
        walls_only = widths if name != "circuit_detailed" else sorted(widths)[: -len(widths) // 20]
        assert max(walls_only) <= WIDTHS[1] + 1e-3

    def test_centreline_is_free_for_the_car(self, name):
        lap = shipped.lap(name)
        solid = shipped.solid(name)
        distances = [
            solid.distance(Point(p.x, p.y)) for p in (lap.pose(i * 0.1) for i in range(int(lap.length / 0.1)))
        ]
        assert min(distances) > 0.155

    def test_start_has_a_straight_and_room_for_two_cars(self, name):
        half_width, back, front = 0.155, -0.12, 0.47
        for y in (-0.3, 0.3):
            car = Polygon(
                [
                    (back, y - half_width),
                    (front, y - half_width),
                    (front, y + half_width),
                    (back, y + half_width),
                ]
            )
            assert shipped.solid(name).distance(car) > 0.3
        lap = shipped.lap(name)
        assert all(lap.pose(s).yaw == pytest.approx(0, abs=1e-9) for s in (0.0, 1.0, 2.0, 3.0))

    def test_walls_are_the_building_editors(self, name):
        model = next(m for m in shipped.world(name).models if m.name == name)
        assert model.is_static
        assert all(c.startswith(f"{name}::Wall_") for c in model.collisions)


def test_windows_have_a_sill_that_stops_the_lidar():
    sill = Point(0.5, 1.175)
    assert shipped.solid("circuit_detailed").contains(sill)
    assert not shipped.solid("circuit_detailed", 1.6).contains(sill)


def test_open_door_leads_into_the_room_and_the_shut_one_is_solid():
    assert not shipped.solid("circuit_detailed").contains(Point(4.0, -1.175))
    assert shipped.solid("circuit_detailed").contains(Point(11.175, 3.2))


def test_cartons_can_be_pushed_and_all_else_stays():
    movable = {m.name for m in shipped.world("circuit_detailed").models if not m.is_static}
    assert movable == {"cardboard_carton", "cardboard_carton_1"}


def test_what_a_car_can_touch_the_lidar_can_see():
    """A planner that knows the map must not drive into something below the lidar."""
    seen = shipped.solid("circuit_detailed").buffer(0.001)
    for height in (0.01, 0.03, 0.07, 0.105, 0.18):
        assert seen.contains(shipped.solid("circuit_detailed", height))
