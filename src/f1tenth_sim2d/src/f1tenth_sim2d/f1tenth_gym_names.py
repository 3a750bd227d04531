"""What f1tenth_gym calls things; importing it needs nothing else."""

PER_CAR = {
    "scan": "scans",
    "pose_x": "poses_x",
    "pose_y": "poses_y",
    "pose_theta": "poses_theta",
    "linear_vel_x": "linear_vels_x",
    "linear_vel_y": "linear_vels_y",
    "ang_vel_z": "ang_vels_z",
    "collision": "collisions",
    "lap_time": "lap_times",
    "lap_count": "lap_counts",
}
"""Names of a feature in version 1.0, and of the same for all cars in the original observation."""
