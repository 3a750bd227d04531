import math
import re

import numpy as np
import pytest
import rospy
from map_files import random_cells
from map_server.conversions import from_occupancy_grid, to_occupancy_grid
from map_server.errors import MapSaveError
from map_server.grid_map import GridMap


def a_message():
    grid = GridMap(cells=random_cells(7), resolution=0.5, origin=(1.0, -2.0, 0.75))
    return grid, to_occupancy_grid(grid, "map", rospy.Time(3))


def test_message_says_where_the_map_lies_and_when_it_was_loaded():
    grid, message = a_message()
    assert (message.header.frame_id, message.header.stamp) == ("map", rospy.Time(3))
    assert message.info.map_load_time == rospy.Time(3)
    assert (message.info.width, message.info.height) == (53, 37)
    assert message.info.resolution == 0.5
    assert (message.info.origin.position.x, message.info.origin.position.y) == (1.0, -2.0)
    assert 2 * math.atan2(
        message.info.origin.orientation.z, message.info.origin.orientation.w
    ) == pytest.approx(0.75)
    assert list(message.data) == grid.cells.ravel().tolist()


def test_message_and_back_is_the_same_map():
    grid, message = a_message()
    again = from_occupancy_grid(message)
    np.testing.assert_array_equal(again.cells, grid.cells)
    assert again.origin == pytest.approx(grid.origin)


def test_message_with_too_few_cells_is_refused():
    _, message = a_message()
    message.data = message.data[:-1]
    with pytest.raises(MapSaveError, match="inconsistent: 53 x 37 cells announced, 1960 sent"):
        from_occupancy_grid(message)


@pytest.mark.parametrize("resolution", [0.0, 1e-7, 1e39])
def test_message_whose_resolution_no_file_holds_is_refused(resolution):
    _, message = a_message()
    message.info.resolution = resolution
    with pytest.raises(MapSaveError, match=re.escape(f"not usable: resolution {resolution}")):
        from_occupancy_grid(message)


def test_message_with_nan_in_its_origin_is_refused():
    _, message = a_message()
    message.info.origin.position.x = math.nan
    with pytest.raises(MapSaveError, match=r"not usable: resolution 0.5, origin \(nan, -2.0"):
        from_occupancy_grid(message)
