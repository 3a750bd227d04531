"""The criteria of a run: each with what was measured, what is asked for, and whether that is met.

What is asked for follows from the expected verdict: a scenario that expects a collision fails without one.
"""

from f1tenth_judge.judge import driving_criteria, run_criteria, verdict_criteria
from f1tenth_judge.judge.criterion import Criterion, Measured
from f1tenth_judge.judge.judge import Judgement
from f1tenth_judge.scenario.scenario import Scenario

_ALWAYS = (
    verdict_criteria.verdict,
    verdict_criteria.goals_in_order,
    verdict_criteria.collision,
    verdict_criteria.timeout,
)
_IF_GIVEN = (verdict_criteria.culprit, verdict_criteria.reason)
_WITH_LIMIT = (
    driving_criteria.minimum_clearance,
    driving_criteria.lap_time,
    driving_criteria.lateral_acceleration,
    driving_criteria.standstill,
    driving_criteria.slows_to,
    run_criteria.localization_error,
    run_criteria.localization_yaw_error,
    run_criteria.odometry_drift,
    run_criteria.real_time_factor,
)


def evaluate(scenario: Scenario, judgement: Judgement, measured: Measured) -> list[Criterion]:
    """All criteria of a scenario, the verdict first."""
    given = [each for each in _IF_GIVEN if getattr(scenario, each.__name__) is not None]
    limited = [each for each in _WITH_LIMIT if getattr(scenario.criteria, each.__name__) is not None]
    road = [driving_criteria.off_road] if measured.excursions is not None else []
    criteria = [_ALWAYS[0], *given, *_ALWAYS[1:], *road, *limited]
    return [criterion(scenario, judgement, measured) for criterion in criteria]
