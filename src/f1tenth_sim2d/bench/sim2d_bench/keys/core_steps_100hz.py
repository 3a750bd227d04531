"""core_steps_100hz, core_steps_100hz_2: the work of f1tenth_gym."""

from ..benchmark import benchmark
from ..core_speed import steps_per_second
from ..spielberg import spielberg

PERIOD = 0.01
"""s; f1tenth_gym's step: one scan of each car and as much physics."""


@benchmark("core_steps_100hz", "steps/s", at_least=25_000)
def core_steps_100hz():
    """One car on Spielberg, 1080 beams over 4.7 rad and 30 m, with noise; physics at 1 kHz."""
    return steps_per_second(spielberg(1), 30.0, PERIOD)


@benchmark("core_steps_100hz_2", "steps/s", at_least=12_000)
def core_steps_100hz_2():
    """The same with two cars, one behind the other."""
    return steps_per_second(spielberg(2), 30.0, PERIOD)
