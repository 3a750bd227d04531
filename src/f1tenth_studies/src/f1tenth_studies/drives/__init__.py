"""Drives by the driver of `create_map.launch`, without ROS: what lidar and wheels measure on the way."""
