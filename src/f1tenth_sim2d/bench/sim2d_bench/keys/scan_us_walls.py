"""scan_us_walls: one scan in circuit1."""

import f1tenth_sim2d

from ..benchmark import Measured, benchmark
from ..cars import F1TENTH, f1tenth_car
from ..laps import record
from ..places import circuit_file
from ..scan_cost import Scanner


@benchmark("scan_us_walls", "us", at_most=8)
def scan_us_walls():
    """Mean over the places of a lap, without noise."""
    world = f1tenth_sim2d.load_world(str(circuit_file("circuit1")))
    simulation = f1tenth_sim2d.Simulation(world)
    simulation.add_car(f1tenth_car())
    poses = record(simulation, 25.0).poses[:, 0]
    return Measured(Scanner(world, F1TENTH).microseconds(poses), {"places": len(poses)})
