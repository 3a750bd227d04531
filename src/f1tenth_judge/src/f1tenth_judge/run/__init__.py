"""A run without ROS: its processes, the simulation, the drivers, and the loop until it is decided."""
