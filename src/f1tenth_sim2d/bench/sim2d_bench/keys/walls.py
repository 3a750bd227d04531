"""walls: what walls out of view cost."""

import numpy as np

from ..benchmark import Measured, benchmark
from ..cars import F1TENTH
from ..generated_worlds import SEGMENTS_A_ROOM, rooms
from ..scan_cost import Scanner

SEGMENT_COUNTS = (100, 1_000, 10_000)
POSES = np.random.default_rng(1).uniform((-2.2, -2.2, -3.1), (1.2, 2.2, 3.1), (500, 3))


@benchmark("walls", "x", at_most=4)
def walls():
    """Scan cost among 10 000 wall segments over that among 100, from a room that shows the same 100."""
    costs = {}
    for count in SEGMENT_COUNTS:
        costs[count] = Scanner(rooms(count // SEGMENTS_A_ROOM), F1TENTH).microseconds(POSES)
    details = {"scan_us": {str(count): cost for count, cost in costs.items()}}
    return Measured(costs[10_000] / costs[100], details)
