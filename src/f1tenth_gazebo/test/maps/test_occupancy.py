"""Maps must show what is solid and what can be reached, in map_saver's format."""

import numpy as np
import pytest
from f1tenth_gazebo.maps.occupancy import FREE, OCCUPIED, UNKNOWN, occupancy_grid, open_grid
from f1tenth_judge.errors import CircuitError
from f1tenth_judge.places.map_file import Grid, save_map


def rectangle(x_low, y_low, x_high, y_high):
    return np.array([[x_low, y_low], [x_high, y_low], [x_high, y_high], [x_low, y_high]])


def room():
    """Walls around (-1, -1) ... (1, 1)."""
    return [
        rectangle(-1.1, -1.1, 1.1, -1.0),
        rectangle(-1.1, 1.0, 1.1, 1.1),
        rectangle(-1.1, -1.1, -1.0, 1.1),
        rectangle(1.0, -1.1, 1.1, 1.1),
    ]


def pixel(grid, x, y):
    return grid.pixels[int((y - grid.y) / 0.05), int((x - grid.x) / 0.05)]


def test_reachable_is_free_solid_is_occupied_and_the_rest_unknown():
    grid = occupancy_grid(room(), [])
    assert pixel(grid, 0.01, 0.01) == FREE
    assert pixel(grid, 1.05, 0.01) == OCCUPIED
    assert pixel(grid, 1.3, 0.01) == UNKNOWN
    assert (grid.pixels == FREE).sum() == 40 * 40


def test_an_open_world_is_mapped_in_an_extent():
    grid = open_grid(
        [rectangle(-9.0, 0.0, -1.0, 1.0), rectangle(20.0, 0.0, 21.0, 1.0)], [(2.0, 0.0, 0.5)], (-2, -1, 4, 3)
    )
    assert grid.extent == pytest.approx((-2, 4, -1, 3))
    assert pixel(grid, -1.5, 0.5) == pixel(grid, 2.01, 0.01) == OCCUPIED
    assert pixel(grid, 0.01, 0.01) == pixel(grid, 3.9, 2.9) == FREE
    assert (grid.pixels == UNKNOWN).sum() == 0


@pytest.mark.parametrize(
    "extent", [(0, 0, 0, 1), (1, 0, 0, 1), (0, 0, np.inf, 1), (0, 0, 1000, 1000), (0, 0, np.nan, 1)]
)
def test_an_extent_that_is_none_is_refused(extent):
    with pytest.raises(CircuitError, match="^the extent is .*, must be XMIN YMIN XMAX YMAX"):
        open_grid([], [], extent)


def test_what_is_behind_a_wall_is_unknown():
    grid = occupancy_grid([*room(), rectangle(-1.0, 0.5, 1.0, 0.55)], [])
    assert pixel(grid, 0.01, 0.8) == UNKNOWN


def test_a_thin_leg_is_not_lost():
    grid = occupancy_grid(room(), [(0.5, 0.5, 0.018)])
    assert pixel(grid, 0.501, 0.501) == OCCUPIED


def test_an_outline_may_be_concave():
    outline = np.array([[0.2, 0.2], [0.8, 0.2], [0.8, 0.8], [0.6, 0.8], [0.6, 0.4], [0.2, 0.4]])
    grid = occupancy_grid([*room(), outline], [])
    assert pixel(grid, 0.71, 0.71) == OCCUPIED
    assert pixel(grid, 0.31, 0.61) == FREE


def test_a_gap_in_the_walls_is_refused():
    with pytest.raises(CircuitError, match=r"the walls around the start \(0.0, 0.0\) have a gap"):
        occupancy_grid(room()[:3], [])


def test_a_start_inside_of_something_is_refused():
    with pytest.raises(CircuitError, match=r"the start \(0.0, 0.0\) is not on free ground"):
        occupancy_grid([*room(), rectangle(-0.1, -0.1, 0.1, 0.1)], [])


def test_image_has_the_top_row_first(tmp_path):
    grid = Grid(np.array([[0, 205, 254], [254, 254, 0]], dtype=np.uint8), -1.5, 2.0)
    save_map(grid, tmp_path / "a.b")
    assert (tmp_path / "a.b.pgm").read_bytes() == b"P5\n# CREATOR: make_map 0.050 m/pix\n3 2\n255\n" + bytes(
        [254, 254, 0, 0, 205, 254]
    )


def test_yaml_is_written_as_map_saver_writes_it(tmp_path):
    grid = Grid(np.zeros((1, 1), dtype=np.uint8), -1.5, 2.0)
    save_map(grid, tmp_path / "a.b")
    assert (tmp_path / "a.b.yaml").read_text() == (
        "image: a.b.pgm\nresolution: 0.050000\norigin: [-1.500000, 2.000000, 0.000000]\n"
        "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n\n"
    )
