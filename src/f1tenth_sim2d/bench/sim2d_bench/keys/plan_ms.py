"""plan_ms, plan_worst_ms: planning to goals half a lap away."""

import functools
import statistics

from ..benchmark import Measured, NotAvailable, benchmark
from ..racing import CIRCUITS, TRACKS, half_laps, planner_module
from ..timing import cost


@benchmark("plan_ms", "ms", at_most=150)
def plan_ms():
    """The greatest of the circuits' and tracks' medians."""
    times = _times()
    medians = {name: statistics.median(values) for name, values in times.items()}
    return Measured(max(medians.values()), medians, problem=_problem(times))


@benchmark("plan_worst_ms", "ms", at_most=1000)
def plan_worst_ms():
    """The slowest of all plans."""
    times = _times()
    worst = {name: max(values) for name, values in times.items()}
    return Measured(max(worst.values()), worst, problem=_problem(times))


def _problem(times):
    missing = [name for name, values in times.items() if float("inf") in values]
    return f"no plan on {', '.join(missing)}" if missing else ""


@functools.lru_cache(maxsize=1)
def _times():
    """Per circuit or track the processor time of each plan, ms; infinite for one that was not found."""
    times = {}
    for name in CIRCUITS + TRACKS:
        try:
            costmap, pairs = half_laps(name)
        except NotAvailable:
            if name in TRACKS:
                continue
            raise
        times[name] = [_time(costmap, start, goal) for start, goal in pairs]
    return times


def _time(costmap, start, goal):
    plans = []
    planner = planner_module().GlobalPlanner()
    taken = cost(lambda: plans.append(planner.plan(costmap, start, goal))).cpu
    return taken * 1e3 if plans[0].found else float("inf")
