"""Whether a car may as well have been elsewhere: rooms that look the same turned around, and almost."""

import math

import numpy as np
import pytest
from f1tenth_gazebo.maps.map_file import Grid
from f1tenth_studies.lost.alike import View, is_alike

HERE = (2.0, 1.5, 0.3)
TURNED = (6.0, 3.5, 0.3 + math.pi)  # about the middle of the room


def room(pillar=False):
    """8 m by 5 m, from the origin on; a pillar makes it unlike itself turned around."""
    pixels = np.full((102, 162), 254, dtype=np.uint8)
    pixels[[0, -1]] = 0
    pixels[:, [0, -1]] = 0
    if pillar:
        pixels[60:80, 120:130] = 0
    return Grid(pixels, -0.05, -0.05)


def seen(place, corner=(6.0, 3.0)):
    """Points of the walls, and of the pillar's two sides, in the frame of a car there."""
    along, across = np.linspace(0.0, 8.0, 81), np.linspace(0.0, 5.0, 51)
    sides = [(x, y) for x in along for y in (0.0, 5.0)] + [(x, y) for y in across for x in (0.0, 8.0)]
    if corner:
        sides += [(corner[0], corner[1] + 0.1 * i) for i in range(10)]
        sides += [(corner[0] + 0.1 * i, corner[1]) for i in range(5)]
    away = np.array(sides) - place[:2]
    c, s = math.cos(place[2]), math.sin(place[2])
    return View(away @ np.array([[c, -s], [s, c]]), place)


def test_a_room_without_a_pillar_looks_the_same_turned_around():
    assert is_alike(room(), [seen(HERE, corner=None)], HERE, TURNED)


def test_a_pillar_tells_where_the_car_is():
    assert not is_alike(room(pillar=True), [seen(HERE)], HERE, TURNED)


def test_one_view_of_the_pillar_on_the_way_tells():
    way = [seen(HERE, corner=None), seen((2.5, 1.5, 0.3))]
    assert not is_alike(room(pillar=True), way, HERE, TURNED)


@pytest.mark.parametrize("by", [(0.3, 0.0, 0.0), (-0.2, 0.2, 0.0), (0.0, 0.0, 0.1)])
def test_the_place_elsewhere_need_not_be_exact(by):
    there = tuple(a + b for a, b in zip(TURNED, by))
    assert is_alike(room(), [seen(HERE, corner=None)], HERE, there)


def test_what_is_not_on_the_map_is_not_alike():
    other = View(2.0 * seen(HERE, corner=None).points, HERE)
    assert not is_alike(room(), [other], HERE, TURNED)
