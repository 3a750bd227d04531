"""Criteria of how a run ended."""

from f1tenth_judge.judge.criterion import Criterion, Measured, Status, status_of
from f1tenth_judge.judge.judge import Judgement
from f1tenth_judge.scenario.scenario import Scenario, Verdict


def verdict(scenario: Scenario, judgement: Judgement, _measured: Measured) -> Criterion:
    """Whether the run ended as expected."""
    decision = judgement.decision
    status = status_of(decision.verdict is scenario.expected)
    return Criterion("verdict", status, decision.verdict.value, scenario.expected.value, "", decision.reason)


def reason(scenario: Scenario, judgement: Judgement, _measured: Measured) -> Criterion:
    """Whether the reason holds the expected words."""
    text, wanted = judgement.decision.reason, scenario.reason
    return Criterion("reason", status_of((wanted or "") in text), text, f"'{wanted}' in it", "", text)


def culprit(scenario: Scenario, judgement: Judgement, _measured: Measured) -> Criterion:
    """Whether an expected error is whose it should be."""
    actual = judgement.failure.culprit if judgement.failure else None
    status = status_of(actual == scenario.culprit)
    return Criterion("culprit", status, actual, scenario.culprit, "", judgement.decision.reason)


def goals_in_order(scenario: Scenario, judgement: Judgement, _measured: Measured) -> Criterion:
    """Whether each car passed its goals one after the other."""
    passed = sum(len(result.times) for result in judgement.passes.values())
    wanted = sum(result.wanted for result in judgement.passes.values())
    judged = wanted and scenario.expected is Verdict.SUCCESS
    behind = [car for car, result in judgement.passes.items() if not result.complete]
    done = "all goals passed" if wanted else "no goals to be passed"
    text = f"not all goals passed by {', '.join(behind)}" if behind else done
    status = status_of(passed == wanted) if judged else Status.NOT_JUDGED
    return Criterion("goals_in_order", status, passed, wanted, "goals", text)


def collision(scenario: Scenario, judgement: Judgement, _measured: Measured) -> Criterion:
    """Whether something was touched, harder than a light touch."""
    expected = scenario.expected is Verdict.COLLISION
    count = len([each for each in judgement.contacts if each.speed >= scenario.criteria.light_touch])
    status = Status.NOT_JUDGED if scenario.expected is Verdict.ERROR else status_of(bool(count) == expected)
    collided = judgement.decision.verdict is Verdict.COLLISION
    text = judgement.decision.reason if collided else "nothing touched"
    return Criterion("collision", status, count, "at least 1" if expected else 0, "contacts", text)


def timeout(scenario: Scenario, judgement: Judgement, _measured: Measured) -> Criterion:
    """Whether the run ended in time."""
    decision = judgement.decision
    late = decision.verdict is Verdict.TIMEOUT
    if scenario.expected is Verdict.ERROR:
        status = Status.NOT_JUDGED
    else:
        status = status_of(late == (scenario.expected is Verdict.TIMEOUT))
    text = decision.reason if late else f"ended after {decision.stamp:.3f} s"
    return Criterion("timeout", status, round(decision.stamp, 9), scenario.limits.timeout, "s", text)
