"""The least time for a way through gates by how often it turns back, as far as a car can accelerate at all.

Seen in one direction, a lap goes to and fro. A point whose acceleration is at most A needs 2 sqrt(D / A)
from one turning point to the next, D away, and sqrt(2 D / A) for the way to the first one or from the last
one, however fast it is at the other end: the time-optimal control of a double integrator (M. Athans,
P. L. Falb: Optimal Control, 1966, chapter 7).
"""

import math
from collections.abc import Sequence

import numpy as np

from f1tenth_judge.scenario.scenario import StartLine

_DIRECTIONS = 72  # in which a way is looked at


def least_time(
    gates: Sequence[StartLine], speed: float, acceleration: float, room: float = 0.0, before: float = 0.0
) -> float:
    """Least time (s) from the first gate through all others, in their order, to the last one.

    Args:
        gates: what is passed
        speed: the greatest, m/s
        acceleration: the greatest, m/s^2
        room: how far the point so accelerated may be from the one that passes the gates, m
        before: how far from the first gate the way begins at most, m

    """
    x, y, yaw, width = np.array([(gate.x, gate.y, gate.yaw, gate.width) for gate in gates]).T
    direction = np.linspace(0.0, math.tau, _DIRECTIONS, endpoint=False)[:, None]
    ahead = x * np.cos(direction) + y * np.sin(direction)  # by direction and gate
    reach = room + np.abs(width / 2 * np.sin(yaw - direction))
    reach[:, 0] += before
    # How far the way leads at least from one gate to another, ahead and back.
    there = (ahead - reach)[:, None, :] - (ahead + reach)[:, :, None]
    back = there.transpose(0, 2, 1)
    return _slowest_chain(there, back, speed, acceleration)


def _slowest_chain(there, back, speed, acceleration) -> float:
    """The least time (s) by the turning points at gates, the first of which lies ahead, that take longest."""
    # The least time to one beyond the gate.
    turned_ahead, turned_back = np.full((2, *there.shape[:2]), -np.inf)
    least = 0.0
    for gate in range(1, there.shape[1]):
        on, home = there[:, :gate, gate], back[:, :gate, gate]
        before = turned_ahead[:, :gate], turned_back[:, :gate]
        ends = [before[0] + _end(home, speed, acceleration), before[1] + _end(on, speed, acceleration)]
        least = max(least, *(float(each.max()) for each in ends))
        again = before[1] + _between(on, speed, acceleration)
        turned_ahead[:, gate] = np.maximum(_end(on, speed, acceleration), again).max(axis=1)
        turned_back[:, gate] = (before[0] + _between(home, speed, acceleration)).max(axis=1)
    return least


def _end(way, speed, acceleration) -> np.ndarray:
    """Time (s) between a turning point and any speed; minus infinity where the way (m) is none."""
    full = speed**2 / (2 * acceleration)  # m, to reach the greatest speed
    with np.errstate(invalid="ignore"):
        time = np.where(way < full, np.sqrt(2 * way / acceleration), (way + full) / speed)
    return np.where(way > 0.0, time, -np.inf)


def _between(way, speed, acceleration) -> np.ndarray:
    """Time (s) between two turning points."""
    return 2 * _end(way / 2, speed, acceleration)
