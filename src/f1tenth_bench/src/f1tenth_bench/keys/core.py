"""core_rtf, core_rtf_map, core_steps_100hz, core_steps_100hz_2: the core alone."""

import f1tenth_sim2d
from f1tenth_bench.benchmark import benchmark
from f1tenth_bench.places import circuit_file
from f1tenth_bench.simulator.cars import f1tenth_car
from f1tenth_bench.simulator.core_speed import real_time_factor, steps_per_second
from f1tenth_bench.simulator.spielberg import spielberg

GYM_PERIOD = 0.01
"""s; f1tenth_gym's step: one scan of each car and as much physics."""


@benchmark("core_rtf", "sim s / s", at_least=1000)
def core_rtf():
    """One car drives laps of circuit1; its lidar with noise at 40 Hz, physics at 1 kHz."""
    simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.load_world(str(circuit_file("circuit1"))), seed=1)
    simulation.add_car(f1tenth_car())
    return real_time_factor(simulation, 120.0)


@benchmark("core_rtf_map", "sim s / s", at_least=400)
def core_rtf_map():
    """One car on Spielberg; 1080 beams over 4.7 rad and 30 m, with noise, at 40 Hz; physics at 1 kHz."""
    return real_time_factor(spielberg(1), 60.0)


@benchmark("core_steps_100hz", "steps/s", at_least=25_000)
def core_steps_100hz():
    """One car on Spielberg, 1080 beams over 4.7 rad and 30 m, with noise; physics at 1 kHz."""
    return steps_per_second(spielberg(1), 30.0, GYM_PERIOD)


@benchmark("core_steps_100hz_2", "steps/s", at_least=12_000)
def core_steps_100hz_2():
    """The same with two cars, one behind the other."""
    return steps_per_second(spielberg(2), 30.0, GYM_PERIOD)
