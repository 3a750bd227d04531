"""Poses in the plane."""

from workspace_support import maths

Pose = tuple[float, float, float]
"""x, y (m), yaw (rad)"""


def composed(outer: Pose, inner: Pose) -> Pose:
    """Return the pose `inner`, given in the frame of `outer`, in the frame in which `outer` is given."""
    c, s = maths.cos(outer[2]), maths.sin(outer[2])
    return (
        outer[0] + c * inner[0] - s * inner[1],
        outer[1] + s * inner[0] + c * inner[1],
        outer[2] + inner[2],
    )
