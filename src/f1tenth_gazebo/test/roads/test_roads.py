"""Every random road must be one that can be driven; what is asked for must be there, or refused."""

import math
import os
from functools import cache

import numpy as np
import pytest
import yaml
from f1tenth_gazebo.roads import RoadError, make_road, write_road
from f1tenth_gazebo.roads.road import TOLERANCE
from f1tenth_gazebo.roads.road_files import road_grid
from f1tenth_gazebo.roads.road_options import LIMITS, MIN_RADIUS, MIN_WIDTH
from f1tenth_gazebo.roads.road_tool import main
from PIL import Image
from scipy import ndimage
from shapely.geometry import LinearRing, Point, Polygon
from shapely.ops import unary_union

import f1tenth_sim2d

CAR_WIDTH = 0.31
SEEDS = range(26)


@cache
def road(seed):
    return make_road(seed)


@cache
def solid(seed):
    """Measured with another library than the one that the generator uses for it."""
    walls = [Polygon(outline) for outline in road(seed).outlines()]
    return unary_union(walls + [Point(x, y).buffer(r, 32) for x, y, r in road(seed).islands])


def radius_of(points):
    """Of the circle through each three neighbours on a closed line, m."""
    before, after = np.roll(points, 2, axis=0), np.roll(points, -2, axis=0)
    a, b, c = (np.hypot(*(p - q).T) for p, q in ((points, before), (after, points), (after, before)))
    (ax, ay), (bx, by) = (points - before).T, (after - points).T
    return a * b * c / np.maximum(2.0 * np.abs(ax * by - ay * bx), 1e-12)


@pytest.mark.parametrize("seed", SEEDS)
class TestEverySeed:
    def test_line_starts_at_the_origin_and_has_the_wanted_length(self, seed):
        line = road(seed).line
        assert line.points[0] == pytest.approx((0.0, 0.0), abs=1e-6)
        assert math.remainder(line.headings[0], math.tau) == pytest.approx(0.0, abs=1e-3)
        # Around islands the way is a little longer.
        assert line.length == pytest.approx(road(seed).options.length, rel=0.01, abs=0.05)
        assert LIMITS["length"][0] <= road(seed).options.length <= LIMITS["length"][1]

    def test_line_can_be_steered(self, seed):
        assert radius_of(road(seed).line.points).min() > MIN_RADIUS - TOLERANCE

    def test_line_is_free_for_the_least_width(self, seed):
        ring = LinearRing(road(seed).line.points)
        assert ring.is_simple
        assert ring.distance(solid(seed)) > 0.5 * MIN_WIDTH - TOLERANCE

    def test_widths_are_the_distances_to_the_walls(self, seed):
        places = range(0, len(road(seed).line.points), 25)
        for i in places:
            distance = solid(seed).distance(Point(road(seed).line.points[i]))
            assert min(road(seed).to_left[i], road(seed).to_right[i]) == pytest.approx(distance, abs=0.02)

    def test_nothing_wider_than_a_gap_is_open(self, seed):
        """A car that grew into the walls by half of a gap's width could not leave the road."""
        closed = solid(seed).buffer(0.5 * (CAR_WIDTH - 0.02))
        bounds = closed.envelope.buffer(1.0)
        (here,) = [part for part in bounds.difference(closed).geoms if part.contains(Point(0.0, 0.0))]
        assert not here.intersects(bounds.exterior)


def test_seeds_make_all_kinds_of_roads():
    options = [road(seed).options for seed in SEEDS]
    assert min(o.length for o in options) < 40.0
    assert max(o.length for o in options) > 350.0
    assert min(o.width[0] for o in options) < 1.3
    assert max(o.width[1] for o in options) > 3.5
    assert max(o.straight for o in options) > 60.0
    assert min(road(seed).least_radius() for seed in SEEDS) < 1.15 * MIN_RADIUS
    for name in ("hairpins", "chicanes", "gaps", "islands", "raggedness"):
        assert sum(getattr(o, name) > 0 for o in options) > len(SEEDS) / 10, name
    turns = [LinearRing(road(seed).line.points).is_ccw for seed in SEEDS]
    assert 0.3 < sum(turns) / len(SEEDS) < 0.7


def test_same_seed_makes_the_same_road(tmp_path):
    first = write_road(make_road(7), tmp_path / "a")
    second = write_road(make_road(7), tmp_path / "b")
    assert [p.name for p in first] == ["a.pgm", "a.yaml", "a_centerline.csv", "a.world"]
    for one, other in zip(first, second):
        assert one.read_bytes().replace(b"a.pgm", b"b.pgm").replace(b"'a'", b"'b'") == other.read_bytes()


def test_what_is_given_is_there_and_the_rest_stays_as_drawn():
    free = make_road(3)
    given = make_road(3, length=120.0, width=1.8, hairpins=2, chicanes=1, islands=1, gaps=3, raggedness=0.05)
    assert given.line.length == pytest.approx(120.0, abs=0.5)
    assert given.options.width == (1.8, 1.8)
    assert (given.options.hairpins, given.options.chicanes, given.options.gaps) == (2, 1, 3)
    assert len(given.islands) == 1
    assert given.options.radius == free.options.radius
    assert given.options.cell == free.options.cell


def test_each_hairpin_turns_by_half_a_circle_without_a_pause():
    line = make_road(1, length=150.0, width=1.5, hairpins=3, chicanes=0, islands=0).line
    steps = np.diff([*line.distances, line.length])
    runs = np.split(
        line.curvatures * steps, np.flatnonzero(np.diff(np.sign(np.round(line.curvatures, 3)))) + 1
    )
    assert sum(abs(run.sum()) > math.pi - 0.2 for run in runs) >= 3


@pytest.mark.parametrize("seed", [0, 4, 18, 21, 27])
def test_map_shows_walls_and_the_ground_between_them(seed):
    grid = road_grid(road(seed))
    cells = np.random.default_rng(seed).integers((0, 0), grid.pixels.shape, size=(1500, 2))
    for row, column in cells:
        centre = Point(grid.x + (column + 0.5) * grid.resolution, grid.y + (row + 0.5) * grid.resolution)
        distance = solid(seed).distance(centre)
        if grid.pixels[row, column] == 0:
            assert distance < 0.75 * grid.resolution
        else:
            assert distance > 0.25 * grid.resolution
    free = grid.pixels == 254
    area = free.sum() * grid.resolution**2
    assert area == pytest.approx(road(seed).inside.area, rel=0.2)
    assert ndimage.label(free)[1] <= 1 + 2 * road(seed).options.gaps


@pytest.mark.parametrize("seed", [18, 27])
def test_simulator_reads_world_and_map_alike(seed, tmp_path):
    _, map_file, centreline, world_file = write_road(road(seed), tmp_path / "road")
    world = f1tenth_sim2d.load_world(str(world_file))
    assert [warning for warning in world.warnings if "<light>" not in warning] == []
    outlines, circles = world.section(0.16)
    assert len(outlines) == len(road(seed).walls)
    assert np.array(sorted(map(tuple, circles))) == pytest.approx(
        np.array(sorted(road(seed).islands)), abs=1e-5
    )
    start = f1tenth_sim2d.load_world(str(map_file)).start
    assert tuple(start) == pytest.approx((0.0, 0.0, 0.0), abs=1e-3)
    rows = np.loadtxt(centreline, delimiter=",")
    assert rows.shape[1] == 4
    assert rows[:, 2:].min() > 0.5 * MIN_WIDTH - TOLERANCE
    description = yaml.safe_load(map_file.read_text())
    assert description["resolution"] == pytest.approx(road(seed).options.cell, abs=1e-6)
    assert Image.open(tmp_path / description["image"]).size[0] > 100


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"length": 20.0}, "length: found 20.0, allowed: 30 to 400"),
        ({"length": math.nan}, "length: found nan, allowed: 30 to 400"),
        ({"length": 0.0}, "length: found 0.0, allowed: 30 to 400"),
        ({"width": 0.5}, "width: found 0.5, allowed: 1.2 to 4"),
        ({"width": (2.0, 1.5)}, "width: found 2:1.5, allowed: a width, or the least and the greatest"),
        ({"radius": 0.5}, "radius: found 0.5, allowed: 0.815 to 5"),
        (
            {"straight": 20.0, "length": 40.0},
            "straight: found 20, allowed: up to a third of the length, 13.3",
        ),
        ({"cell": math.nan}, "cell: found nan, allowed: 0.03 to 0.1"),
        ({"islands": 1, "width": 1.3}, "islands: found 1 on a road 1.3 wide, allowed: from 1.4 on"),
        ({"bumps": 1}, "bumps: no such option, allowed: length, width, radius, "),
    ],
)
def test_options_that_no_road_can_have_are_refused(given, message):
    with pytest.raises(RoadError) as error:
        make_road(0, **given)
    assert str(error.value).startswith(message)


def test_road_that_has_no_room_for_what_is_wanted_is_refused(monkeypatch):
    monkeypatch.setattr("f1tenth_gazebo.roads.road._ATTEMPTS", 10)
    with pytest.raises(RoadError, match="^seed 0: found no road with length 30, .*hairpins 8"):
        make_road(0, length=30.0, width=2.0, hairpins=8)


class TestCommand:
    def test_writes_all_files_and_says_what_they_are(self, tmp_path, capsys):
        stem = tmp_path / "mine"
        assert main(["--seed", "5", "--length", "60", "--width", "1.5:2", "-o", str(stem)]) == 0
        assert capsys.readouterr().out.startswith("60.0 m long, 1.")
        assert sorted(path.name for path in tmp_path.iterdir()) == [
            "mine.pgm",
            "mine.world",
            "mine.yaml",
            "mine_centerline.csv",
        ]

    def test_wrong_option_ends_in_one_line_and_writes_nothing(self, tmp_path, capsys, monkeypatch):
        monkeypatch.chdir(tmp_path)
        assert main(["--seed", "5", "--length", "5"]) == 1
        assert capsys.readouterr().err == "make_road: length: found 5.0, allowed: 30 to 400\n"
        assert list(tmp_path.iterdir()) == []

    @pytest.mark.parametrize("width", ["a:b", "1:2:3", ":", ""])
    def test_width_that_is_none_is_answered_with_its_form(self, width, capsys):
        with pytest.raises(SystemExit):
            main(["--seed", "5", "--width", width])
        assert f"argument --width: found {width!r}, allowed: M or LOW:HIGH\n" in capsys.readouterr().err

    def test_folder_that_is_not_there_is_named(self, tmp_path, capsys):
        assert main(["--seed", "8", "-o", str(tmp_path / "none" / "road")]) == 1
        error = capsys.readouterr().err
        assert "none/" in error
        assert "No such file or directory" in error

    def test_folder_that_cannot_be_replaced_leaves_nothing_half_written(self, tmp_path, capsys):
        os.mkdir(tmp_path / "road.world")
        assert main(["--seed", "8", "-o", str(tmp_path / "road")]) == 1
        assert "Is a directory" in capsys.readouterr().err
        assert not [path for path in tmp_path.iterdir() if path.name.startswith(".")]
