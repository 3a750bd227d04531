"""scenario_cost_s: what a scenario costs besides simulating."""

import tempfile

from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.judged import judged

# One car, a planner that is killed, a simulator that is killed, and two cars.
_SCENARIOS = ("goal_ahead", "planner_killed", "simulator_killed", "head_to_head")
_RUNS = 3


@benchmark("scenario_cost_s", "s", at_most=6)
def scenario_cost_s():
    """The greatest of the scenarios' costs in wall time, each the least of some runs."""
    with tempfile.TemporaryDirectory() as folder:
        runs = [_run(name, folder) for name in _SCENARIOS for _ in range(_RUNS)]
    costs = {name: min(cost for ran, cost, _ in runs if ran == name) for name in _SCENARIOS}
    failed = sorted({name for name, _, passed in runs if not passed})
    return Measured(max(costs.values()), costs, problem=f"{', '.join(failed)} failed" if failed else "")


def _run(name, folder):
    result = judged(folder, name, "run", name)
    return name, result["times"]["cost"], result["passed"]
