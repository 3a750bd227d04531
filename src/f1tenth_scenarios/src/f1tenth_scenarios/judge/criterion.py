"""What a criterion judges and says: what was measured, what is asked for, and whether that is met."""

import dataclasses
import enum
from collections.abc import Mapping, Sequence
from typing import Any, Optional

from f1tenth_scenarios.record.replay import Poses
from f1tenth_scenarios.road.course import Course
from f1tenth_scenarios.scenario.scenario import Scenario, Verdict


@dataclasses.dataclass(frozen=True)
class Measured:
    """What the record alone does not hold."""

    start: Optional[float] = None  # s, when the race began; nothing without a race
    lap_times: Mapping[str, Sequence[float]] = dataclasses.field(default_factory=dict)  # s, by car
    real_time_factor: Optional[float] = None
    estimates: Mapping[str, Poses] = dataclasses.field(default_factory=dict)  # of the localization, by car
    course: Optional[Course] = None


class Status(enum.Enum):
    """Whether a criterion is met."""

    PASSED = "passed"
    FAILED = "failed"
    NOT_JUDGED = "not judged"


@dataclasses.dataclass(frozen=True)
class Criterion:
    """One line of a result."""

    name: str
    status: Status
    actual: Any
    limit: Any
    unit: str
    reason: str

    @property
    def comparison(self) -> str:
        """What was measured and what is asked for, in words."""
        actual, limit = (f"{value} {self.unit}".rstrip() for value in (self.actual, self.limit))
        return f"{actual}, limit {limit}"


def status_of(met: bool) -> Status:
    """Passed or failed."""
    return Status.PASSED if met else Status.FAILED


def expects_failure(scenario: Scenario) -> bool:
    """Whether the run is expected to end in a way that makes measures of good driving pointless."""
    return scenario.expected in (Verdict.COLLISION, Verdict.ERROR)
