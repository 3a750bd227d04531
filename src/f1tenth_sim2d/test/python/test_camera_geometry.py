"""Pictures are those of a calibrated stereo camera: computer vision finds in them where things are."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest
from f1tenth_sim2d.environments.car import Lidar, load_cars
from f1tenth_sim2d.environments.place import find_place

import f1tenth_sim2d

CAMERA = "stereo_camera"
BOX = (3.0, 0.2, 0.4)  # m, its middle
SIDES = (0.5, 1.2, 0.7)  # m: neither its top nor its bottom is seen
NEAR_FACE = [(BOX[0] - SIDES[0] / 2, BOX[1] + y * SIDES[1] / 2) for y in (1, -1)]


@pytest.fixture(scope="module")
def stereo_car():
    return load_cars(["robot1"], Lidar(108, 4.7, 10.0))[0]


def projected(eye, pose, point):
    """Pixels of a point of the world (m), column and row."""
    x, y, yaw = pose
    ahead, left = np.array([[np.cos(yaw), np.sin(yaw)], [-np.sin(yaw), np.cos(yaw)]]) @ (
        np.array(point[:2]) - (x, y)
    )
    depth = ahead - eye.pose[0]
    return (
        eye.middle_x - eye.focal_x * (left - eye.pose[1]) / depth,
        eye.middle_y - eye.focal_y * (point[2] - eye.pose[2]) / depth,
    )


def seen_corners(is_there):
    """Pixels of the four corners of a wall with upright edges, by lines along its edges."""
    columns = np.flatnonzero(is_there.any(axis=0))
    inner = columns[3:-3]
    edges = [
        np.polyfit(inner, is_there[:, inner].argmax(axis=0) - 0.5, 1),
        np.polyfit(inner, len(is_there) - 0.5 - is_there[::-1, inner].argmax(axis=0), 1),
    ]
    return [
        (column, np.polyval(edge, column))
        for column in (columns[0] - 0.5, columns[-1] + 0.5)
        for edge in edges
    ]


@pytest.mark.parametrize("eye", ["left", "right"])
@pytest.mark.parametrize("pose", [(0.0, 0.0, 0.0), (0.5, 0.6, -0.25), (-1.0, -0.4, 0.2), (1.2, 0.1, 0.05)])
def test_corners_are_projected_to_within_half_a_pixel(pose, eye, tmp_path, stereo_car):
    shape = f"<geometry><box><size>{' '.join(map(str, SIDES))}</size></box></geometry>"
    path = tmp_path / "a.world"
    path.write_text(
        "<sdf version='1.6'><world name='a'><model name='m'><static>1</static>"
        f"<pose>{' '.join(map(str, BOX))} 0 0 0</pose><link name='l'><visual name='v'>{shape}</visual></link>"
        "</model></world></sdf>"
    )
    simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.load_world(str(path)))
    simulation.add_car(stereo_car, None, *pose)
    seen = simulation.look(0, CAMERA, eye)[1]
    # Neither the car itself nor the sides of the box.
    face = (seen > 0.5) & (seen < farthest(stereo_car, pose))
    (eye_seen,) = [each for each in stereo_car.cameras[CAMERA] if each.name == eye]
    heights = (BOX[2] + SIDES[2] / 2, BOX[2] - SIDES[2] / 2)
    expected = [projected(eye_seen, pose, (*corner, height)) for corner in NEAR_FACE for height in heights]
    assert np.abs(np.array(seen_corners(face)) - expected).max() < 0.5


def farthest(car, pose):
    """m, depth of the farther edge of the near face, and a little."""
    eye = car.cameras[CAMERA][0]
    x, y, yaw = pose
    return max((px - x) * np.cos(yaw) + (py - y) * np.sin(yaw) for px, py in NEAR_FACE) - eye.pose[0] + 1e-3


def test_opencv_measures_the_depths_by_stereo(stereo_car):
    cv2 = pytest.importorskip("cv2", reason="python3-opencv is not installed")
    place = find_place("circuit_detailed")
    simulation = f1tenth_sim2d.Simulation(place.world)
    simulation.add_car(stereo_car, None, *place.world.start)
    left_eye, right_eye = stereo_car.cameras[CAMERA]
    baseline = left_eye.pose[1] - right_eye.pose[1]
    matcher = cv2.StereoBM_create(numDisparities=128, blockSize=15)
    line = place.centreline[:, :2]
    for i in np.linspace(0, len(line) - 2, 5).astype(int):
        simulation.place_car(0, *line[i], float(np.arctan2(*(line[i + 1] - line[i])[::-1])))
        (left, depth), (right, _) = (simulation.look(0, CAMERA, eye) for eye in ("left", "right"))
        grey = [cv2.cvtColor(each, cv2.COLOR_RGB2GRAY) for each in (left, right)]
        found = matcher.compute(*grey) / 16.0  # pixels
        true = left_eye.focal_x * baseline / depth
        is_found = (found > 0) & np.isfinite(depth)
        error = np.abs(found - true)[is_found]
        assert is_found.mean() > 0.1
        assert np.median(error) < 0.25
        assert (error < 1.0).mean() > 0.8


STEP = 0.1  # m, between two pictures: 30 Hz at 3 m/s


def test_the_example_of_visual_odometry_hardly_drifts(stereo_car):
    cv2 = pytest.importorskip("cv2", reason="python3-opencv is not installed")
    pytest.importorskip("rospy", reason="the example is a node of ROS")
    cv2.setRNGSeed(1)
    example = Path(__file__).parents[2] / "examples" / "stereo_odometry.py"
    spec = importlib.util.spec_from_file_location(example.stem, example)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    place = find_place("circuit_detailed")
    left, right = stereo_car.cameras[CAMERA]
    middle = left.middle_x, left.middle_y
    odometry = module.StereoOdometry(left.focal_x, middle, left.pose[1] - right.pose[1])
    simulation = f1tenth_sim2d.Simulation(place.world)
    poses = along(place.centreline[:, :2])[:60]
    simulation.add_car(stereo_car, None, *poses[0])
    for pose in poses:
        simulation.place_car(0, *map(float, pose))
        odometry.take(*(simulation.look(0, CAMERA, eye)[0] for eye in ("left", "right")))
    begin, end = (pose[:2] + turned(pose[2], *left.pose[:2]) for pose in (poses[0], poses[-1]))
    ahead, to_right = odometry.pose[[2, 0], 3]
    found = begin + turned(poses[0][2], ahead, -to_right)
    assert np.hypot(*(found - end)) < 0.02 * STEP * len(poses)


def along(line):
    """Poses (x, y, yaw) along a closed line, STEP apart."""
    ends = np.vstack([line, line[:1]])
    way = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(ends, axis=0).T))])
    at = np.arange(0.0, way[-1], STEP)
    x, y = (np.interp(at, way, ends[:, i]) for i in (0, 1))
    ahead = [np.interp((at + 0.3) % way[-1], way, ends[:, i]) for i in (0, 1)]
    return np.column_stack([x, y, np.arctan2(ahead[1] - y, ahead[0] - x)])


def turned(yaw, ahead, left):
    """A vector in the world."""
    return np.array([np.cos(yaw) * ahead - np.sin(yaw) * left, np.sin(yaw) * ahead + np.cos(yaw) * left])
