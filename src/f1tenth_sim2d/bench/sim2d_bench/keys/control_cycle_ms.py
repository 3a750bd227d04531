"""control_cycle_ms: what the planner does for each scan while racing."""

import statistics

import numpy as np

from ..benchmark import Measured, benchmark
from ..racing import half_laps, planner_module, race_options
from ..timing import cost

_PERIOD = 0.025  # s
_BEAMS = 1081
_FIELD = np.radians(270.0)


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
    ranges = np.full(_BEAMS, 8.0, np.float32)

    def cycle(pose, speed):
        costmap.observe(pose, ranges, -_FIELD / 2, _FIELD / (_BEAMS - 1), 0.06, 10.0)
        follower.step(pose, speed, costmap, _PERIOD)

    costs = [
        cost(lambda pose=pose, speed=speed: cycle(pose, speed)).cpu * 1e3
        for pose, speed in zip(plan.path.points[:, :3], speeds)
    ]
    return Measured(statistics.median(costs), {"worst": max(costs), "cycles": len(costs)})
