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
FIELD_OF_VIEW = np.radians(270.0)


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
    """Median over the path of half a lap of circuit3: a scan into the costmap, and a step of the follower."""
    core = planner_module()
    line, options = race_options()
    costmap, pairs = half_laps("circuit3")
    plan = core.GlobalPlanner().plan(costmap, *pairs[0], extension_length=13.0, race_line=line)
    speeds = core.speed_profile(plan.path, costmap, options.limits)
    follower = core.PathFollower(options)
    follower.set_path(plan.path, costmap)
    ranges = np.full(BEAMS, 8.0, np.float32)

    def cycle(pose, speed):
        costmap.observe(pose, ranges, -FIELD_OF_VIEW / 2, FIELD_OF_VIEW / (BEAMS - 1), 0.06, 10.0)
        follower.step(pose, speed, costmap, PERIOD)

    costs = [
        processor_seconds(lambda pose=pose, speed=speed: cycle(pose, speed)) * 1e3
        for pose, speed in zip(plan.path.points[:, :3], speeds)
    ]
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
