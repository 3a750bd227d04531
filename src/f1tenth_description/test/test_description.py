"""The robot description must be well-formed and its outline the bumpers'."""

import math
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

XACRO_FILE = Path(__file__).parent.parent / "urdf" / "f1tenth.urdf.xacro"
LENGTH, WIDTH = 0.58, 0.31
BUMPERS = ("bumper_front", "bumper_rear", "bumper_left", "bumper_right")


@pytest.fixture(scope="module")
def urdf_file(tmp_path_factory):
    path = tmp_path_factory.mktemp("urdf") / "f1tenth.urdf"
    subprocess.run(["rosrun", "xacro", "xacro", XACRO_FILE, "-o", path], check=True)
    return path


@pytest.fixture(scope="module")
def robot(urdf_file):
    return ElementTree.parse(urdf_file).getroot()


def vector(element, attribute):
    return [float(value) for value in element.get(attribute, "0 0 0").split()]


def position_in_base_footprint(robot, link):
    """Sum of the joints' offsets: no joint above a collision of this car is turned."""
    position = [0.0, 0.0, 0.0]
    while link != "base_footprint":
        joint = next(j for j in robot.iter("joint") if j.find("child").get("link") == link)
        position = [a + b for a, b in zip(position, vector(joint.find("origin"), "xyz"))]
        link = joint.find("parent").get("link")
    return position


def box_span(robot, link):
    """Least and greatest x and y of a link's collision box."""
    size = vector(robot.find(f"link[@name='{link}']/collision/geometry/box"), "size")
    centre = position_in_base_footprint(robot, link)
    return [(centre[i] - size[i] / 2, centre[i] + size[i] / 2) for i in (0, 1)]


def test_check_urdf_finds_nothing_wrong(urdf_file):
    result = subprocess.run(["check_urdf", urdf_file], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr


def test_frames_that_users_rely_on_exist(robot):
    links = {link.get("name") for link in robot.iter("link")}
    assert links >= {"base_footprint", "base_link", "laser", "imu", "camera_link", *BUMPERS}
    assert not [name for name in links if "/" in name]


def test_base_link_is_at_axle_height(robot):
    assert position_in_base_footprint(robot, "base_link") == pytest.approx([0, 0, 0.0508])
    assert position_in_base_footprint(robot, "rear_left_wheel")[0] == pytest.approx(0)


def test_outline_is_the_published_one_around_the_centre_of_mass(robot):
    spans = [box_span(robot, bumper) for bumper in BUMPERS]
    low = [min(span[axis][0] for span in spans) for axis in (0, 1)]
    high = [max(span[axis][1] for span in spans) for axis in (0, 1)]
    assert [high[0] - low[0], high[1] - low[1]] == pytest.approx([LENGTH, WIDTH])
    assert (high[0] + low[0]) / 2 == pytest.approx(0.17145)


def test_bumpers_leave_no_gap_at_the_corners(robot):
    spans = {bumper: box_span(robot, bumper) for bumper in BUMPERS}
    for end in ("bumper_front", "bumper_rear"):
        for side in ("bumper_left", "bumper_right"):
            for axis in (0, 1):
                (low_a, high_a), (low_b, high_b) = spans[end][axis], spans[side][axis]
                assert min(high_a, high_b) > max(low_a, low_b)


def test_a_flat_wall_touches_one_bumper_only(robot):
    spans = {bumper: box_span(robot, bumper) for bumper in BUMPERS}
    assert spans["bumper_front"][0][1] > spans["bumper_left"][0][1] + 0.004
    assert spans["bumper_rear"][0][0] < spans["bumper_left"][0][0] - 0.004
    assert spans["bumper_left"][1][1] > spans["bumper_front"][1][1] + 0.004
    assert spans["bumper_right"][1][0] < spans["bumper_front"][1][0] - 0.004


def test_wheels_stay_inside_the_bumpers_at_full_lock(robot):
    cylinder = robot.find("link[@name='front_left_wheel']/collision/geometry/cylinder")
    radius, width = float(cylinder.get("radius")), float(cylinder.get("length"))
    joint = robot.find("joint[@name='front_left_steering_joint']")
    lock = float(joint.find("limit").get("upper"))
    half_x = radius * math.cos(lock) + width / 2 * math.sin(lock)
    half_y = radius * math.sin(lock) + width / 2 * math.cos(lock)
    x, y, _ = position_in_base_footprint(robot, "front_left_wheel")
    assert x + half_x < box_span(robot, "bumper_front")[0][0]
    assert y + half_y < box_span(robot, "bumper_left")[1][0]


def test_nothing_of_the_car_is_at_the_height_of_the_lidar_but_itself(robot):
    height = position_in_base_footprint(robot, "laser")[2]
    for link in robot.iter("link"):
        collision = link.find("collision")
        if collision is None or link.get("name") == "laser":
            continue
        origin = collision.find("origin")
        z = position_in_base_footprint(robot, link.get("name"))[2]
        z += 0 if origin is None else vector(origin, "xyz")[2]
        box, cylinder = collision.find("geometry/box"), collision.find("geometry/cylinder")
        half = vector(box, "size")[2] / 2 if box is not None else float(cylinder.get("radius"))
        assert z + half < height - 0.01, link.get("name")
