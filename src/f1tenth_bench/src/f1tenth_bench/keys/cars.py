"""cars: what one more car costs."""

import f1tenth_sim2d
from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.simulator.cars import f1tenth_car
from f1tenth_bench.simulator.core_speed import measure_laps
from f1tenth_bench.simulator.generated_worlds import ring_pose, ring_track

COUNTS = (1, 2, 4, 8, 16)
SECONDS = 10.0


@benchmark("cars", "x a car", at_most=1.5, is_ratio=True)
def cars():
    """Cost per car with 16 cars over that with 1, on a ring where they see and touch each other."""
    costs = {}
    details = {}
    for count in COUNTS:
        simulation = f1tenth_sim2d.Simulation(ring_track(), seed=1)
        for i in range(count):
            simulation.add_car(f1tenth_car(name=f"robot{i + 1}"), None, *ring_pose(i, count))
        spent, laps, problem = measure_laps(simulation, SECONDS)
        costs[count] = spent.cpu / count
        details[str(count)] = laps["real_time_factor"]
    return Measured(costs[16] / costs[1], {"real_time_factor": details})
