"""A loop that the lidar has driven must be closed: seen through the Python module gmapping_core."""

import math

import gmapping_core
import numpy as np
import pytest

BEAMS = np.linspace(-math.pi, math.pi, 541)
# A ring road of 2 m about a block, with a pillar in its upper left corner. Walls are (x, y) -> (x, y), m.
CORNERS = {
    "outside": (-6.0, -4.0, 6.0, 4.0),
    "block": (-4.0, -2.0, 4.0, 2.0),
    "pillar": (-5.9, 3.4, -5.4, 3.9),
}

DRIFT = 0.001
"""rad per m"""


def walls():
    for x1, y1, x2, y2 in CORNERS.values():
        corners = [(x1, y1), (x2, y1), (x2, y2), (x1, y2)]
        yield from zip(corners, corners[1:] + corners[:1])


def scan(pose):
    """Ranges that a lidar at a pose sees, without noise."""
    x, y, yaw = pose
    along = np.column_stack([np.cos(BEAMS + yaw), np.sin(BEAMS + yaw)])
    nearest = np.full(len(BEAMS), np.inf)
    for (ax, ay), (bx, by) in walls():
        wall = np.array([bx - ax, by - ay])
        start = np.array([ax - x, ay - y])
        with np.errstate(divide="ignore", invalid="ignore"):
            cross = along[:, 0] * wall[1] - along[:, 1] * wall[0]
            distance = (start[0] * wall[1] - start[1] * wall[0]) / cross
            place = (start[0] * along[:, 1] - start[1] * along[:, 0]) / cross
        hit = (distance > 0.0) & (place >= 0.0) & (place <= 1.0)
        nearest = np.where(hit, np.minimum(nearest, distance), nearest)
    return nearest


def drive(laps, step=0.1):
    """Poses around the block, with bends of 1 m radius, from the middle of the lower road."""
    straights, bend = [4.0, 4.0, 8.0, 4.0, 4.0], 0.5 * math.pi
    curvatures = []
    for i, straight in enumerate(straights):
        curvatures += [0.0] * round(straight / step) + ([1.0] * round(bend / step) if i < 4 else [])
    x, y, yaw = 0.0, -3.0, 0.0
    poses = []
    for curvature in (curvatures * math.ceil(laps))[: round(laps * len(curvatures))]:
        poses.append((x, y, yaw))
        # A bend of 16 steps turns by exactly 90 degrees.
        turn = curvature * bend / round(bend / step)
        x += step * math.cos(yaw + 0.5 * turn)
        y += step * math.sin(yaw + 0.5 * turn)
        yaw += turn
    return poses


def odometry_of(poses, drift):
    """What wheels that turn away by `drift` (rad per m) make of a drive."""
    x, y, yaw = poses[0]
    odometry = [poses[0]]
    for a, b in zip(poses, poses[1:]):
        way = math.hypot(b[0] - a[0], b[1] - a[1])
        yaw += drift * way
        heading = math.atan2(b[1] - a[1], b[0] - a[0]) - a[2] + yaw
        x, y = x + way * math.cos(heading), y + way * math.sin(heading)
        yaw += b[2] - a[2]
        odometry.append((x, y, yaw))
    return odometry


def mapped(poses, drift):
    """The mapper after a drive on which only odometry and loops count, and the true poses of its scans."""
    options = gmapping_core.SlamOptions()
    options.linear_update = 0.5
    options.angular_update = 0.3
    options.xmin = options.ymin = -1.0
    options.xmax = options.ymax = 1.0
    options.matcher.minimum_score = 1e6
    slam = gmapping_core.GridSlam(options)
    truth = [
        pose
        for i, (pose, odometry) in enumerate(zip(poses, odometry_of(poses, drift)))
        if slam.process(scan(pose), BEAMS[0], BEAMS[1] - BEAMS[0], 0.05, 12.0, odometry, 0.1 * i)
    ]
    return slam, np.array(truth)


def errors(slam, truth):
    return np.hypot(*(slam.path - truth)[:, :2].T)


def test_drift_grows_until_the_loop_is_closed():
    slam, truth = mapped(drive(0.9), DRIFT)
    assert errors(slam, truth)[-1] > 0.12


def test_closed_loop_takes_the_drift_back_from_all_poses():
    slam, truth = mapped(drive(1.3), DRIFT)
    assert errors(slam, truth)[-1] < 0.05
    assert errors(slam, truth).max() < 0.1


def test_map_is_made_anew_from_the_corrected_poses():
    slam, _ = mapped(drive(1.3), DRIFT)
    cells, resolution, corner = slam.map()
    rows, columns = np.nonzero(cells == 100)
    x = corner[0] + (columns + 0.5) * resolution
    y = corner[1] + (rows + 0.5) * resolution
    beside = np.min([distance_from(box, x, y) for box in CORNERS.values()], axis=0)
    assert np.quantile(beside, 0.9) < 0.1


def distance_from(box, x, y):
    """Distance of points from the outline of a box, m."""
    dx, dy = np.abs(x - 0.5 * (box[0] + box[2])), np.abs(y - 0.5 * (box[1] + box[3]))
    out_x, out_y = dx - 0.5 * (box[2] - box[0]), dy - 0.5 * (box[3] - box[1])
    outside = np.hypot(np.maximum(out_x, 0.0), np.maximum(out_y, 0.0))
    return np.where(np.maximum(out_x, out_y) > 0.0, outside, -np.maximum(out_x, out_y))


def test_option_out_of_range_is_named():
    options = gmapping_core.SlamOptions()
    options.delta = -1.0
    with pytest.raises(gmapping_core.Error, match="delta: found -1, must be at least 0.001"):
        gmapping_core.GridSlam(options)
