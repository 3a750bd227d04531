"""Poses along a course, and seen from it."""

import numpy as np
import pytest

import f1tenth_sim2d

SQUARE = f1tenth_sim2d.Course(np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]))


def test_its_length_is_that_of_the_closed_line():
    assert SQUARE.length == 16.0


@pytest.mark.parametrize(
    ("distance", "offset", "pose"),
    [
        (1.0, 0.0, (1.0, 0.0, 0.0)),
        (5.0, 0.5, (3.5, 1.0, np.pi / 2)),
        (-1.0, 0.0, (0.0, 1.0, -np.pi / 2)),
        (33.0, -0.25, (1.0, -0.25, 0.0)),
    ],
)
def test_a_pose_along_it(distance, offset, pose):
    assert SQUARE.pose(distance, offset) == pytest.approx(pose)


def test_locating_is_the_inverse():
    rng = np.random.default_rng(2)
    for distance, offset in zip(rng.uniform(0.0, 16.0, 50), rng.uniform(-0.3, 0.3, 50)):
        x, y, yaw = SQUARE.pose(distance, offset)
        found = SQUARE.locate(x, y, yaw + 0.1)
        if min(distance % 4.0, 4.0 - distance % 4.0) > 0.3:
            assert found == pytest.approx((distance, offset, 0.1))


def test_points_of_another_shape_are_refused():
    with pytest.raises(ValueError, match=r"points: allowed is an array of shape \(n, 2\)"):
        f1tenth_sim2d.Course(np.zeros((3, 3)))
