"""reset_ms, reset_map_ms: reset of a running world."""

import f1tenth_sim2d
from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.places import circuit_file
from f1tenth_bench.simulator.cars import f1tenth_car
from f1tenth_bench.simulator.laps import PERIOD, record
from f1tenth_bench.simulator.spielberg import spielberg
from f1tenth_bench.timing import processor_seconds

REPEATS = 10
INTO_THE_WALL = (4.0, 0.3)
"""m/s, rad."""
SCRAPING = 1.0
"""s, after the first touch."""


@benchmark("reset_ms", "ms", at_most=1)
def reset_ms():
    """The slower of circuit1 and circuit_detailed, each with a car that has driven for 2 s."""
    details = {name: _reset_ms(name) for name in ("circuit1", "circuit_detailed")}
    return Measured(max(details.values()), details)


@benchmark("reset_map_ms", "ms", at_most=1)
def reset_map_ms():
    """Spielberg, after a car has scraped along a wall."""
    simulation = spielberg(1)
    runs, resets = set(), []
    for _ in range(REPEATS):
        seconds = _scrape(simulation)
        runs.add(simulation.trajectory_hash())
        resets.append(processor_seconds(simulation.reset))
    problem = "" if len(runs) == 1 else "the run was not the same after a reset"
    return Measured(min(resets) * 1e3, {"worst": max(resets) * 1e3, "seconds_driven": seconds}, problem)


def _reset_ms(circuit):
    simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.load_world(str(circuit_file(circuit))))
    simulation.add_car(f1tenth_car())
    resets = []
    for _ in range(REPEATS):
        record(simulation, 2.0)
        resets.append(processor_seconds(simulation.reset))
    return min(resets) * 1e3


def _scrape(simulation):
    """Drive into the next wall and along it; return how long that took, s."""
    while not simulation.contacts(0):
        _drive(simulation)
    for _ in range(round(SCRAPING / PERIOD)):
        _drive(simulation)
    return simulation.time


def _drive(simulation):
    simulation.command(0, *INTO_THE_WALL)
    simulation.advance_to(simulation.time + PERIOD)
