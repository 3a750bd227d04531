"""Occupancy-grid maps in image files: the ROS-free core and the nodes map_server and map_saver."""
