"""core_rtf: the core alone on circuit1."""

import f1tenth_sim2d

from ..benchmark import benchmark
from ..cars import f1tenth_car
from ..core_speed import real_time_factor
from ..places import circuit_file


@benchmark("core_rtf", "sim s / s", at_least=1000)
def core_rtf():
    """One car drives laps; its lidar with noise at 40 Hz, physics at 1 kHz."""
    simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.load_world(str(circuit_file("circuit1"))), seed=1)
    simulation.add_car(f1tenth_car())
    return real_time_factor(simulation, 120.0)
