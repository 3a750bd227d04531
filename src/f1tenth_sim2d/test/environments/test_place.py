"""Maps as places; a changed file is loaded anew."""

import os

import numpy as np
import pytest
from PIL import Image

CORNERS = [(2, 2), (8, 2), (8, 8), (2, 8)]


def write_walls(path, inset=0):
    """Write a map of 10 m x 10 m whose walls stand so many cells inside of its border."""
    pixels = np.full((100, 100), 255, dtype=np.uint8)
    pixels[[inset, -1 - inset]] = pixels[:, [inset, -1 - inset]] = 0
    Image.fromarray(pixels).save(path)


def write_centreline(path, corners):
    rows = "".join(f"{x}, {y}, 1.0, 1.0\n" for x, y in corners)
    path.write_text("# x_m, y_m, w_tr_right_m, w_tr_left_m\n" + rows)


def make_later(path):
    """Let a file be of a later time, however coarse the clock of the file system is."""
    os.utime(path, ns=(0, path.stat().st_mtime_ns + 1_000_000_000))


@pytest.fixture
def square(tmp_path):
    """Path of a square map in the form of the F1TENTH community."""
    write_walls(tmp_path / "Square_map.png")
    write_centreline(tmp_path / "Square_centerline.csv", CORNERS)
    place = tmp_path / "Square_map.yaml"
    place.write_text(
        "image: 'Square_map.png'  # the walls\nresolution: 0.1\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n"
    )
    return place


def test_a_map_of_the_community_is_a_place(make, square):
    environment = make(place=square, observation=("course", "pose"))
    observation, _ = environment.reset(seed=1)
    assert observation["pose"][:2] == pytest.approx([2.0, 2.0])
    assert environment.observation_space["course"].high[0] == 24.0


def test_a_changed_centreline_is_seen(make, square):
    make(place=square)
    table = square.with_name("Square_centerline.csv")
    write_centreline(table, [(3, 3), (7, 3), (7, 7), (3, 7)])
    make_later(table)
    assert make(place=square, observation=("course",)).observation_space["course"].high[0] == 16.0
    table.unlink()
    with pytest.raises(ValueError, match="Square_map has no course"):
        make(place=square, observation=("course",))


def test_a_changed_image_is_seen(make, square):
    ahead = []
    for inset in (0, 10):
        image = square.with_name("Square_map.png")
        write_walls(image, inset)
        make_later(image)
        environment = make(place=square, lidar_noise=0.0, beams=3)
        ahead.append(environment.reset(seed=1)[0]["scan"][1])
    assert ahead[0] - ahead[1] == pytest.approx(1.0, abs=0.01)
