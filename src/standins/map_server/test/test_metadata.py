import math

import pytest
from map_files import write_description
from map_server.errors import MapMetadataError, MapNotFoundError
from map_server.metadata import REQUIRED_KEYS, read_metadata


def test_reads_every_key(tmp_path):
    metadata = read_metadata(write_description(tmp_path, mode="raw", negate="1"))
    assert metadata.image == tmp_path / "map.png"
    assert metadata.resolution == 0.05
    assert metadata.origin == (-1.0, 2.0, 0.5)
    assert metadata.negate
    assert (metadata.occupied_thresh, metadata.free_thresh) == (0.65, 0.196)
    assert metadata.mode == "raw"


def test_mode_is_trinary_when_not_given(tmp_path):
    assert read_metadata(write_description(tmp_path)).mode == "trinary"


def test_absolute_image_path_is_kept(tmp_path):
    assert str(read_metadata(write_description(tmp_path, image="/maps/a.pgm")).image) == "/maps/a.pgm"


@pytest.mark.parametrize(("text", "value"), [("5e-2", 0.05), ("1", 1.0), ('"0.1"', 0.1), ("010", 10.0)])
def test_number_may_be_written_in_any_usual_way(tmp_path, text, value):
    assert read_metadata(write_description(tmp_path, resolution=text)).resolution == value


@pytest.mark.parametrize(("text", "value"), [("true", True), ("false", False)])
def test_negate_may_be_a_boolean(tmp_path, text, value):
    assert read_metadata(write_description(tmp_path, negate=text)).negate is value


def test_further_numbers_of_the_origin_do_not_count(tmp_path):
    assert read_metadata(write_description(tmp_path, origin="[1, 2, 3, four]")).origin == (1.0, 2.0, 3.0)


def test_tabs_may_stand_after_a_colon(tmp_path):
    metadata = read_metadata(write_description(tmp_path, image="\tfloor.pgm", origin="\t[1,\t2,\t3]"))
    assert (metadata.image.name, metadata.origin) == ("floor.pgm", (1.0, 2.0, 3.0))


def test_first_of_two_equal_keys_and_of_two_documents_counts(tmp_path):
    path = write_description(tmp_path)
    path.write_text(path.read_text() + "resolution: 7\n---\nresolution: 8\n")
    assert read_metadata(path).resolution == 0.05


def test_unknown_keys_are_kept_for_a_warning(tmp_path):
    assert read_metadata(write_description(tmp_path, moed="raw", author="me")).unknown_keys == (
        "author",
        "moed",
    )


def test_thresholds_may_be_equal_in_trinary_mode(tmp_path):
    metadata = read_metadata(write_description(tmp_path, free_thresh="0.5", occupied_thresh="0.5"))
    assert metadata.free_thresh == metadata.occupied_thresh


@pytest.mark.parametrize("key", REQUIRED_KEYS)
def test_missing_key_is_named(tmp_path, key):
    path = write_description(tmp_path, without=[key])
    with pytest.raises(MapMetadataError) as raised:
        read_metadata(path)
    assert str(raised.value) == (
        f"{path}: {key}: missing; "
        "required are image, resolution, origin, negate, occupied_thresh, free_thresh"
    )


METRES = "a number of metres from 1e-06 to 1e+06"
FRACTION = "a number from 0 to 1"
POSE = "three numbers: x, y, yaw"
MODES = "trinary or scale or raw"


@pytest.mark.parametrize(
    ("key", "text", "found", "allowed"),
    [
        ("image", "''", "''", "a file name"),
        ("image", "[a]", "['a']", "a file name"),
        ("resolution", "0", "'0'", METRES),
        ("resolution", "-0.05", "'-0.05'", METRES),
        ("resolution", "1e-7", "'1e-7'", METRES),
        ("resolution", "1e39", "'1e39'", METRES),
        ("resolution", ".nan", "'.nan'", METRES),
        ("resolution", ".inf", "'.inf'", METRES),
        ("resolution", "fine", "'fine'", METRES),
        ("resolution", "1_0", "'1_0'", METRES),
        ("resolution", "true", "'true'", METRES),
        ("resolution", "", "''", METRES),
        ("origin", "[1, 2]", "['1', '2']", POSE),
        ("origin", "[1, 2, [3]]", "['1', '2', None]", POSE),
        ("origin", "{x: 1}", "None", POSE),
        ("origin", "[1, 2, east]", "['1', '2', 'east']", POSE),
        ("origin", "[1, .nan, 3]", "['1', '.nan', '3']", POSE),
        ("origin", "7", "'7'", POSE),
        ("negate", "2", "'2'", "0 or 1"),
        ("negate", "'no'", "'no'", "0 or 1"),
        ("occupied_thresh", "65", "'65'", FRACTION),
        ("occupied_thresh", ".nan", "'.nan'", FRACTION),
        ("free_thresh", "-0.1", "'-0.1'", FRACTION),
        ("free_thresh", "low", "'low'", FRACTION),
        ("mode", "grey", "'grey'", MODES),
        ("mode", "", "''", MODES),
        ("mode", "[raw]", "['raw']", MODES),
    ],
)
def test_wrong_value_is_named_with_what_is_allowed(tmp_path, key, text, found, allowed):
    path = write_description(tmp_path, **{key: text})
    with pytest.raises(MapMetadataError) as raised:
        read_metadata(path)
    assert str(raised.value) == f"{path}: {key}: found {found}, allowed is {allowed}"


def test_thresholds_out_of_order_are_an_error(tmp_path):
    path = write_description(tmp_path, free_thresh="0.7")
    with pytest.raises(MapMetadataError) as raised:
        read_metadata(path)
    assert str(raised.value) == f"{path}: free_thresh: 0.7 is above occupied_thresh 0.65"


def test_equal_thresholds_are_an_error_in_scale_mode(tmp_path):
    path = write_description(tmp_path, free_thresh="0.65", mode="scale")
    with pytest.raises(MapMetadataError) as raised:
        read_metadata(path)
    assert str(raised.value) == f"{path}: free_thresh: must be below occupied_thresh 0.65 in mode scale"


def test_missing_file_is_named(tmp_path):
    with pytest.raises(MapNotFoundError) as raised:
        read_metadata(tmp_path / "no.yaml")
    assert str(raised.value) == f"{tmp_path}/no.yaml: cannot be opened: No such file or directory"


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"image: [", "not a YAML file: while parsing"),
        (b"\xff\xfe", "not a YAML file: not UTF-8 text"),
        (b"", "not a map description: a mapping of keys to values is needed"),
        (b"- 1\n", "not a map description: a mapping of keys to values is needed"),
    ],
)
def test_file_that_is_no_description_is_refused_in_one_line(tmp_path, content, reason):
    path = tmp_path / "map.yaml"
    path.write_bytes(content)
    with pytest.raises(MapMetadataError) as raised:
        read_metadata(path)
    assert str(raised.value).startswith(f"{path}: {reason}")
    assert "\n" not in str(raised.value)


def test_huge_integer_is_a_wrong_value_not_a_crash(tmp_path):
    path = write_description(tmp_path, resolution="1" + "0" * 400)
    with pytest.raises(MapMetadataError, match="resolution: found '10"):
        read_metadata(path)
    assert math.isinf(float("1" + "0" * 400))
