"""scan_us_walls, scan_us_map, walls: one scan without noise."""

import numpy as np

import f1tenth_sim2d
from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.places import circuit_file, data_file
from f1tenth_bench.simulator.cars import F1TENTH, SPIELBERG, f1tenth_car
from f1tenth_bench.simulator.generated_worlds import SEGMENTS_A_ROOM, rooms
from f1tenth_bench.simulator.laps import record
from f1tenth_bench.simulator.scan_cost import Scanner

MEAN_ERROR_MAX = 0.001  # m
SEGMENT_COUNTS = (100, 1_000, 10_000)
ROOM_POSES = np.random.default_rng(1).uniform((-2.2, -2.2, -3.1), (1.2, 2.2, 3.1), (500, 3))


@benchmark("scan_us_walls", "us", at_most=8)
def scan_us_walls():
    """Mean over the places of a lap of circuit1."""
    world = f1tenth_sim2d.load_world(str(circuit_file("circuit1")))
    simulation = f1tenth_sim2d.Simulation(world)
    simulation.add_car(f1tenth_car())
    poses = record(simulation, 25.0).poses[:, 0]
    return Measured(Scanner(world, F1TENTH).microseconds(poses), {"places": len(poses)})


@benchmark("scan_us_map", "us", at_most=30)
def scan_us_map():
    """Mean over the poses of the reference on Spielberg, compared with its exact ranges."""
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


@benchmark("walls", "x", at_most=4, is_ratio=True)
def walls():
    """Scan cost among 10 000 wall segments over that among 100, from a room that shows the same 100."""
    costs = {}
    for count in SEGMENT_COUNTS:
        costs[count] = Scanner(rooms(count // SEGMENTS_A_ROOM), F1TENTH).microseconds(ROOM_POSES)
    details = {"scan_us": {str(count): cost for count, cost in costs.items()}}
    return Measured(costs[10_000] / costs[100], details)
