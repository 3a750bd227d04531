"""ros_rtf, ros_rtf_map, ros_cpu_real_time: the node with one C++ subscriber of everything."""

from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.places import circuit_file, data_file
from f1tenth_bench.ros.ros_speed import measure_node, real_time_factor
from f1tenth_bench.simulator.cars import SPIELBERG

INFIELD = (0.0, 2.5)
"""Where there is room for a circle in circuit1, m."""


@benchmark("ros_rtf", "sim s / s", at_least=100, of_messages=True)
def ros_rtf():
    """Free mode on circuit1, wall time; every message is received."""
    return real_time_factor(circuit_file("circuit1"), centre=INFIELD)


@benchmark("ros_rtf_map", "sim s / s", at_least=100, of_messages=True)
def ros_rtf_map():
    """The same on Spielberg."""
    return real_time_factor(data_file("tracks/Spielberg/Spielberg_map.yaml"), lidar=SPIELBERG)


@benchmark("ros_cpu_real_time", "s / s", at_most=0.10, of_messages=True)
def ros_cpu_real_time():
    """Processor time of the node per second at real time on circuit1."""
    found = measure_node(circuit_file("circuit1"), 10.0, centre=INFIELD, real_time_factor=1.0)
    return Measured(found["cpu_seconds_per_wall_second"], found, found["problem"])
