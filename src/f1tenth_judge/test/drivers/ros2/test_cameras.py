"""Where the cameras of a car are, to a planner of ROS 2."""

import math
from types import SimpleNamespace

import pytest
from f1tenth_judge.drivers.ros2.cameras import Cameras
from f1tenth_judge.planner import Eye


def eye(camera, name, yaw):
    return Eye(camera, name, 4, 3, 2.0, 2.0, 1.5, 1.0, (0.3, 0.06, 0.1, yaw))


def test_eyes_look_along_z_of_their_frames():
    eyes = [eye("stereo", "left", 0.0), eye("stereo", "right", 0.0), eye("side", "eye", math.pi / 2)]
    offered = []
    connection = SimpleNamespace(offer=lambda topic, kind, qos: offered.append(topic))
    transforms = Cameras(connection, SimpleNamespace(eyes=lambda car: eyes), "robot1").transforms()
    assert [each.child_frame_id for each in transforms] == [
        "ego_racecar/stereo/left",
        "ego_racecar/stereo/right",
        "ego_racecar/side",
    ]
    assert {"/stereo/left/image_raw", "/side/depth/image_raw", "/side/camera_info"} <= set(offered)
    for each, along in zip(transforms, ([1, 0, 0], [1, 0, 0], [0, 1, 0])):
        turn = each.transform.rotation
        z = (
            2 * (turn.x * turn.z + turn.w * turn.y),
            2 * (turn.y * turn.z - turn.w * turn.x),
            1 - 2 * (turn.x**2 + turn.y**2),
        )
        assert z == pytest.approx(along)
    left = transforms[0].transform
    assert (left.translation.x, left.translation.y, left.translation.z) == (0.3, 0.06, 0.1)
    assert (left.rotation.x, left.rotation.w) == (-0.5, 0.5)
