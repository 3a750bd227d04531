"""Drives of the driver of `create_map.launch`, without ROS: what the lidar and the wheels tell on the way."""
