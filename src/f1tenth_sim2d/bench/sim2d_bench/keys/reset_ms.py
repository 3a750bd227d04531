"""reset_ms: reset of a running world."""

import f1tenth_sim2d

from ..benchmark import Measured, benchmark
from ..cars import f1tenth_car
from ..laps import record
from ..places import circuit_file
from ..timing import least_cost


@benchmark("reset_ms", "ms", at_most=1)
def reset_ms():
    """The slower of circuit1 and circuit_detailed, each with a car that has driven for 2 s."""
    details = {name: _reset_ms(name) for name in ("circuit1", "circuit_detailed")}
    return Measured(max(details.values()), details)


def _reset_ms(circuit):
    simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.load_world(str(circuit_file(circuit))))
    simulation.add_car(f1tenth_car())
    resets = []
    for _ in range(10):
        record(simulation, 2.0)
        resets.append(least_cost(simulation.reset, 1).cpu)
    return min(resets) * 1e3
