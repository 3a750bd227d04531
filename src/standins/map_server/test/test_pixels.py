import numpy as np
import pytest
from map_files import write_description, write_map
from map_server.errors import MapImageError
from map_server.metadata import read_metadata
from map_server.pixels import read_cells
from PIL import Image


def cells_of(image, folder, **changes):
    image.save(folder / "map.png")
    return read_cells(read_metadata(write_description(folder, **changes))).tolist()


def test_bottom_row_of_the_image_is_row_0(tmp_path):
    assert read_cells(read_metadata(write_map(tmp_path, [[254, 0], [205, 254]]))).tolist() == [
        [-1, 0],
        [0, 100],
    ]


@pytest.mark.parametrize("name", ["map.pgm", "map.png", "map.bmp"])
def test_usual_image_formats_are_read(tmp_path, name):
    Image.fromarray(np.array([[254, 0, 205]], dtype=np.uint8)).save(tmp_path / name)
    metadata = read_metadata(write_description(tmp_path, image=name))
    assert read_cells(metadata).tolist() == [[0, 100, -1]]


def test_plain_text_pgm_with_comment_and_small_range_is_read(tmp_path):
    (tmp_path / "map.pgm").write_text("P2\n# drawn by hand\n3 1\n5\n5 0 4\n")
    metadata = read_metadata(write_description(tmp_path, image="map.pgm", mode="raw"))
    assert np.uint8(read_cells(metadata)).tolist() == [[255, 0, 204]]


def test_small_range_of_a_pgm_is_truncated_to_255_levels(tmp_path):
    (tmp_path / "map.pgm").write_bytes(b"P5\n3 1\n100\n" + bytes([100, 77, 1]))
    metadata = read_metadata(write_description(tmp_path, image="map.pgm", mode="raw"))
    assert np.uint8(read_cells(metadata)).tolist() == [[255, 196, 2]]


@pytest.mark.parametrize("kind", ["L", "RGB"])
def test_tiff_has_an_alpha_channel_that_counts_in_trinary_mode(kind, tmp_path):
    Image.fromarray(np.array([[205, 0]], dtype=np.uint8)).convert(kind).save(tmp_path / "map.tif")
    assert read_cells(read_metadata(write_description(tmp_path, image="map.tif"))).tolist() == [[0, 100]]


def test_brightness_is_the_mean_of_the_colours(tmp_path):
    image = Image.fromarray(np.array([[[10, 20, 31]]], dtype=np.uint8))
    assert cells_of(image, tmp_path, mode="raw") == [[20]]


def rgba(*pixels):
    return Image.fromarray(np.array([pixels], dtype=np.uint8), "RGBA")


def test_alpha_counts_like_a_colour_in_trinary_mode(tmp_path):
    assert cells_of(rgba((0, 0, 0, 255), (0, 0, 0, 0)), tmp_path, occupied_thresh="0.9") == [[-1, 100]]


def test_alpha_does_not_count_in_the_other_modes(tmp_path):
    assert cells_of(rgba((90, 90, 90, 255), (90, 90, 90, 7)), tmp_path, mode="raw") == [[90, 90]]


def test_transparent_pixels_between_the_thresholds_are_unknown_in_scale_mode(tmp_path):
    image = rgba((128, 128, 128, 0), (128, 128, 128, 1), (255, 255, 255, 0), (0, 0, 0, 0))
    assert cells_of(image, tmp_path, mode="scale") == [[-1, 66, 0, 100]]


def test_grey_with_alpha_is_read_as_colour_with_alpha(tmp_path):
    image = Image.fromarray(np.array([[[60, 255]]], dtype=np.uint8), "LA")
    assert cells_of(image, tmp_path, mode="raw") == [[60]]


def test_palette_image_means_its_colours(tmp_path):
    image = Image.new("P", (2, 1))
    image.putpalette([254, 254, 254, 0, 0, 0])
    image.putpixel((1, 0), 1)
    assert cells_of(image, tmp_path) == [[0, 100]]


def test_palette_image_may_have_a_transparent_entry(tmp_path):
    image = Image.new("P", (1, 1))
    image.putpalette([128, 128, 128])
    image.save(tmp_path / "map.png", transparency=0)
    assert read_cells(read_metadata(write_description(tmp_path, mode="scale"))).tolist() == [[-1]]


def test_black_and_white_image_is_read(tmp_path):
    assert cells_of(Image.fromarray(np.array([[255, 0]], dtype=np.uint8)).convert("1"), tmp_path) == [
        [0, 100]
    ]


def test_sixteen_bits_count_by_their_high_byte(tmp_path):
    image = Image.fromarray(np.array([[0x64FF, 0x00FF]], dtype=np.uint16))
    assert cells_of(image, tmp_path, mode="raw") == [[100, 0]]


def error_of(folder, **changes):
    with pytest.raises(MapImageError) as raised:
        read_cells(read_metadata(write_description(folder, **changes)))
    return str(raised.value)


def test_missing_image_is_named(tmp_path):
    assert error_of(tmp_path) == f"{tmp_path}/map.png: image: cannot be read: No such file or directory"


def test_folder_in_the_place_of_the_image_is_named(tmp_path):
    assert error_of(tmp_path, image=".") == f"{tmp_path}: image: cannot be read: Is a directory"


def test_file_that_is_no_image_is_named(tmp_path):
    (tmp_path / "map.png").write_text("no image")
    assert error_of(tmp_path) == f"{tmp_path}/map.png: image: not an image file (PGM and PNG are usual)"


@pytest.mark.parametrize("name", ["map.png", "map.pgm"])
def test_truncated_image_is_named(tmp_path, name):
    path = tmp_path / name
    noise = np.random.default_rng(1).integers(0, 255, (60, 60), dtype=np.uint8)
    Image.fromarray(noise).save(path)
    path.write_bytes(path.read_bytes()[:900])
    assert error_of(tmp_path, image=name).startswith(f"{path}: image: cannot be read: ")


def test_image_with_floating_point_pixels_is_refused(tmp_path):
    Image.fromarray(np.zeros((1, 1), dtype=np.float32)).save(tmp_path / "map.tif")
    assert error_of(tmp_path, image="map.tif") == (
        f"{tmp_path}/map.tif: image: pixels of kind F, allowed are grey and RGB, with or without alpha"
    )


def test_map_of_16_million_cells_is_read(tmp_path):
    pixels = np.full((4000, 4000), 254, dtype=np.uint8)
    pixels[0, 0] = 0
    cells = read_cells(read_metadata(write_map(tmp_path, pixels)))
    assert cells.shape == (4000, 4000)
    assert cells[-1, 0] == 100
    assert cells.sum() == 100
