"""Starts the simulator where Gazebo is expected, and spawns models in it."""
