"""What cameras see: where things are, and what they look like."""

import os
import zlib
from pathlib import Path

import numpy as np
import pytest
from f1tenth_sim2d.environments.car import Lidar, load_cars
from f1tenth_sim2d.environments.place import circuits, find_place

import f1tenth_sim2d

CAMERA = "stereo_camera"
TRACKS = Path(os.environ.get("F1TENTH_DATA", "/nowhere")) / "tracks"
MAPS = sorted(TRACKS.glob("*/*_map.yaml"))
# What the left eye sees from the start: crc32 of colours and depths.
# They change with the looks of the places and of the car.
HASHES = {
    "circuit1": "aab44f32 02541f09",
    "circuit2": "7859a7ce 2e8e33d4",
    "circuit3": "bcc2af83 d48efe22",
    "circuit4": "230734a3 46684ba0",
    "circuit5": "a2e8a515 a2b99f02",
    "circuit_detailed": "5a8b1342 a853b52e",
}


@pytest.fixture(scope="module")
def stereo_car():
    return load_cars(["robot1"], Lidar(108, 4.7, 10.0))[0]


def at_start(world, car, **options):
    simulation = f1tenth_sim2d.Simulation(world, **options)
    simulation.add_car(car, None, *world.start)
    return simulation


def in_world(tmp_path, car, models):
    """A simulation of a car in a world of these models."""
    path = tmp_path / "a.world"
    path.write_text(f"<sdf version='1.6'><world name='a'>{models}</world></sdf>")
    return at_start(f1tenth_sim2d.load_world(str(path)), car)


def visual(name, pose, geometry, material="", static=True):
    """A model that is seen and touched as one shape."""
    shape = f"<geometry>{geometry}</geometry>"
    return (
        f"<model name='{name}'><static>{static}</static><pose>{pose}</pose><link name='link'>"
        f"<collision name='c'>{shape}</collision><visual name='v'>{shape}{material}</visual></link></model>"
    )


BOX = "<box><size>1 1 1</size></box>"
RED = "<material><diffuse>1 0 0 1</diffuse></material>"


def ray_depths(simulation, eye):
    """Depths of the level row of an eye by the rays of a lidar."""
    x, y, height, yaw = eye.pose
    angles = np.arctan((eye.middle_x - np.arange(eye.width)) / eye.focal_x)
    ranges = simulation.cast_rays(0, angles, x=x, y=y, height=height, yaw=yaw, range_max=eye.far * 2)
    return ranges * np.cos(angles)


def assert_depths_agree(simulation, poses):
    """The two rows beside the level one show what the rays hit, where they look at the same thing."""
    eye = simulation.car(0).cameras[CAMERA][0]
    compared = 0
    for pose in poses:
        simulation.place_car(0, *pose)
        depth = simulation.look(0, CAMERA)[1].astype(float)
        upper, lower = depth[eye.height // 2 - 1], depth[eye.height // 2]
        rays = ray_depths(simulation, eye)
        both = np.isfinite(upper) & np.isfinite(lower) & (rays < eye.far)
        upper, lower, rays = upper[both], lower[both], rays[both]
        same = np.abs(upper - lower) < 1e-3
        compared += same.sum()
        error = np.abs((upper + lower) / 2 - rays)[same]
        # Round things are drawn with 32 corners.
        assert np.quantile(error, 0.95) < 1e-3, (pose, error.max())
        assert error.max() < 5e-3, pose
    assert compared > 300 * len(poses)


@pytest.mark.parametrize("name", circuits())
def test_depths_are_those_of_the_rays(name, stereo_car):
    world = find_place(name).world
    line = find_place(name).centreline
    simulation = at_start(world, stereo_car)
    yaws = np.arctan2(*np.diff(line[:, :2], axis=0).T[::-1])
    poses = [(*line[i, :2], yaws[i]) for i in np.linspace(0, len(yaws) - 1, 6).astype(int)]
    assert_depths_agree(simulation, poses)


@pytest.mark.skipif(not MAPS, reason="F1TENTH_DATA is not set")
@pytest.mark.parametrize("path", MAPS, ids=[path.stem for path in MAPS])
def test_walls_of_a_map_are_where_its_pixels_are(path, stereo_car):
    world = f1tenth_sim2d.load_world(str(path))
    assert_depths_agree(at_start(world, stereo_car), [world.start])


def test_colours_are_those_of_the_materials(tmp_path, stereo_car):
    simulation = in_world(tmp_path, stereo_car, visual("box", "3 0 0.5 0 0 0", BOX, RED))
    colour, depth = simulation.look(0, CAMERA)
    eye = simulation.car(0).cameras[CAMERA][0]
    assert colour.shape == (376, 672, 3)
    assert colour.dtype == np.uint8
    assert depth[188, 336] == pytest.approx(2.5 - eye.pose[0], abs=1e-4)
    red, green, blue = colour[188, 336]
    assert red > 90
    assert green == blue == 0
    assert np.isinf(depth[0, 336]), "above is the sky"
    assert colour[0, 336, 2] > 150


def test_the_right_eye_sees_less_of_the_right(tmp_path, stereo_car):
    simulation = in_world(tmp_path, stereo_car, visual("box", "3 0 0.5 0 0 0", BOX, RED))
    left, right = (
        np.isfinite(simulation.look(0, CAMERA, eye)[1][188]).nonzero()[0].mean() for eye in ("left", "right")
    )
    eye = simulation.car(0).cameras[CAMERA][0]
    depth = simulation.look(0, CAMERA)[1][188, 336]
    assert left - right == pytest.approx(0.12 * eye.focal_x / depth, abs=1.0)


def test_what_moves_is_seen_where_it_is(tmp_path, stereo_car):
    moving = visual("box", "3 0 0.5 0 0 0", BOX, RED, static=False)
    simulation = in_world(tmp_path, stereo_car, moving)
    near = simulation.look(0, CAMERA)[1][188, 336]
    simulation.place_model("box", 4.0, 0.0, 0.0)
    assert simulation.look(0, CAMERA)[1][188, 336] == pytest.approx(near + 1.0, abs=1e-4)
    simulation.remove_model("box")
    assert np.isinf(simulation.look(0, CAMERA)[1][188, 336])


def test_other_cars_are_seen_with_their_wheels(stereo_car):
    simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.empty_world())
    simulation.add_car(stereo_car)
    alone = simulation.look(0, CAMERA)[0]
    simulation.add_car(load_cars(["robot2"], Lidar(108, 4.7, 10.0))[0], None, 1.5, 0.0, 1.57)
    beside = simulation.look(0, CAMERA)[0]
    assert (alone != beside).any(axis=2).sum() > 3000
    simulation.command(1, 0.0, 0.4)
    simulation.advance_to(0.5)
    steered = simulation.look(0, CAMERA)[0]
    assert (steered != beside).any(axis=2).sum() > 20


@pytest.mark.parametrize(
    ("geometry", "material", "words"),
    [
        ("<mesh><uri>missing.dae</uri></mesh>", "", "missing.dae is not found"),
        ("<box><size>1 1</size></box>", "", "<size>"),
        ("", "", "is empty"),
        ("<heightmap/>", "", "is not supported"),
        (BOX, "<material><script><name>Other/Blue</name></script></material>", "no material Other/Blue"),
        (BOX, "<material><diffuse>red</diffuse></material>", "'red' is no colour"),
        (
            BOX,
            "<material><pbr><metal><albedo_map>broken.png</albedo_map></metal></pbr></material>",
            "broken.png: PNG image: is broken",
        ),
    ],
)
def test_what_cannot_be_drawn_is_one_warning(geometry, material, words, tmp_path, stereo_car):
    (tmp_path / "broken.png").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(50))
    seen = f"<visual name='v'><geometry>{geometry}</geometry>{material}</visual>"
    model = (
        f"<model name='m'><static>1</static><pose>3 0 0.5 0 0 0</pose><link name='l'>{seen}</link></model>"
    )
    simulation = in_world(tmp_path, stereo_car, model)
    colour, _ = simulation.look(0, CAMERA)
    assert colour.any()
    assert words in simulation.view_warning
    assert "a.world" in simulation.view_warning


def test_textures_are_read(tmp_path, stereo_car):
    from PIL import Image

    pixels = np.zeros((2, 2, 3), np.uint8)
    pixels[:, 0], pixels[:, 1] = (0, 255, 0), (0, 0, 255)
    Image.fromarray(pixels).save(tmp_path / "halves.png")
    (tmp_path / "own.material").write_text(
        "material Own/Halves\n{\n technique {\n  pass {\n texture_unit {\n texture halves.png\n } } } }\n"
    )
    script = "<script><uri>own.material</uri><name>Own/Halves</name></script>"
    simulation = in_world(
        tmp_path, stereo_car, visual("box", "3 0 0.5 0 0 0", BOX, f"<material>{script}</material>")
    )
    colour, depth = simulation.look(0, CAMERA)
    assert simulation.view_warning == ""
    on_box = colour[188][np.isfinite(depth[188])].astype(int)
    left, right = on_box[len(on_box) // 4], on_box[3 * len(on_box) // 4]
    assert left[1] > 2 * left[2]
    assert right[2] > 2 * right[1]


def board(tmp_path, stereo_car, library):
    """The colour in the middle of a board, 3 m ahead, of an OBJ file whose materials are in this library."""
    (tmp_path / "board.obj").write_text(
        f"mtllib {library}\nv 0 -1 -1\nv 0 1 -1\nv 0 1 1\nv 0 -1 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
        "usemtl paint\nf 4/4 3/3 2/2 1/1\n"
    )
    mesh = "<mesh><uri>board.obj</uri></mesh>"
    simulation = in_world(tmp_path, stereo_car, visual("board", "3 0 0 0 0 0", mesh))
    return simulation.look(0, CAMERA)[0][150, 336].astype(int), simulation.view_warning


def test_materials_beside_a_mesh_are_read(tmp_path, stereo_car):
    from PIL import Image

    (tmp_path / "materials").mkdir()
    Image.new("RGB", (2, 2), (0, 0, 255)).save(tmp_path / "materials" / "blue.png")
    (tmp_path / "red.mtl").write_text("newmtl paint\nKd 1 0 0\n")
    (tmp_path / "materials" / "blue.mtl").write_text("newmtl paint\nKd 1 1 1\nmap_Kd materials/blue.png\n")
    for library, strongest in (("red.mtl", 0), ("materials/blue.mtl", 2)):
        colour, warning = board(tmp_path, stereo_car, library)
        assert warning == ""
        assert colour[strongest] > 3 * np.delete(colour, strongest).max()
    colour, warning = board(tmp_path, stereo_car, "lost.mtl")
    assert "lost.mtl, which" in warning
    assert colour.max() < 1.5 * colour.min()


def test_a_script_that_has_changed_is_read_again(tmp_path, stereo_car):
    script = "<material><script><uri>own.material</uri><name>Own</name></script></material>"
    for time, colour in enumerate(("1 0 0", "0 1 0")):
        file = tmp_path / "own.material"
        file.write_text(f"material Own\n{{\n technique {{\n  pass {{\n diffuse {colour} 1\n }} }} }}\n")
        os.utime(file, (time, time))
        simulation = in_world(tmp_path, stereo_car, visual("box", "3 0 0.5 0 0 0", BOX, script))
        red, green, _ = simulation.look(0, CAMERA)[0][188, 336]
        assert (red > 90, green > 90) == (time == 0, time == 1)


def test_a_plane_faces_its_normal(tmp_path, stereo_car):
    plane = "<plane><normal>-1 0 0</normal><size>1 0.4</size></plane>"
    simulation = in_world(tmp_path, stereo_car, visual("plane", "3 0 0.1 0 0 0", plane, RED))
    eye = simulation.car(0).cameras[CAMERA][0]
    depth = simulation.look(0, CAMERA)[1][188]
    seen = depth[np.isfinite(depth)]
    assert seen == pytest.approx(3.0 - eye.pose[0], abs=1e-4)
    assert len(seen) == pytest.approx(0.4 * eye.focal_x / seen[0], abs=1.0)


def test_the_car_and_all_places_are_drawn_whole(stereo_car):
    for name in circuits():
        assert at_start(find_place(name).world, stereo_car).view_warning == ""


@pytest.mark.parametrize("name", circuits())
def test_pictures_have_the_same_bits_everywhere(name, stereo_car):
    colour, depth = at_start(find_place(name).world, stereo_car).look(0, CAMERA)
    assert f"{zlib.crc32(colour.tobytes()):08x} {zlib.crc32(depth.tobytes()):08x}" == HASHES[name]


def test_unknown_cameras_are_named(simulation, stereo_car):
    with pytest.raises(ValueError, match="camera: found 'eye', allowed are camera"):
        simulation.look(0, "eye")
    stereo = f1tenth_sim2d.Simulation(f1tenth_sim2d.empty_world())
    stereo.add_car(stereo_car)
    with pytest.raises(f1tenth_sim2d.Error, match="no eye 'third', there are: left, right"):
        stereo.look(0, CAMERA, "third")
