"""The section that a lidar sees of a mesh against an independent slice of the same file."""

import os
from pathlib import Path

import numpy as np
import pytest
from mesh_slices import placed, slice_at, triangles_of
from shapely.geometry import MultiLineString, MultiPoint

import f1tenth_sim2d

ROOT = Path(__file__).parents[4]
DATA = Path(os.environ.get("F1TENTH_DATA", ROOT.parent / "shared" / "data"))
MESHES = {
    "our_cone": ("cone/meshes/cone.stl", 2.0),
    "cafe_table": ("gazebo_models/cafe_table/meshes/cafe_table.dae", 1.0),
    "cardboard_box": ("gazebo_models/cardboard_box/meshes/cardboard_box.dae", 1.25),
    "construction_cone": ("gazebo_models/construction_cone/meshes/construction_cone.dae", 10.0),
    "cube_20k": ("gazebo_models/cube_20k/meshes/cube_20k.stl", 0.5),
    "jersey_barrier": ("gazebo_models/jersey_barrier/meshes/jersey_barrier.dae", 1.0),
    "racecar_cone": ("worlds/racecar_description/meshes/cone.dae", 1.0),
}
POSES = [((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)), ((1.0, -2.0, 0.1), (0.4, -0.3, 2.0))]
FOLDERS = (ROOT / "data" / "gazebo_models", DATA)
FOUND = {
    name: (folder / file, scale)
    for name, (file, scale) in MESHES.items()
    for folder in FOLDERS
    if (folder / file).exists()
}
TOLERANCE = 1e-6  # m; mesh files are read in single precision


def load_mesh(folder, path, scale, xyz, rpy):
    pose = " ".join(map(str, (*xyz, *rpy)))
    mesh = f"<mesh><uri>file://{path}</uri><scale>{scale} {scale} {scale}</scale></mesh>"
    link = f"<link name='l'><collision name='c'><geometry>{mesh}</geometry></collision></link>"
    model = f"<model name='m'><static>true</static><pose>{pose}</pose>{link}</model>"
    world = folder / "mesh.world"
    world.write_text(f"<sdf version='1.6'><world name='w'>{model}</world></sdf>")
    return f1tenth_sim2d.load_world(str(world), [])


def heights_within(triangles):
    low, high = triangles[:, :, 2].min(), triangles[:, :, 2].max()
    # Not at the heights of the corners, where a slice may be a line or an area.
    return low + (high - low) * np.array([0.0137, 0.213, 0.4987, 0.811, 0.9871])


@pytest.mark.parametrize("pose", POSES, ids=["upright", "tilted"])
@pytest.mark.parametrize("name", FOUND)
def test_section_is_the_slice_of_the_mesh(name, pose, tmp_path):
    file, scale = FOUND[name]
    world = load_mesh(tmp_path, file, scale, *pose)
    triangles = placed(triangles_of(file), scale, *pose)
    for z in heights_within(triangles):
        outlines, circles = world.section(float(z))
        seen = MultiLineString([np.vstack([outline, outline[:1]]) for outline in outlines])
        sliced = MultiLineString(list(slice_at(triangles, z)))
        assert len(circles) == 0
        assert seen.length > 0.0
        assert _farthest_corner(seen, sliced) < TOLERANCE
        assert _farthest_corner(sliced, seen) < TOLERANCE


def _farthest_corner(lines, others):
    corners = MultiPoint([corner for line in lines.geoms for corner in line.coords])
    return max(others.distance(corner) for corner in corners.geoms)


CORNERS = [(x, y, z) for z in (0, 1) for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))]
SIDES = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
FACES = [(3, 2, 1, 0), (4, 5, 6, 7), *SIDES]


def obj_of(faces):
    corners = [f"v {x} {y} {z}" for x, y, z in CORNERS]
    return "\n".join([*corners, *("f " + " ".join(str(corner + 1) for corner in face) for face in faces), ""])


def turned(faces, which):
    return [face[::-1] if i in which else face for i, face in enumerate(faces)]


@pytest.mark.parametrize("which", [(), range(6), (0, 3), (2, 3, 4), (2, 3, 4, 5)], ids=str)
def test_lidar_sees_the_near_face_of_a_box_whichever_way_its_faces_are_turned(which, car, tmp_path):
    (tmp_path / "box.obj").write_text(obj_of(turned(FACES, which)))
    world = load_mesh(tmp_path, tmp_path / "box.obj", 1.0, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    simulation = f1tenth_sim2d.Simulation(world)
    simulation.add_car(car, None, -5.0, -5.0, 0.0)
    for angle in np.deg2rad([0.0, 90.0, 180.0, 270.0]):
        x = 5.0 - 5.0 * np.cos(angle) - 0.2 * np.sin(angle)  # in the frame of the car
        y = 5.0 - 5.0 * np.sin(angle) + 0.2 * np.cos(angle)
        [distance] = simulation.cast_rays(0, [angle], x=x, y=y, height=0.4, range_max=100.0)
        assert distance == pytest.approx(4.5, abs=1e-4)
