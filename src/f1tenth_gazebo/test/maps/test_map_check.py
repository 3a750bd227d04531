"""The comparison of a map with its world must see what is wrong with a map."""

import re
from dataclasses import replace

import numpy as np
import pytest
from f1tenth_gazebo.maps.map_alignment import aligned
from f1tenth_gazebo.maps.map_check import check_map
from f1tenth_gazebo.maps.map_tool import main
from f1tenth_gazebo.maps.occupancy import FREE, OCCUPIED, occupancy_grid
from f1tenth_gazebo.maps.world_grid import LIDAR_HEIGHT
from f1tenth_judge.errors import MapError
from f1tenth_judge.places.map_file import Grid, load_map, save_map
from shipped import PACKAGE

import f1tenth_sim2d


def rectangle(x_low, y_low, x_high, y_high):
    return np.array([[x_low, y_low], [x_high, y_low], [x_high, y_high], [x_low, y_high]])


ROOM = [
    rectangle(-3.15, -2.15, 3.15, -2.0),
    rectangle(-3.15, 2.0, 3.15, 2.15),
    rectangle(-3.15, -2.15, -3.0, 2.15),
    rectangle(3.0, -2.15, 3.15, 2.15),
]


@pytest.fixture
def room():
    return occupancy_grid(ROOM, [(1.0, 1.0, 0.1)])


def check(grid, dx=0.0, circles=((1.0, 1.0, 0.1),)):
    return check_map(replace(grid, x=grid.x + dx), ROOM, list(circles))


def test_true_map_passes(room):
    assert check(room).passed
    assert check(room).worst_cell < 0.1


def test_moved_map_fails(room):
    assert not check(room, dx=0.2).passed


def test_map_that_is_turned_and_moved_has_the_shape_of_its_world(room):
    c, s = np.cos(0.06), np.sin(0.06)
    turned = [outline @ np.array([[c, s], [-s, c]]) + (0.15, -0.1) for outline in ROOM]
    circles = [(c - s + 0.15, s + c - 0.1, 0.1)]
    assert not check_map(room, turned, circles).passed
    found = aligned(room, turned, circles)
    assert (found.x, found.y, found.turn) == pytest.approx((0.15, -0.1, 0.06), abs=0.003)
    assert check_map(room, *found.section_on_map(turned, circles)).passed


def test_map_of_another_shape_is_not_mended_by_laying_it_on(room):
    wider = [outline * (1.1, 1.0) for outline in ROOM]
    assert not check_map(room, *aligned(room, wider, []).section_on_map(wider, [])).passed


def test_command_lays_a_map_onto_its_world_when_told(tmp_path, capsys):
    world = str(PACKAGE / "worlds" / "circuit1.world")
    grid = occupancy_grid(*f1tenth_sim2d.load_world(world).section(LIDAR_HEIGHT))
    save_map(Grid(grid.pixels, grid.x + 0.12, grid.y, grid.resolution), tmp_path / "moved")
    path = str(tmp_path / "moved.yaml")
    assert main(PACKAGE, [path, world]) == 1
    capsys.readouterr()
    assert main(PACKAGE, ["--align", path, "circuit1"]) == 0
    laid, compared = capsys.readouterr().out.splitlines()
    assert re.fullmatch(r"laid onto the world by -?0\.\d\d mrad and 0\.1[12]\d m", laid)
    assert compared.endswith("passed")


def test_doubled_wall_fails(room):
    rows, columns = np.nonzero(room.pixels == OCCUPIED)
    room.pixels[rows, np.minimum(columns + 5, room.pixels.shape[1] - 1)] = OCCUPIED
    result = check(room)
    assert result.cells_near_walls < 0.9
    assert result.worst_cell > 0.15


def test_missing_wall_fails(room):
    left = np.arange(room.pixels.shape[1]) * 0.05 + room.x < -2.9
    room.pixels[:, left] = np.where(room.pixels[:, left] == OCCUPIED, 254, room.pixels[:, left])
    assert check(room).walls_near_cells < 0.9


@pytest.mark.parametrize(
    ("pixel", "world", "problem"),
    [
        (FREE, ROOM, "the map has no wall cell (black), must have some"),
        (OCCUPIED, ROOM, "no wall of the world has a free cell (white) of the map before it, some must"),
        (OCCUPIED, [], "the world has nothing at the height of the lidar, must have walls there"),
    ],
)
def test_what_has_nothing_to_compare_is_refused(room, pixel, world, problem):
    room.pixels[:] = pixel
    with pytest.raises(MapError, match=f"^{re.escape(problem)}$"):
        check_map(room, world, [])


def test_command_names_the_map_and_the_world_that_cannot_be_compared(room, tmp_path, capsys):
    room.pixels[:] = FREE
    save_map(room, tmp_path / "blank")
    path, world = str(tmp_path / "blank.yaml"), str(PACKAGE / "worlds" / "circuit1.world")
    assert main(PACKAGE, [path, world]) == 2
    assert capsys.readouterr().err == f"{path}, {world}: the map has no wall cell (black), must have some\n"


def test_command_answers_a_wrong_name_with_the_known_ones(room, tmp_path, capsys):
    save_map(room, tmp_path / "a")
    assert main(PACKAGE, [str(tmp_path / "a.yaml"), "circuit9"]) == 2
    assert capsys.readouterr().err.startswith("there is no world named 'circuit9'; known names: circuit1, ")


def test_saved_map_reads_back(room, tmp_path):
    save_map(room, tmp_path / "a")
    found = load_map(tmp_path / "a.yaml")
    assert (found.pixels == room.pixels).all()
    assert found.resolution == 0.05
    assert (found.x, found.y) == pytest.approx((room.x, room.y))


def test_coarse_maps_may_err_by_their_cells(room):
    """Of 0.2 m, occupied where any of the 16 small ones is."""
    rows, columns = (size // 4 * 4 for size in room.pixels.shape)
    blocks = room.pixels[:rows, :columns].reshape(rows // 4, 4, columns // 4, 4)
    coarse = Grid(blocks.min(axis=(1, 3)), room.x, room.y, resolution=0.2)
    result = check(coarse)
    assert result.near == pytest.approx(0.25)
    assert result.passed
    assert result.worst_cell > 0.1


def test_far_side_of_a_wall_of_pixels_does_not_count():
    step, count = 0.09, 60
    corners = np.repeat(np.arange(count + 1), 2) * step
    near = np.column_stack([corners[1:], corners[:-1]])  # a staircase with the road below it
    outline = np.concatenate([near, near[::-1] + [-step, 2.0 * step]])
    y, x = (np.indices((120, 120)) + 0.5) * 0.05
    wall = np.maximum(0.0, np.ceil(x / step) - 1.0) * step
    pixels = np.select([y < wall, y < wall + 0.1], [254, 0], 205).astype(np.uint8)
    pixels[x > count * step] = 205
    result = check_map(Grid(pixels, 0.0, 0.0), [outline], [])
    assert result.walls_near_cells > 0.97


def test_gap_between_the_walls_of_two_roads_does_not_count():
    walls = [rectangle(-0.15, 0.0, -0.05, 5.0), rectangle(0.05, 0.0, 0.15, 5.0)]
    x = np.abs((np.arange(80) + 0.5) * 0.05 - 2.0)
    row = np.select([x > 0.2, x > 0.15], [254, 0], 205).astype(np.uint8)
    result = check_map(Grid(np.tile(row, (100, 1)), -2.0, 0.0), walls, [])
    assert result.walls_near_cells > 0.97
