import numpy as np
import pytest
from map_files import random_cells
from map_server.errors import MapSaveError
from map_server.grid_map import GridMap
from map_server.map_io import load_map, save_map
from map_server.metadata import read_metadata


def a_map(cells, origin=(-1.5, 2.25, 0.0)):
    return GridMap(cells=np.array(cells, dtype=np.int8), resolution=0.05, origin=origin)


@pytest.mark.parametrize("seed", range(5))
def test_map_saved_and_loaded_again_is_identical_cell_by_cell(tmp_path, seed):
    grid = a_map(random_cells(seed, height=20 + seed, width=31), origin=(-12.345678, 0.5, -1.25))
    save_map(grid, tmp_path / "map")
    again = load_map(read_metadata(tmp_path / "map.yaml"))
    np.testing.assert_array_equal(again.cells, grid.cells)
    assert (again.resolution, again.origin) == (grid.resolution, grid.origin)


def test_yaml_is_written_as_by_the_original(tmp_path):
    save_map(a_map([[0]]), tmp_path / "circuit1")
    assert (tmp_path / "circuit1.yaml").read_text() == (
        "image: circuit1.pgm\n"
        "resolution: 0.050000\n"
        "origin: [-1.500000, 2.250000, 0.000000]\n"
        "negate: 0\n"
        "occupied_thresh: 0.65\n"
        "free_thresh: 0.196\n\n"
    )


def test_image_is_written_as_by_the_original_with_the_top_row_first(tmp_path):
    save_map(a_map([[0, 100], [-1, 50]]), tmp_path / "map")
    assert (tmp_path / "map.pgm").read_bytes() == (
        b"P5\n# CREATOR: map_saver.cpp 0.050 m/pix\n2 2\n255\n" + bytes([205, 205, 254, 0])
    )


@pytest.mark.parametrize("name", ["two words", "a: b", "a #1", "'quoted", "-", "null"])
def test_any_file_name_can_be_loaded_again(tmp_path, name):
    save_map(a_map([[100]]), tmp_path / name)
    assert load_map(read_metadata(tmp_path / f"{name}.yaml")).cells.tolist() == [[100]]


def test_saved_pair_can_be_moved(tmp_path):
    (tmp_path / "old").mkdir()
    save_map(a_map([[100]]), tmp_path / "old" / "map")
    (tmp_path / "old").rename(tmp_path / "new")
    assert load_map(read_metadata(tmp_path / "new" / "map.yaml")).cells.tolist() == [[100]]


def test_thresholds_decide_what_is_saved(tmp_path):
    save_map(a_map([[10, 40, 90]]), tmp_path / "map", occupied_at_least=40, free_at_most=9)
    assert load_map(read_metadata(tmp_path / "map.yaml")).cells.tolist() == [[-1, 100, 100]]


def test_map_without_cells_is_refused(tmp_path):
    with pytest.raises(MapSaveError, match="the map has no cells: 0 x 3"):
        save_map(a_map(np.zeros((3, 0))), tmp_path / "map")
    assert list(tmp_path.iterdir()) == []
