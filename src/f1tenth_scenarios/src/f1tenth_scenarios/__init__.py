"""Scenarios with ROS around the car: launching, watching, drivers that are launch files.

Once it is imported, f1tenth_judge finds packages where ROS does.
"""

from f1tenth_judge.places.packages import know_packages

from f1tenth_scenarios.ros_packages import RosPackages

know_packages(RosPackages())
