import math
import os
import struct
import zlib
from pathlib import Path

import numpy as np
import pytest
from conftest import CAR
from PIL import Image
from shapely.affinity import rotate
from shapely.geometry import Polygon, box
from shapely.ops import unary_union

import f1tenth_sim2d

ROOT = Path(__file__).parents[4]
DATA = Path(os.environ.get("F1TENTH_DATA", ROOT.parent / "shared" / "data"))
TRACKS = sorted([*(ROOT / "data" / "tracks").iterdir(), *(DATA / "tracks").glob("*")])
YAML = """image: room.png
resolution: 0.5
origin: [-1.0, 2.0, 0.0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
"""
ROOM = np.array([[0, 0, 0, 0], [0, 254, 205, 0], [0, 0, 0, 254]], np.uint8)


@pytest.fixture
def write(tmp_path):
    """Return a function that writes the files of a map and returns the path of its YAML file."""

    def write(yaml=YAML, pixels=ROOM, name="room.png", mode=None):
        image = Image.fromarray(pixels)
        (image.convert(mode) if mode else image).save(tmp_path / name)
        path = tmp_path / "room_map.yaml"
        path.write_text(yaml.replace("room.png", name))
        return str(path)

    return write


def area(path, z=0.16):
    """The walls of a world as a shapely geometry: what has matter to its left, less the holes."""
    outlines, circles = f1tenth_sim2d.load_world(path).section(z)
    assert len(circles) == 0
    rings = [Polygon(outline) for outline in outlines]
    solid = unary_union([ring for ring in rings if ring.exterior.is_ccw])
    return solid.difference(unary_union([ring for ring in rings if not ring.exterior.is_ccw]))


def cells(occupied, resolution=0.5, x=-1.0, y=2.0):
    """The occupied cells of an image, top row first, as a shapely geometry."""
    rows = occupied.shape[0]
    squares = [
        box(
            x + column * resolution,
            y + (rows - 1 - row) * resolution,
            x + (column + 1) * resolution,
            y + (rows - row) * resolution,
        )
        for row, column in zip(*np.nonzero(occupied))
    ]
    return unary_union(squares)


def test_occupied_cells_are_walls_along_the_edges_of_the_pixels(write):
    assert area(write()).symmetric_difference(cells(ROOM == 0)).area == pytest.approx(0.0, abs=1e-12)


def test_the_finest_pixels_are_walls_that_a_car_touches(write):
    yaml = YAML.replace("0.5", "0.001").replace("-1.0, 2.0", "0.5, 0.0")
    path = write(yaml, np.zeros((1, 1), np.uint8))
    assert area(path).area == pytest.approx(1e-6, rel=1e-6)
    simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.load_world(path))
    car = f1tenth_sim2d.load_car(CAR.read_text(), "robot1", "car.urdf")
    with pytest.raises(f1tenth_sim2d.Error, match="it overlaps model map::walls$"):
        simulation.add_car(car, x=0.3)
    simulation.add_car(car)


def test_walls_reach_above_every_lidar_and_end(write):
    assert not area(write(), 2.4).is_empty
    assert area(write(), 2.6).is_empty


@pytest.mark.parametrize("seed", range(5))
def test_any_pattern_of_cells_is_kept_exactly(write, seed):
    pixels = np.random.default_rng(seed).choice(np.array([0, 254], np.uint8), (13, 9))
    assert area(write(pixels=pixels)).symmetric_difference(cells(pixels == 0)).area == pytest.approx(
        0, abs=1e-12
    )


@pytest.mark.parametrize("mode", ["1", "L", "LA", "P", "RGB", "RGBA", "I;16"])
def test_every_kind_of_png_reads_the_same(write, mode):
    occupied = ROOM == 0
    if mode == "I;16":
        path = write(pixels=(ROOM.astype(np.uint16) << 8))
    elif mode == "1":
        path = write(pixels=np.where(occupied, 0, 255).astype(np.uint8), mode="1")
    else:
        path = write(yaml=YAML + "mode: scale\n", mode=mode)
    assert area(path).symmetric_difference(cells(occupied)).area == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("kind", ["png", "bmp", "gif", "jpg", "ppm", "tif"])
def test_every_kind_of_image_reads_the_same(write, kind):
    pixels = np.full((24, 32), 254, np.uint8)
    pixels[:8, :16] = 0  # blocks, which JPG keeps
    path = write(pixels=pixels, name=f"room.{kind}", mode="RGB")
    assert area(path).symmetric_difference(cells(pixels == 0)).area == pytest.approx(0.0, abs=1e-12)


def test_alpha_counts_like_a_colour_in_trinary_mode(write):
    yaml = YAML.replace("0.65", "0.8")
    assert area(write(yaml, mode="RGBA")).area == 0.0, "(0 + 0 + 0 + 255) / 4 is bright enough"
    assert area(write(yaml, name="room.tif")).area == 0.0, "map_server's library gives every TIFF an alpha"


OTHER_KEYS = [
    "",
    "mode: scale\n",
    "mode: raw\n",
    "negate: 1\n",
    "negate: '0'\n",
    "negate: true\n",
    "origin: [-1.0, 2.0, 0.7]\n",
    "occupied_thresh: 0.19\nfree_thresh: 0.1\n",
]


@pytest.mark.parametrize("mode", ["L", "P", "RGBA", "I;16"])
@pytest.mark.parametrize("keys", OTHER_KEYS)
def test_cells_are_read_as_the_walls_are(write, mode, keys):
    given = {line.split(":")[0] for line in keys.splitlines()}
    kept = [line for line in YAML.splitlines(keepends=True) if line.split(":")[0] not in given]
    deep = mode == "I;16"
    pixels = np.array([[0, 60, 70, 254], [90, 254, 205, 0], [10, 100, 101, 255]], np.uint8)
    path = write(
        "".join(kept) + keys, pixels.astype(np.uint16) << 8 if deep else pixels, mode=None if deep else mode
    )
    read, resolution, (x, y, yaw) = f1tenth_sim2d.read_map(path)
    assert (read.dtype, read.shape, resolution) == (np.int8, pixels.shape, 0.5)
    assert (x, y, yaw) == (-1.0, 2.0, 0.7 if "origin" in given else 0.0)
    walls = rotate(cells(read[::-1] == 100), math.degrees(yaw), origin=(x, y))
    assert area(path).symmetric_difference(walls).area == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("keys", "expected"),
    [
        ("", [100, -1, -1, 0]),
        ("mode: scale\n", [100, -1, -1, 0]),
        ("mode: raw\n", [-1, -1, -1, -1]),
        ("negate: 1\n", [-1, -1, 100, 100]),
    ],
)
def test_what_is_neither_occupied_nor_free_is_unknown(write, keys, expected):
    yaml = (YAML if "negate" not in keys else YAML.replace("negate: 0\n", "")) + keys
    read, *_ = f1tenth_sim2d.read_map(write(yaml, np.array([[50, 120, 200, 254]], np.uint8)))
    assert read.tolist() == [[*expected]]


def test_raw_values_are_percent(write):
    path = write(YAML + "mode: raw\n", np.array([[0, 19, 20, 65, 66, 100, 101]], np.uint8))
    assert f1tenth_sim2d.read_map(path)[0].tolist() == [[0, 0, -1, -1, 100, 100, -1]]


def pgm(kind, white, values):
    head = f"{kind}\n# made by hand\n{values.shape[1]} {values.shape[0]}\n{white}\n".encode()
    if kind == "P2":
        return head + " ".join(str(value) for value in values.flat).encode()
    return head + values.astype(">u2" if white > 255 else np.uint8).tobytes()


@pytest.mark.parametrize(
    ("kind", "white"), [("P5", 255), ("P2", 255), ("P5", 65535), ("P2", 15), ("P5", 100)]
)
def test_every_kind_of_pgm_reads_the_same(write, tmp_path, kind, white):
    path = write(name="room.pgm")
    (tmp_path / "room.pgm").write_bytes(pgm(kind, white, ROOM.astype(int) * white // 255))
    assert area(path).symmetric_difference(cells(ROOM == 0)).area == pytest.approx(0.0, abs=1e-12)


def test_negate_and_threshold_decide_what_is_occupied(write):
    negated = area(write(YAML.replace("negate: 0", "negate: 1")))
    assert negated.symmetric_difference(cells(ROOM > 0.65 * 255)).area == pytest.approx(0.0, abs=1e-12)
    grey = area(write(YAML.replace("0.196", "0.1").replace("0.65", "0.19")))
    assert grey.symmetric_difference(cells(ROOM < 254)).area == pytest.approx(0.0, abs=1e-12)
    at_threshold = np.where(ROOM == 205, 204, ROOM).astype(np.uint8)  # (255 - 204) / 255 = 0.2
    at = area(write(YAML.replace("0.65", "0.2"), pixels=at_threshold))
    assert at.symmetric_difference(cells(ROOM == 0)).area == pytest.approx(0.0, abs=1e-12)


def test_origin_may_be_turned(write):
    with_four = area(write(YAML.replace("2.0, 0.0]", "2.0, 0.0, 7.0]")))
    assert with_four.equals(area(write())), "what comes after is left aside, as map_server does"
    turned = area(write(YAML.replace("2.0, 0.0]", "2.0, 1.5707963267948966]")))
    assert turned.bounds == pytest.approx((-2.5, 2.0, -1.0, 4.0))


def test_yaw_that_is_more_than_a_turn_is_told(write):
    warnings = [
        f1tenth_sim2d.load_world(write(YAML.replace("2.0, 0.0]", f"2.0, {yaw}]"))).warnings
        for yaw in ("-1.57", "6.28", "90")
    ]
    assert warnings[:2] == [[], []]
    (told,) = warnings[2]
    assert told.endswith("room_map.yaml:3: the yaw of origin is 90 rad, more than a turn")


def test_car_meets_the_walls_it_sees(write, car):
    pixels = np.full((40, 60), 254, np.uint8)
    pixels[:, 50] = 0
    world = f1tenth_sim2d.load_world(write(pixels=pixels))
    simulation = f1tenth_sim2d.Simulation(world)
    simulation.add_car(car, None, 18.0, 10.0, 0.0)
    lidar = car.lidars[0]
    ahead = simulation.scan(0, exact=True)[lidar.beam_count // 2]
    assert 18.0 + lidar.pose[0] + ahead == pytest.approx(24.0, abs=1e-3)
    simulation.command(0, 5.0, 0.0)
    while simulation.time < 3.0:
        simulation.command(0, 5.0, 0.0)
        simulation.step()
    contacts = simulation.contacts(0)
    assert {contact.other_model for contact in contacts} == {"map"}
    assert {contact.other_collision for contact in contacts} == {"map::walls::occupied"}
    assert contacts[0].positions[0][0] == pytest.approx(24.0, abs=0.01)


HEADER, FIRST, SECOND = "# x_m, y_m, w_tr_right_m, w_tr_left_m\n", "1.5, 2.5, 1, 1\n", "1.5, 3.5, 1, 1\n"


@pytest.mark.parametrize(
    "text",
    [
        HEADER + FIRST + SECOND,
        HEADER + FIRST * 3 + SECOND,
        HEADER + FIRST + SECOND + FIRST,
        "\ufeff" + HEADER + FIRST + SECOND,
        "\ufeff" + FIRST + "\n" + SECOND,
        "1.5,2.5\r\n1.5,3.5  # the second\r\n",
    ],
)
def test_start_is_on_the_centreline(write, tmp_path, text):
    path = write()
    assert f1tenth_sim2d.load_world(path).start == (0.0, 0.0, 0.0)
    (tmp_path / "room_centerline.csv").write_text(text, encoding="utf-8", newline="")
    assert f1tenth_sim2d.load_world(path).start == pytest.approx((1.5, 2.5, math.pi / 2))


def test_a_point_of_a_centreline_that_is_repeated_counts_once(tmp_path):
    path = tmp_path / "room_centerline.csv"
    path.write_text("0, 0, 1, 2\n0, 0, 1, 2\n3, 0, 1, 2\n3, 4, 1, 2\n0, 0, 1, 2\n")
    rows = f1tenth_sim2d.read_centreline(path)
    np.testing.assert_array_equal(rows, [[0, 0, 1, 2], [3, 0, 1, 2], [3, 4, 1, 2]])
    path.write_text("0, 0\n3, 0\n")
    np.testing.assert_array_equal(f1tenth_sim2d.read_centreline(path), [[0, 0], [3, 0]])


NO_IMAGE = "is no image that is known here, allowed are PNG, PGM, PPM, PBM, BMP, JPG, TIFF and GIF"
COLUMNS = (
    "allowed is x_m, y_m, w_tr_right_m, w_tr_left_m (or x_m, y_m alone) in every line, finite, with points "
    "in numbers, and widths greater than 0"
)
BROKEN = "image: is broken or ends too early"


def error(path):
    with pytest.raises(f1tenth_sim2d.LoadError) as raised:
        f1tenth_sim2d.load_world(path)
    return str(raised.value).replace(str(Path(path).parent) + "/", "")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("resolution: 0.5\n", "", "room_map.yaml: resolution: is missing"),
        *(
            ("0.5", found, f"room_map.yaml:2: resolution: found '{found}', allowed is 0.001 to 100000 m")
            for found in ("0", ".nan", "0.0009", "1e-300", "1.1e5")
        ),
        *(
            (
                "[-1.0, 2.0, 0.0]",
                found,
                "room_map.yaml:3: origin: found a list of 3, allowed is three numbers: "
                "x and y (m, up to 100000), yaw (rad)",
            )
            for found in ("[1e10, 0, 0]", "[0, -1e300, 0]", "[0, 0, .inf]")
        ),
        (
            "0.5",
            "3e4",
            "room_map.yaml:2: resolution: 4 by 3 pixels of 30000 m do not all lie within 100000 m "
            "of the world's origin",
        ),
        (
            "-1.0",
            "99999",
            "room_map.yaml:2: resolution: 4 by 3 pixels of 0.5 m do not all lie within 100000 m "
            "of the world's origin",
        ),
        (
            "[-1.0, 2.0, 0.0]",
            "[-1.0, 2.0]",
            "room_map.yaml:3: origin: found a list of 2, allowed is three numbers: "
            "x and y (m, up to 100000), yaw (rad)",
        ),
        ("negate: 0", "negate: 2", "room_map.yaml:4: negate: found '2', allowed is 0 or 1"),
        ("0.65", "65", "room_map.yaml:5: occupied_thresh: found '65', allowed is a number from 0 to 1"),
        ("0.196", "-1", "room_map.yaml:6: free_thresh: found '-1', allowed is a number from 0 to 1"),
        (
            "0.196",
            "0.66",
            "room_map.yaml:6: free_thresh: found '0.66', "
            "allowed is a number up to occupied_thresh, which is 0.65",
        ),
        (
            "0.196",
            "0.65\nmode: scale",
            "room_map.yaml:6: free_thresh: found '0.65', "
            "allowed is a number below occupied_thresh, which is 0.65",
        ),
        ("free", "mode: grey\nfree", "room_map.yaml:6: mode: found 'grey', allowed is trinary, scale or raw"),
        (
            "image: room.png",
            "image: []",
            "room_map.yaml:1: image: found a list of 0, allowed is a file name",
        ),
        ("room.png", "none.png", "none.png: no such file, or it cannot be read"),
        (
            "room.png",
            "room_map.yaml",
            f"room_map.yaml: {NO_IMAGE}",
        ),
        ("image: ", "image: [", "room_map.yaml:2: not YAML: end of sequence flow not found"),
        ("negate: 0", "resolution: 5", "room_map.yaml:4: resolution: is given twice, first in line 2"),
    ],
)
def test_mistakes_in_the_yaml_file_are_named(write, tmp_path, old, new, message):
    path = write()
    Path(path).write_text(YAML.replace(old, new, 1))
    assert error(path) == message


def test_folder_in_the_place_of_an_image_is_named(write, tmp_path):
    path = write()
    (tmp_path / "room.png").unlink()
    (tmp_path / "room.png").mkdir()
    assert error(path) == "room.png: is a folder, not a file"


def test_yaml_file_that_is_no_map_is_named(write):
    path = write()
    Path(path).write_text("- a\n- b\n")
    assert error(path) == "room_map.yaml: not a map description, allowed are lines 'key: value'"


def test_suffix_may_be_in_capitals(write, tmp_path):
    shouted = Path(write()).rename(tmp_path / "ROOM.YAML")
    assert area(str(shouted)).symmetric_difference(cells(ROOM == 0)).area == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(
    ("image", "message"),
    [
        (b"P5\n3 3\n255\n12345678", f"PNM {BROKEN}"),
        (b"P2\n3 x\n255\n1 2 3", f"PNM {BROKEN}"),
        (b"P5\n3 3\n0\n123456789", "PNM image: its greatest value is '0', allowed are 1 to 255, and 65535"),
        (
            b"P5\n3 3\n1000\n1234567",
            "PNM image: its greatest value is '1000', allowed are 1 to 255, and 65535",
        ),
        (b"P5\n99999 99999\n255\n", "has 99999 x 99999 pixels, allowed are 1 to 100000000"),
        (b"\x89PNG\r\n\x1a\nnothing of the kind", f"PNG {BROKEN}"),
        (b"GIF89a and what follows", f"GIF {BROKEN}"),
        (b"GIF89a", NO_IMAGE),
    ],
)
def test_broken_images_are_named(write, tmp_path, image, message):
    path = write()
    (tmp_path / "room.png").write_bytes(image)
    assert error(path) == f"room.png: {message}"


@pytest.mark.parametrize("kind", ["png", "bmp", "gif", "pgm", "tif"])
def test_image_that_was_cut_off_is_an_error(write, tmp_path, kind):
    path = write(pixels=np.random.default_rng(0).integers(0, 255, (50, 50), np.uint8), name=f"room.{kind}")
    image = tmp_path / f"room.{kind}"
    image.write_bytes(image.read_bytes()[:-40])
    name = {"tif": "TIFF", "pgm": "PNM"}.get(kind, kind.upper())
    assert error(path) == f"room.{kind}: {name} {BROKEN}"


def test_image_of_a_few_bytes_that_claims_too_many_pixels_is_refused_unread(write, tmp_path):
    header = struct.pack(">IIBBBBB", 15000, 12000, 8, 0, 0, 0, 0)
    chunks = [(b"IHDR", header), (b"IDAT", zlib.compress(b"")), (b"IEND", b"")]
    data = [
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        for kind, body in chunks
    ]
    path = write()
    (tmp_path / "room.png").write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(data))
    assert error(path) == "room.png: has 15000 x 12000 pixels, allowed are 1 to 100000000"


def test_grey_that_is_made_transparent_is_refused(write, tmp_path):
    path = write()
    Image.fromarray(ROOM).save(tmp_path / "room.png", transparency=205)
    assert error(path) == "room.png: PNG image: one of its greys is transparent, allowed is an alpha channel"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("# x_m, y_m\n1.0; 2.0\n", f":2: found '1.0; 2.0', {COLUMNS}"),
        ("0,000; 0,000\n1,000; 0,000\n", f":1: found '0,000; 0,000', {COLUMNS}"),
        ("1.0, 2.0\n1.0, nan\n", f":2: found '1.0, nan', {COLUMNS}"),
        ("1.0, 2.0\n1.0, 3.0, 1, 1\n", f":2: found '1.0, 3.0, 1, 1', {COLUMNS}"),
        ("1.0, 2.0, 1.0\n", f":1: found '1.0, 2.0, 1.0', {COLUMNS}"),
        ("0, 1.0, 2.0, 1, 1\n", f":1: found '0, 1.0, 2.0, 1, 1', {COLUMNS}"),
        ("1.0, 2.0, 1, 0\n", f":1: found '1.0, 2.0, 1, 0', {COLUMNS}"),
        ("1.0, 2.0, -1, 1\n", f":1: found '1.0, 2.0, -1, 1', {COLUMNS}"),
        ("1.0, 2.0\n1.0, 2.0\n", ": has 1 different points, allowed are 2 or more"),
    ],
)
def test_broken_centreline_is_named(write, tmp_path, text, message):
    path = write()
    (tmp_path / "room_centerline.csv").write_text(text)
    assert error(path) == "room_centerline.csv" + message


def test_keys_without_a_meaning_are_said(write):
    warnings = f1tenth_sim2d.load_world(write(YAML + "colour: red\n")).warnings
    assert [warning.split("/")[-1] for warning in warnings] == [
        "room_map.yaml:7: key 'colour' has no meaning"
    ]


def test_empty_world_is_the_ground_and_nothing_on_it(car):
    world = f1tenth_sim2d.empty_world()
    assert world.models == []
    simulation = f1tenth_sim2d.Simulation(world)
    simulation.add_car(car)
    assert np.all(np.isinf(simulation.scan(0)))


@pytest.mark.parametrize("folder", TRACKS, ids=lambda folder: folder.name)
def test_tracks_load_with_their_start(folder, car):
    track = folder.name
    world = f1tenth_sim2d.load_world(str(folder / f"{track}_map.yaml"))
    points = np.loadtxt(folder / f"{track}_centerline.csv", delimiter=",")
    heading = math.atan2(*(points[1, :2] - points[0, :2])[::-1])
    assert world.start == pytest.approx((points[0, 0], points[0, 1], heading))
    simulation = f1tenth_sim2d.Simulation(world)
    simulation.add_car(car, None, *world.start)
    assert simulation.clearance(0) > 0.3
