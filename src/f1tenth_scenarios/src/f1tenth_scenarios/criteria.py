"""The criteria of a run: each with what was measured, what is asked for, and whether that is met.

What is asked for follows from the expected verdict: a scenario that expects a collision fails without one.
"""

import dataclasses
import enum
from typing import Any, Callable, Optional

import numpy as np

from f1tenth_scenarios.judge import Judgement
from f1tenth_scenarios.scenario import Scenario, Verdict


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


def evaluate(scenario: Scenario, judgement: Judgement) -> list[Criterion]:
    """All criteria of a scenario, the verdict first."""
    return [
        criterion(scenario, judgement) for name, criterion in _CRITERIA.items() if name in names(scenario)
    ]


def names(scenario: Scenario) -> list[str]:
    """The names of a scenario's criteria, known before it runs."""
    optional = {
        "culprit": scenario.culprit is not None,
        "minimum_clearance": scenario.criteria.minimum_clearance is not None,
    }
    return [name for name in _CRITERIA if optional.get(name, True)]


def minimum_clearance(judgement: Judgement) -> Optional[float]:
    """The least clearance of any car up to the deciding stamp, m; nothing without a record."""
    clearances = [track.clearance for track in judgement.record.tracks.values() if len(track.clearance)]
    return float(np.concatenate(clearances).min()) if clearances else None


def _verdict(scenario, judgement):
    decision = judgement.decision
    met = decision.verdict is scenario.expected
    return Criterion(
        "verdict", _status(met), decision.verdict.value, scenario.expected.value, "", decision.reason
    )


def _culprit(scenario, judgement):
    actual = judgement.failure.culprit if judgement.failure else None
    status = _status(actual == scenario.culprit)
    return Criterion("culprit", status, actual, scenario.culprit, "", judgement.decision.reason)


def _goals_in_order(scenario, judgement):
    passed = sum(len(result.times) for result in judgement.passes.values())
    wanted = sum(result.wanted for result in judgement.passes.values())
    status = _status(passed == wanted) if scenario.expected is Verdict.SUCCESS else Status.NOT_JUDGED
    behind = [car for car, result in judgement.passes.items() if not result.complete]
    reason = f"not all goals passed by {', '.join(behind)}" if behind else "all goals passed"
    return Criterion("goals_in_order", status, passed, wanted, "goals", reason)


def _collision(scenario, judgement):
    contacts = [contact for track in judgement.record.tracks.values() for contact in track.contact_list()]
    if scenario.expected is Verdict.ERROR:
        status = Status.NOT_JUDGED
    else:
        status = _status(bool(contacts) == (scenario.expected is Verdict.COLLISION))
    limit = "at least 1" if scenario.expected is Verdict.COLLISION else 0
    reason = (
        judgement.decision.reason if judgement.decision.verdict is Verdict.COLLISION else "nothing touched"
    )
    return Criterion("collision", status, len(contacts), limit, "contacts", reason)


def _timeout(scenario, judgement):
    late = judgement.decision.verdict is Verdict.TIMEOUT
    if scenario.expected is Verdict.ERROR:
        status = Status.NOT_JUDGED
    else:
        status = _status(late == (scenario.expected is Verdict.TIMEOUT))
    reason = judgement.decision.reason if late else f"ended after {judgement.decision.stamp:.3f} s"
    return Criterion(
        "timeout", status, round(judgement.decision.stamp, 9), scenario.limits.timeout, "s", reason
    )


def _minimum_clearance(scenario, judgement):
    actual, limit = minimum_clearance(judgement), scenario.criteria.minimum_clearance
    if scenario.expected in (Verdict.COLLISION, Verdict.ERROR):
        return Criterion("minimum_clearance", Status.NOT_JUDGED, actual, limit, "m", "a failure is expected")
    if actual is None:
        return Criterion("minimum_clearance", Status.FAILED, None, limit, "m", "nothing was recorded")
    return Criterion(
        "minimum_clearance", _status(actual >= limit), actual, limit, "m", f"came as close as {actual:.3f} m"
    )


def _status(met: bool) -> Status:
    return Status.PASSED if met else Status.FAILED


_CRITERIA: dict[str, Callable[[Scenario, Judgement], Criterion]] = {
    "verdict": _verdict,
    "culprit": _culprit,
    "goals_in_order": _goals_in_order,
    "collision": _collision,
    "timeout": _timeout,
    "minimum_clearance": _minimum_clearance,
}
