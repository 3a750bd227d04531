"""What was heard of a run for its replay, before the world is put around it."""

import dataclasses
from collections.abc import Mapping

from f1tenth_scenarios.record.record import STAMP_EPSILON
from f1tenth_scenarios.record.replay import Paths, Poses, Scans


@dataclasses.dataclass(frozen=True)
class Recording:
    """By car, and by model."""

    scans: Mapping[str, Scans] = dataclasses.field(default_factory=dict)
    global_plans: Mapping[str, Paths] = dataclasses.field(default_factory=dict)
    local_plans: Mapping[str, Paths] = dataclasses.field(default_factory=dict)
    models: Mapping[str, Poses] = dataclasses.field(default_factory=dict)
    estimates: Mapping[str, Poses] = dataclasses.field(default_factory=dict)  # amcl_pose


class Rate:
    """Lets through at most one message a period of simulated time."""

    def __init__(self, period: float):
        """`period`: s."""
        self._period = period
        self._next = float("-inf")

    def is_due(self, stamp: float) -> bool:
        """Whether a message with this stamp (s) is to be kept; asked once a message, in order."""
        if stamp + STAMP_EPSILON < self._next:
            return False
        self._next = stamp + self._period
        return True
