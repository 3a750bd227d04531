"""What is measured of a run besides the record."""

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Optional

from f1tenth_scenarios.record.replay import Poses
from f1tenth_scenarios.road.course import Course


@dataclasses.dataclass(frozen=True)
class Measured:
    """Input of the criteria that the record alone does not hold."""

    start: Optional[float] = None  # s, when the race began; nothing without a race
    lap_times: Mapping[str, Sequence[float]] = dataclasses.field(default_factory=dict)  # s, by car
    real_time_factor: Optional[float] = None
    estimates: Mapping[str, Poses] = dataclasses.field(default_factory=dict)  # of the localization, by car
    course: Optional[Course] = None
