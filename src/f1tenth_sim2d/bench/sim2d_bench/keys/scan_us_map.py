"""scan_us_map: one scan on a track's map, compared with exact ranges."""

import numpy as np

import f1tenth_sim2d

from ..benchmark import Measured, benchmark
from ..cars import SPIELBERG
from ..places import data_file
from ..scan_cost import Scanner

MEAN_ERROR_MAX = 0.001  # m


@benchmark("scan_us_map", "us", at_most=30)
def scan_us_map():
    """Mean over the poses of the reference, without noise."""
    world = f1tenth_sim2d.load_world(str(data_file("tracks/Spielberg/Spielberg_map.yaml")))
    poses = np.loadtxt(data_file("lidar_reference/Spielberg_poses.txt"))
    expected = np.load(data_file("lidar_reference/Spielberg_ranges.npz"))["ranges"]
    scanner = Scanner(world, SPIELBERG)
    errors = np.empty(expected.shape)
    for i, pose in enumerate(poses):
        scanner.scan(pose)
        # The reference ends at the range of the lidar, where a scan says that it saw nothing.
        errors[i] = np.abs(np.minimum(scanner.ranges, SPIELBERG.range_max) - expected[i])
    mean = float(errors.mean())
    problem = "" if mean < MEAN_ERROR_MAX else f"the mean absolute error is {mean:.3g} m"
    return Measured(
        scanner.microseconds(poses),
        {"mean_absolute_error": mean, "largest_error": float(errors.max())},
        problem,
    )
