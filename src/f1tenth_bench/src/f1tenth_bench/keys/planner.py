"""plan_ms, plan_worst_ms, control_cycle_ms: the planner of f1tenth_racer."""

import functools
import statistics

import numpy as np
from f1tenth_judge.places.lookup import circuits

from f1tenth_bench.benchmark import Measured, NotAvailable, benchmark
from f1tenth_bench.racing import TRACKS, half_laps, planner_module, race_options
from f1tenth_bench.timing import processor_seconds

PERIOD = 0.025  # s
BEAMS = 1081
LIDAR_X = 0.275  # m ahead of the rear axle
SPEED = 4.0  # m/s


@benchmark("plan_ms", "ms", at_most=150)
def plan_ms():
    """The greatest of the circuits' and tracks' medians, to goals half a lap away."""
    times = _plan_times()
    medians = {name: statistics.median(values) for name, values in times.items()}
    return Measured(max(medians.values()), medians, problem=_plan_problem(times))


@benchmark("plan_worst_ms", "ms", at_most=1000)
def plan_worst_ms():
    """The slowest of all plans."""
    times = _plan_times()
    worst = {name: max(values) for name, values in times.items()}
    return Measured(max(worst.values()), worst, problem=_plan_problem(times))


@benchmark("control_cycle_ms", "ms", at_most=5)
def control_cycle_ms():
    """Median over half a lap of circuit3 at a constant speed: a scan, and the command to it."""
    core = planner_module()
    costmap, pairs = half_laps("circuit3")
    racer = core.Racer(costmap, [goal for goal, _ in pairs], race_options(), period=PERIOD, lidar_x=LIDAR_X)
    ranges = np.full(BEAMS, 8.0, np.float32)

    def cycle(pose):
        racer.plan({"scan": ranges, "pose": pose, "velocity": (SPEED, 0.0, 0.0)})

    points = core.GlobalPlanner().plan(costmap, *pairs[0]).points
    costs = [processor_seconds(lambda pose=pose: cycle(pose)) * 1e3 for pose in points[:, :3]]
    return Measured(statistics.median(costs), {"worst": max(costs), "cycles": len(costs)})


def _plan_problem(times):
    missing = [name for name, values in times.items() if float("inf") in values]
    return f"no plan on {', '.join(missing)}" if missing else ""


@functools.lru_cache(maxsize=1)
def _plan_times():
    """Per circuit or track the processor time of each plan, ms; infinite for one that was not found."""
    times = {}
    for name in (*circuits(), *TRACKS):
        try:
            costmap, pairs = half_laps(name)
        except NotAvailable:
            if name in TRACKS:
                continue
            raise
        times[name] = [_plan_time(costmap, start, goal) for start, goal in pairs]
    return times


def _plan_time(costmap, start, goal):
    plans = []
    planner = planner_module().GlobalPlanner()
    taken = processor_seconds(lambda: plans.append(planner.plan(costmap, start, goal)))
    return taken * 1e3 if plans[0].found else float("inf")
