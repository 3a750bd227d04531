"""Speed of the core through the Python module, one thread."""

from f1tenth_bench.benchmark import Measured
from f1tenth_bench.simulator.laps import PERIOD, record, replay
from f1tenth_bench.timing import processor_seconds


def measure_laps(simulation, seconds, period=PERIOD, may_touch=False):
    """Drive laps in a simulation, with a noisy scan of each car a period.

    Returns:
        (seconds, details, problem): processor time of the laps; what to keep in bench.json; "" or why it does
        not count.
    """
    laps = record(simulation, seconds, period)
    touched = not may_touch and any(simulation.contacts(car) for car in simulation.cars)
    spent = processor_seconds(lambda: replay(simulation, laps), 3)
    same = simulation.trajectory_hash() == laps.trajectory_hash
    details = {
        "simulated_seconds": seconds,
        "real_time_factor": seconds / spent,
        "trajectory_hash": laps.trajectory_hash,
    }
    problem = "the laps were not the same again" if not same else "a car hit something" if touched else ""
    return spent, details, problem


def real_time_factor(simulation, seconds):
    """Simulated seconds per second of processor time."""
    spent, details, problem = measure_laps(simulation, seconds)
    return Measured(seconds / spent, details, problem)


def steps_per_second(simulation, seconds, period):
    """Steps of `period` seconds with a scan of each car per second of processor time."""
    spent, details, problem = measure_laps(simulation, seconds, period)
    return Measured(seconds / period / spent, details, problem)
