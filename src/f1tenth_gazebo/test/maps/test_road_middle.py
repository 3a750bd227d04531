"""The middle of a road is found on a map of it."""

import dataclasses
import os
from pathlib import Path

import numpy as np
import pytest
import shipped
from f1tenth_gazebo.maps.road_middle import middle_of_road
from f1tenth_gazebo.tools import make_centerline
from f1tenth_judge.errors import MapError
from f1tenth_judge.places.map_file import Grid, load_map, save_map
from scipy.spatial import cKDTree

ROOT = shipped.PACKAGE.parents[1]
DATA = Path(os.environ.get("F1TENTH_DATA", ROOT.parent / "shared" / "data"))
TRACKS = sorted([*(ROOT / "data" / "tracks").iterdir(), *(DATA / "tracks").glob("*")])
FREE, UNKNOWN, WALL = 254, 205, 0


def ring(islands=()):
    """A road between squares of 8 and 4 m about (3, 0): on its lower side it is 2 m wide along y = -3."""
    pixels = np.zeros((200, 200), np.uint8)
    pixels[20:180, 20:180] = FREE
    pixels[60:140, 60:140] = WALL
    for rows, columns in islands:
        pixels[rows, columns] = WALL
    return Grid(pixels, -2.0, -5.0)


def dense(points):
    """The closed line as many points."""
    steps = np.linspace(0.0, 1.0, 20, endpoint=False)[:, np.newaxis, np.newaxis]
    return (points + (np.roll(points, -1, axis=0) - points) * steps).reshape(-1, 2)


def apart(points, line):
    """How far points are from a closed line, m."""
    return cKDTree(dense(line)).query(points)[0]


@pytest.mark.parametrize(("yaw", "turn"), [(0.0, 1.0), (3.1, -1.0)])
def test_line_goes_the_way_of_the_start_with_the_road_to_both_sides(yaw, turn):
    rows = middle_of_road(ring(), (3.0, -3.0, yaw))
    assert rows[0] == pytest.approx([3.0, -3.0, 1.0, 1.0], abs=0.06)
    heading = rows[1, :2] - rows[0, :2]
    assert heading[0] * turn > 0.0
    assert abs(heading[1]) < 0.02
    x, y = rows.T[:2]
    assert np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) * turn > 0.0


def test_width_is_that_to_the_nearer_side():
    for row in middle_of_road(ring(), (3.0, -3.0, 0.0)):
        away = np.abs(row[:2] - (3.0, 0.0))
        nearer = min(4.0 - max(away), np.hypot(*np.maximum(away - 2.0, 0.0)))
        assert row[2] == row[3]
        assert row[2] == pytest.approx(nearer, abs=0.06)
    narrow = middle_of_road(ring([(slice(20, 40), slice(60, 140))]), (3.0, -2.5, 0.0))
    assert narrow[0, 2:] == pytest.approx([0.5, 0.5], abs=0.06)


def test_line_leads_around_islands_on_the_wider_side():
    upper = (slice(165, 170), slice(100, 105))  # x 3 to 3.25, y 3.25 to 3.5: nearer to the outer wall
    lower = (slice(42, 44), slice(100, 102))  # y -2.9 to -2.8: nearer to the inner wall
    rows = middle_of_road(ring([upper, lower]), (0.0, 0.0, 1.5))
    beside = rows[np.abs(rows[:, 0] - 3.1) < 0.4]
    assert beside[beside[:, 1] > 0, 1] == pytest.approx(2.63, abs=0.2)
    assert beside[beside[:, 1] < 0, 1] == pytest.approx(-3.45, abs=0.2)
    islands = np.array([(3.1, 3.4), (3.05, -2.85)])
    assert cKDTree(dense(rows[:, :2])).query(islands)[0].min() > 0.4


def test_walls_may_be_dotted_and_unknown_specks_lie_on_the_road():
    pixels = ring().pixels.copy()
    pixels[20:180, 20:180][::, ::] = FREE
    for low, high in ((20, 180), (60, 140)):
        for at in (low, high):
            pixels[at, low:high:4] = pixels[low:high:4, at] = WALL
    pixels[:19] = pixels[182:] = pixels[:, :19] = pixels[:, 182:] = UNKNOWN
    dotted = Grid(pixels, -2.0, -5.0)
    rows = middle_of_road(dotted, (3.0, -3.0, 0.0))
    assert apart(rows[:, :2], middle_of_road(ring(), (3.0, -3.0, 0.0))[:, :2]).max() < 0.1
    pixels = pixels.copy()
    pixels[39:42, 70:130] = pixels[38:42, 80:84] = UNKNOWN
    specks = middle_of_road(Grid(pixels, -2.0, -5.0), (3.0, -3.0, 0.0))
    np.testing.assert_array_equal(specks, rows)


@pytest.mark.parametrize("yaw", [0.5, 3.14, -1.2])
def test_a_map_may_be_turned(yaw):
    c, s = np.cos(yaw), np.sin(yaw)
    origin, turn = np.array([-2.0, -5.0]), np.array([[c, -s], [s, c]])
    grid = dataclasses.replace(ring(), yaw=yaw)
    x, y = turn @ (np.array([3.0, -3.0]) - origin) + origin
    rows = middle_of_road(grid, (x, y, yaw))
    straight = middle_of_road(ring(), (3.0, -3.0, 0.0))
    np.testing.assert_allclose(rows[:, :2], (straight[:, :2] - origin) @ turn.T + origin, atol=1e-6)
    np.testing.assert_allclose(rows[:, 2:], straight[:, 2:], atol=1e-6)


# Furniture stands beside the road of the detailed one.
@pytest.mark.parametrize("name", sorted({*shipped.NAMES} - {"circuit_detailed"}))
def test_middle_of_a_circuit_is_its_centreline(name):
    rows = middle_of_road(load_map(shipped.PACKAGE / "maps" / f"{name}.yaml"))
    lap = shipped.lap(name)
    line = np.array([lap.pose(way)[:2] for way in np.arange(0.0, lap.length, 0.1)])
    assert apart(rows[:, :2], line).max() < 0.08
    assert apart(line, rows[:, :2]).max() < 0.08


@pytest.mark.parametrize("track", TRACKS, ids=lambda track: track.name)
def test_middle_of_a_track_is_the_line_that_came_with_it(track):
    given = np.genfromtxt(track / f"{track.name}_centerline.csv", delimiter=",")[:, :2]
    start = (*given[0], np.arctan2(*(given[1] - given[0])[::-1]))
    rows = middle_of_road(load_map(track / f"{track.name}_map.yaml"), start)
    assert apart(rows[:, :2], given).mean() < 0.015
    assert apart(given, rows[:, :2]).max() < 0.25  # in hairpins theirs is not in the middle
    assert (rows[3, :2] - rows[0, :2]) @ (given[1] - given[0]) > 0.0


@pytest.mark.parametrize(
    ("grid", "start", "problem"),
    [
        (ring(), (3.0, 0.0, 0.0), r"at the start \(3, 0\) the map shows no road, must be free"),
        (ring(), (30.0, 0.0, 0.0), r"at the start \(30, 0\) the map shows no road, must be free"),
        (ring(), (np.nan, 0.0, 0.0), r"the start is \(nan, 0.0, 0.0\), must be finite numbers"),
        (
            ring([(slice(22, 58), slice(90, 110))]),
            (-0.5, 0.0, 0.0),
            "the road at the start goes around nothing, must lead back to the start for a car",
        ),
        (
            Grid(np.pad(np.full((50, 50), FREE, np.uint8), 5), -1.0, -1.0),
            (0.0, 0.0, 0.0),
            "the road at the start goes around nothing, must lead back to the start for a car",
        ),
        (
            ring(),
            (3.0, -2.1, 0.0),
            r"at the start \(3, -2.1\) the road reaches 0.13 m to a side, must be 0.15 m",
        ),
    ],
)
def test_map_without_a_road_is_refused(grid, start, problem):
    with pytest.raises(MapError, match=f"^{problem}$"):
        middle_of_road(grid, start)


def test_command_writes_the_line_beside_the_map_and_names_a_map_without_a_road(tmp_path, capsys):
    save_map(ring(), tmp_path / "lab_map")
    lab = str(tmp_path / "lab_map.yaml")
    assert make_centerline([lab, "--start", "3", "0", "0"]) == 1
    assert capsys.readouterr().err == f"{lab}: at the start (3, 0) the map shows no road, must be free\n"
    assert make_centerline([lab, "--start", "3", "-3", "0"]) == 0
    lines = (tmp_path / "lab_centerline.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0] == "# x_m, y_m, w_tr_right_m, w_tr_left_m"
    assert len(lines) == pytest.approx(24.0 / 0.3, abs=4)


def test_command_names_a_map_that_is_not_there(tmp_path, capsys):
    assert make_centerline([str(tmp_path / "none.yaml")]) == 1
    assert capsys.readouterr().err == f"{tmp_path / 'none.yaml'}: no such file, or it cannot be read\n"


def test_an_image_that_claims_too_many_pixels_is_refused_by_its_name(tmp_path):
    save_map(ring(), tmp_path / "lab")
    (tmp_path / "lab.pgm").write_text("P5 11000 10000 255\n")
    with pytest.raises(MapError, match="lab.pgm: has 11000 x 10000 pixels, allowed are 1 to 100000000$"):
        load_map(tmp_path / "lab.yaml")


def test_map_says_what_is_free_and_must_not_be_turned(tmp_path):
    save_map(ring(), tmp_path / "lab")
    path = tmp_path / "lab.yaml"
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("free_thresh: 0.196", "free_thresh: 0.001"), encoding="utf-8")
    with pytest.raises(MapError, match="the map shows no road"):
        middle_of_road(load_map(path), (3.0, -3.0, 0.0))
    path.write_text(text.replace("0.000000]", "0.5]"), encoding="utf-8")
    with pytest.raises(MapError, match=f"^{path}: its origin is turned by 0.5 rad, must not be turned$"):
        load_map(path)
