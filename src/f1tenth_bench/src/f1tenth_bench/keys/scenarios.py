"""scenario_cost_s: what a scenario costs besides simulating."""

import json
import shutil
import subprocess
import tempfile
from pathlib import Path

from f1tenth_bench.benchmark import Measured, NotAvailable, benchmark

# One car, a planner that is killed, a simulator that is killed, and two cars.
_SCENARIOS = ("goal_ahead", "planner_killed", "simulator_killed", "head_to_head")
_RUNS = 3


@benchmark("scenario_cost_s", "s", at_most=6)
def scenario_cost_s():
    """The greatest of the scenarios' costs in wall time, each the least of some runs."""
    if not shutil.which("rosrun"):
        raise NotAvailable("no rosrun; source the workspace's setup.bash")
    with tempfile.TemporaryDirectory() as folder:
        runs = [_run(name, Path(folder)) for name in _SCENARIOS for _ in range(_RUNS)]
    costs = {name: min(cost for ran, cost, _ in runs if ran == name) for name in _SCENARIOS}
    failed = sorted({name for name, _, passed in runs if not passed})
    return Measured(max(costs.values()), costs, problem=f"{', '.join(failed)} failed" if failed else "")


def _run(name, folder):
    command = ["rosrun", "f1tenth_scenarios", "scenario", "run", name, "--results", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    try:
        result = json.loads((folder / name / "result.json").read_text(encoding="utf-8"))
    except OSError as error:
        raise NotAvailable(f"{name} has no result: {done.stderr.strip()}") from error
    return name, result["times"]["cost"], result["passed"]
