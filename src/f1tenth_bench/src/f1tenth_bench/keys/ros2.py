"""ros2_rtf, ros2_cost: a planner that speaks DDS, as those of ROS 2 do."""

import shlex
import sys
import tempfile

from f1tenth_judge.places.lookup import package_path

from f1tenth_bench.benchmark import Measured, NotAvailable, benchmark
from f1tenth_bench.judged import judged

_LAPS = 5
_RUNS = 2


@benchmark("ros2_rtf", "sim s / s", at_least=10, of_messages=True)
def ros2_rtf():
    """Of what a race of some laps has more than one of a lap: without the time in which things start."""
    with tempfile.TemporaryDirectory() as folder:
        short, long = (_race(folder, *_planner_of_ros2(), "--laps", str(laps)) for laps in (1, _LAPS))
    simulated = long["finish"] - short["finish"]
    return Measured(simulated / (long["wall"] - short["wall"]), {"sim_s": simulated})


@benchmark("ros2_cost", "x", at_most=1.2, is_ratio=True)
def ros2_cost():
    """What a lap takes besides simulating, divided by that of a planner of ROS 1; each the least of runs."""
    with tempfile.TemporaryDirectory() as folder:
        costs = [
            min(_race(folder, *planner)["cost"] for _ in range(_RUNS))
            for planner in (_planner_of_ros2(), ("--planner", "gap_follower"))
        ]
    return Measured(costs[0] / costs[1], {"ros2_s": costs[0], "ros1_s": costs[1]})


def _planner_of_ros2():
    planner = package_path("f1tenth_judge") / "test/drivers/ros2/planners/gap.py"
    return "--ros2", shlex.join([sys.executable, str(planner), "by_subscription"])


def _race(folder, *options):
    """Times of a race on circuit1: those of its result."""
    result = judged(folder, "race", "race", "circuit1", *options)
    if not result["passed"]:
        raise NotAvailable(f"the race failed: {result['reason']}")
    return result["times"]
