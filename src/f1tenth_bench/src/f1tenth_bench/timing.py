"""How time is taken."""

import time
from dataclasses import dataclass


@dataclass(frozen=True)
class Cost:
    """Time that some work took, s."""

    cpu: float
    """Processor time of this process: what else a busy machine does does not count."""
    wall: float


def cost(work):
    """Cost of calling work once."""
    cpu, wall = time.process_time(), time.perf_counter()
    work()
    return Cost(time.process_time() - cpu, time.perf_counter() - wall)


def least_cost(work, repeats=3):
    """The cheapest of several calls: whatever disturbs a measurement makes it longer."""
    return min((cost(work) for _ in range(repeats)), key=lambda each: each.cpu)
