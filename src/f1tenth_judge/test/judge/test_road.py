"""A lap is a lap of the road: who cuts it has driven none, and who leaves it is told where."""

import itertools
import math

import numpy as np
import pytest
from f1tenth_judge.judge.road import excursions
from f1tenth_judge.judge.start_line import times_of_laps
from f1tenth_judge.places.course import Course
from f1tenth_judge.places.place import gates_after, line_across
from f1tenth_judge.scenario.car import Pose
from scenario_samples import PERIOD, record, rows

RADIUS, HALF = 10.0, 1.0  # m


def ring(points=120, backwards=False):
    """A round road about the origin, whose start line is at (0, -RADIUS)."""
    angles = np.linspace(0.0, math.tau, points, endpoint=False)[:: -1 if backwards else 1] - math.pi / 2
    width = np.full(points, HALF)
    return Course(RADIUS * np.cos(angles), RADIUS * np.sin(angles), width, width)


def driven(folder, places):
    """The track of a car that is at these places in turn."""
    table = [[*row[:2], x, y, *row[4:]] for row, (x, y) in zip(rows(PERIOD * len(places)), places)]
    return record(folder, table).tracks["robot1"]


def arc(centre, radius, begin, turn, step=0.2):
    count = max(2, int(abs(turn) * radius / step))
    angles = begin + np.linspace(0.0, turn, count)
    return list(zip(centre[0] + radius * np.cos(angles), centre[1] + radius * np.sin(angles)))


def straight(begin, end, step=0.2):
    count = max(2, int(math.dist(begin, end) / step))
    return list(zip(np.linspace(begin[0], end[0], count), np.linspace(begin[1], end[1], count)))


SOUTH = -math.pi / 2
LAP = arc((0, 0), RADIUS, SOUTH + 0.02, math.tau)
WAYS = {
    "round": (LAP + LAP, 2),
    "along the inner edge": (arc((0, 0), RADIUS - 0.9, SOUTH + 0.02, 2 * math.tau), 2),
    "beside the line": (arc((0, 0), RADIUS + 1.3, SOUTH + 0.02, math.tau), 0),
    "a circle over the line": (arc((0, -RADIUS + 1.0), 1.0, SOUTH + 0.02, 3 * math.tau), 0),
    "straight through the middle": (
        straight((0.2, -RADIUS), (0.0, RADIUS)) + arc((0, 0), RADIUS, math.pi / 2, math.pi + 0.1),
        0,
    ),
    "a corner cut": (
        arc((0, 0), RADIUS, SOUTH + 0.02, 0.5)
        + straight((RADIUS * math.sin(0.52), -RADIUS * math.cos(0.52)), (0.0, RADIUS))
        + arc((0, 0), RADIUS, math.pi / 2, math.pi + 0.1),
        0,
    ),
    "over the line and back": (
        straight((0.2, -RADIUS), (-1, -RADIUS)) + straight((-1, -RADIUS), (1, -RADIUS)),
        0,
    ),
    "the wrong way": (arc((0, 0), RADIUS, SOUTH + 0.02, -2 * math.tau), 0),
    "a cut, then a lap": (arc((0, -RADIUS + 1.0), 1.0, SOUTH + 0.02, math.tau) + LAP, 1),
}


@pytest.mark.parametrize("way", WAYS)
def test_lap_is_counted_only_if_it_was_driven_all_around(tmp_path, way):
    course, (places, laps) = ring(), WAYS[way]
    line = line_across(course, Pose(0.0, -RADIUS, 0.0))
    assert len(times_of_laps(line, driven(tmp_path, places), 0.0, gates_after(course, line))) == laps


def square(half, start):
    """Places on a square about the origin, 0.1 m apart, the first one `start` m after a corner."""
    corners = [(half, -half), (half, half), (-half, half), (-half, -half), (half, -half)]
    sides = [straight(*ends, step=0.1)[:-1] for ends in itertools.pairwise(corners)]
    places = [place for side in sides for place in side]
    return places[round(10 * start) :] + places[: round(10 * start)]


@pytest.mark.parametrize("start", range(3, 10))
def test_lap_along_the_inner_edge_of_sharp_corners_is_counted(tmp_path, start):
    width = 1.7
    places = square(10.0, start)
    course = Course(*np.transpose(places), np.full(len(places), width), np.full(len(places), width))
    line = line_across(course, Pose(*places[1], math.pi / 2))
    gates = gates_after(course, line)
    assert len(gates) > 8
    inner = square(10.0 - width + 0.1, start - 1.0)
    track = driven(tmp_path, inner + inner[:20])
    assert len(times_of_laps(line, track, 0.0, gates)) == 1
    cut = [each for each in inner if each[0] > 0.0 or each[1] > 0.0] + inner[:20]
    assert times_of_laps(line, driven(tmp_path, cut), 0.0, gates) == []


def test_race_against_the_centreline_has_its_gates_in_its_own_order(tmp_path):
    course = ring(backwards=True)
    line = line_across(course, Pose(0.0, -RADIUS, 0.0))
    assert len(times_of_laps(line, driven(tmp_path, LAP), 0.0, gates_after(course, line))) == 1


@pytest.mark.parametrize("seed", range(12))
def test_honest_laps_of_roads_made_at_random_are_all_counted(tmp_path, seed):
    random = np.random.default_rng(seed)
    course, half = wavy(random)
    across = random.uniform(-0.9, 0.9) * half
    heading = np.arctan2(
        np.roll(course.y, -1) - np.roll(course.y, 1), np.roll(course.x, -1) - np.roll(course.x, 1)
    )
    driven_x, driven_y = course.x - across * np.sin(heading), course.y + across * np.cos(heading)
    places = list(zip(np.append(driven_x, driven_x[:9]), np.append(driven_y, driven_y[:9])))
    start = Pose(float(course.x[2]), float(course.y[2]), float(heading[2]))
    line = line_across(course, start)
    assert len(times_of_laps(line, driven(tmp_path, places), 0.0, gates_after(course, line))) == 1
    assert list(excursions(course, [driven(tmp_path, places)])) == []


def wavy(random):
    """A closed road with bends both ways, and half its width (m)."""
    angles = np.linspace(0.0, math.tau, 400, endpoint=False)
    waves = [(n, random.uniform(0.0, 1.2) / n, random.uniform(0.0, math.tau)) for n in range(2, 6)]
    radius = 10.0 + sum(size * np.cos(n * angles + phase) for n, size, phase in waves)
    half = random.uniform(0.6, 1.2)
    width = np.full(len(angles), half)
    return Course(radius * np.cos(angles), radius * np.sin(angles), width, width), half


def test_each_time_a_car_leaves_the_road_is_told_with_its_place_and_duration(tmp_path):
    places = [(0.0, -10.0), (1.0, -11.5), (1.2, -12.0), (1.4, -11.2), (2.0, -10.0), (2.0, -8.0), (2.0, -10.0)]
    found = list(excursions(ring(points=4000), [driven(tmp_path, places)]))
    assert [(each.car, round(each.start / PERIOD), round(each.end / PERIOD)) for each in found] == [
        ("robot1", 2, 4),
        ("robot1", 6, 6),
    ]
    assert [(each.x, each.y) for each in found] == [(1.2, -12.0), (2.0, -8.0)]
    beyond = [math.hypot(1.2, 12.0) - RADIUS - HALF, RADIUS - HALF - math.hypot(2.0, 8.0)]
    assert [each.excess for each in found] == pytest.approx(beyond, abs=1e-4)


def test_car_that_stays_on_the_road_has_no_excursions(tmp_path):
    assert list(excursions(ring(points=4000), [driven(tmp_path, LAP)])) == []


@pytest.mark.parametrize(("yaw", "side"), [*itertools.product((0.0, math.pi / 2), (-1, 1))])
def test_start_line_reaches_both_edges_of_the_road_also_in_a_corner(yaw, side):
    """The corner of a corridor 2 m wide: at 45 degrees the road is wider than at its centreline's vertex."""
    course = Course(*np.array([[0, 20, 20, 0], [0, 0, 20, 20], [1] * 4, [1] * 4], dtype=float))
    line = line_across(course, Pose(20.0, 0.0, yaw))
    end = line.width / 2 * side
    x, y = line.x - end * math.sin(line.yaw), line.y + end * math.cos(line.yaw)
    step = 0.02 * side
    outside = np.array([x - step * math.sin(line.yaw)]), np.array([y + step * math.cos(line.yaw)])
    assert course.excess(np.array([x]), np.array([y]))[0] < 1e-6
    assert course.excess(*outside)[0] > 0.0
