"""What a criterion judges and says: what was measured, what is asked for, and whether that is met."""

import dataclasses
import enum
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Optional

from f1tenth_judge.judge.road import Excursion
from f1tenth_judge.record.replay import Poses
from f1tenth_judge.scenario.scenario import Scenario, Verdict

_SINGULAR = {"contacts": "contact", "goals": "goal"}


@dataclasses.dataclass(frozen=True)
class Measured:
    """What the record alone does not hold."""

    start: Optional[float] = None  # s, when the race began; nothing without a race
    lap_times: Mapping[str, Sequence[float]] = dataclasses.field(default_factory=dict)  # s, by car
    real_time_factor: Optional[float] = None
    estimates: Mapping[str, Poses] = dataclasses.field(default_factory=dict)  # of the car's pose, by car
    finishes: Mapping[str, Optional[float]] = dataclasses.field(default_factory=dict)  # s, by car with a task
    excursions: Optional[Sequence[Excursion]] = None  # nothing where no road is known


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
        return f"{self._words(self.actual)}, limit {self._words(self.limit)}"

    def _words(self, value: Any) -> str:
        if value is None:
            return "none"
        number = f"{round(value, 3):g}" if isinstance(value, float) else str(value)
        unit = _SINGULAR.get(self.unit, self.unit) if number.split()[-1:] == ["1"] else self.unit
        return f"{number} {unit}".rstrip()


def status_of(met: bool) -> Status:
    """Passed or failed."""
    return Status.PASSED if met else Status.FAILED


def compared(
    scenario: Scenario,
    name: str,
    is_met: Callable[[Any, Any], bool],
    worst: Optional[tuple[Any, ...]],
    unit: str,
    text: str,
    missing: str = "nothing was recorded",
) -> Criterion:
    """Compare a measure with the limit of its name.

    Not judged where a crash or an error is expected, or another planner drives than the one of the limit.

    `worst`: the measure, followed by what else `text` names (`{0}` is the measure); None if nothing was
    measured.
    `is_met` takes the measure and the limit.
    """
    limit, actual = getattr(scenario.criteria, name), worst[0] if worst else None
    if scenario.expected in (Verdict.COLLISION, Verdict.ERROR):
        return Criterion(name, Status.NOT_JUDGED, actual, limit, unit, "a failure is expected")
    said = text.format(*worst) if worst else missing
    if name in scenario.limits_of_reference:
        said = f"{said}; the limit is that of the reference planner"
        return Criterion(name, Status.NOT_JUDGED, actual, limit, unit, said)
    return Criterion(name, status_of(worst is not None and is_met(actual, limit)), actual, limit, unit, said)
