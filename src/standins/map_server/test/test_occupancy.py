from pathlib import Path

import numpy as np
import pytest
from map_server.metadata import MapMetadata
from map_server.occupancy import cells_from_brightness, pixels_from_cells


def cells(brightness, **settings):
    metadata = MapMetadata(image=Path("map.pgm"), resolution=0.05, **settings)
    return cells_from_brightness(np.array(brightness, dtype=float), metadata).tolist()


def test_trinary_tells_free_occupied_and_unknown():
    assert cells([254, 0, 205]) == [0, 100, -1]


def test_negate_swaps_black_and_white():
    assert cells([1, 255, 50], negate=True) == [0, 100, -1]


def test_thresholds_are_strict():
    # Brightness 51 is an occupancy of exactly 0.8, 204 of exactly 0.2.
    settings = {"occupied_thresh": 0.8, "free_thresh": 0.2}
    assert cells([50, 51, 52, 203, 204, 205], **settings) == [100, -1, -1, -1, -1, 0]


def test_scale_spreads_what_lies_between_from_1_to_99_truncated():
    settings = {"occupied_thresh": 1.0, "free_thresh": 0.0, "mode": "scale"}
    assert cells([255, 254, 128, 127, 0], **settings) == [1, 1, 49, 50, 99]


def test_scale_keeps_free_and_occupied():
    assert cells([254, 0, 205], mode="scale") == [0, 100, 1]


def test_raw_gives_the_pixel_itself_as_a_signed_byte():
    assert cells([0, 1, 127, 128, 255], mode="raw") == [0, 1, 127, -128, -1]


def test_raw_with_negate_gives_its_complement():
    assert cells([255, 155.5], mode="raw", negate=True) == [0, 99]


@pytest.mark.parametrize(
    ("cell", "pixel"), [(-1, 205), (0, 254), (25, 254), (26, 205), (64, 205), (65, 0), (100, 0), (-128, 205)]
)
def test_saving_goes_by_the_saver_s_thresholds(cell, pixel):
    assert pixels_from_cells(np.array([[cell]], dtype=np.int8), 65, 25).tolist() == [[pixel]]
