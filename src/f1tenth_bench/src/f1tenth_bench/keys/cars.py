"""cars, cars_touching: what one more car costs."""

import functools

from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.simulator.cars import simulation_of
from f1tenth_bench.simulator.core_speed import measure_laps
from f1tenth_bench.simulator.generated_worlds import ring_pose, ring_track
from f1tenth_bench.simulator.spielberg import places_on_spielberg, spread_on_spielberg

COUNTS = (2, 4, 8, 16)
MOST = max(COUNTS)
SECONDS = 10.0
APART = 2.0
"""s, from one car to the next on the track."""


@benchmark("cars", "x alone", at_most=1.3, is_ratio=True)
def cars():
    """Cost of 16 cars over that of each alone, all over Spielberg, each with 1080 beams of 30 m."""
    return _over_alone(spread_on_spielberg, places_on_spielberg(MOST, APART))


@benchmark("cars_touching", "x alone", at_most=1.7, is_ratio=True)
def cars_touching():
    """Cost of 16 cars over that of each alone, on a ring where they crowd and touch each other."""
    ring = functools.partial(simulation_of, ring_track())
    return _over_alone(ring, [ring_pose(i, MOST) for i in range(MOST)], may_touch=True)


def _over_alone(simulation_at, places, may_touch=False):
    problems = []

    def cost(places):
        spent, _, problem = measure_laps(simulation_at(places), SECONDS, may_touch=may_touch)
        problems.append(problem)
        return spent

    alone = [cost([place]) for place in places]
    ratios = {count: cost(places[:: MOST // count]) / sum(alone[:: MOST // count]) for count in COUNTS}
    return Measured(ratios[MOST], {"by_count": ratios}, max(problems, key=len))
