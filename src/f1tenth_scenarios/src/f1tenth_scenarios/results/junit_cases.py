"""A judged run as unittest cases: the verdict and each criterion apart in JUnit."""

import unittest
from typing import Callable

from f1tenth_scenarios.judge.criterion import Criterion, Status
from f1tenth_scenarios.places import PACKAGE
from f1tenth_scenarios.results.console import summary
from f1tenth_scenarios.results.result import Result
from f1tenth_scenarios.scenario.plan import Plan


def cases_of(result: Result, plan: Plan) -> type[unittest.TestCase]:
    """A test case class, named after the scenario, with a method a criterion."""
    text = summary(result, plan)
    methods = {f"test_{criterion.name}": _check(criterion, text) for criterion in result.criteria}
    return _case_class(plan.name, methods)


def case_of_error(name: str, message: str) -> type[unittest.TestCase]:
    """A test case class with one case, the verdict, that fails: the run could not even begin."""

    def test_verdict(self):
        self.fail(f"verdict error: {message}")

    return _case_class(name, {"test_verdict": test_verdict})


def _case_class(name, methods):
    # JUnit shows module and class together.
    return type(name, (unittest.TestCase,), {"__module__": PACKAGE, **methods})


def _check(criterion: Criterion, text: str) -> Callable[[unittest.TestCase], None]:
    def check(self):
        if criterion.status is Status.NOT_JUDGED:
            self.skipTest(criterion.reason)
        if criterion.status is Status.FAILED:
            self.fail(f"{criterion.name}: {criterion.comparison}: {criterion.reason}\n{text}")

    return check
