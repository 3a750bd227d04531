"""A scenario file as a test."""

from collections.abc import Iterator
from typing import Any

import pytest

from f1tenth_judge.api.run import Run
from f1tenth_judge.api.runs import Runs
from f1tenth_judge.errors import NotApplicableError, ScenarioError
from f1tenth_judge.plan.source import read_scenario
from f1tenth_judge.pytest_plugin.reporting import RUNS


class ScenarioFile(pytest.File):
    """Holds one test, which has the tags of the scenario as its markers."""

    def __init__(self, *, run_name: str, **others: Any):
        super().__init__(**others)
        self._run_name = run_name

    def collect(self) -> Iterator[pytest.Item]:
        """The test.

        Raises:
            CollectError: the file is not a scenario.
        """
        try:
            scenario = read_scenario(self.path)
        except ScenarioError as error:
            raise self.CollectError(str(error)) from error
        item = ScenarioItem.from_parent(self, name=self._run_name)
        for tag in scenario.tags:
            self.config.addinivalue_line("markers", f"{tag}: a tag of scenarios")
            item.add_marker(tag)
        yield item


class ScenarioItem(pytest.Item):
    """Passes if the run ends as the scenario expects."""

    def runtest(self) -> None:
        """Run it; one that says nothing about the planner is skipped."""
        runs = Runs(planner=self.config.getoption("planner"))
        try:
            run = runs.run(str(self.path), name=self.name)
        except NotApplicableError as reason:
            pytest.skip(str(reason))
        self.stash[RUNS] = [run]
        if not run.passed:
            raise _NotPassedError(run)

    def repr_failure(self, excinfo: pytest.ExceptionInfo, style: Any = None) -> Any:
        """The reason alone, where that is all that there is to know."""
        if isinstance(excinfo.value, (ScenarioError, _NotPassedError)):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Any, int, str]:
        """Where it is, and how it is called."""
        return self.path, 0, self.name


class _NotPassedError(Exception):
    def __init__(self, run: Run):
        super().__init__(run.reason)
