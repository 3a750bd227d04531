"""Driving with a planner that speaks ROS 2's DDS: needs PyPI's `cyclonedds`, and no ROS."""
