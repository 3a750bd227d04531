"""The fixture `f1tenth`."""

import re
from typing import TYPE_CHECKING, Any, Callable, Optional

import pytest

from f1tenth_judge.pytest_plugin.reporting import RUNS

if TYPE_CHECKING:
    from f1tenth_judge.api.run import Run


class F1tenth:
    """Runs races and scenarios for a test, which gives their results its name."""

    def __init__(self, request: pytest.FixtureRequest):
        from f1tenth_judge.api.runs import Runs

        self._runs = Runs(planner=request.config.getoption("planner"))
        self._name = re.sub(r"[^A-Za-z0-9_.-]+", "_", request.node.name).strip("_.-")
        self._done: list[Run] = []
        request.node.stash[RUNS] = self._done

    def race(self, place: str, planner: Any = None, **options: Any) -> "Run":
        """As Runs.race; a planner that is not named is that of --planner."""
        return self._note(self._runs.race, place, planner, options)

    def run(self, scenario: str, planner: Optional[str] = None, **options: Any) -> "Run":
        """As Runs.run; a planner that is not named is that of --planner."""
        return self._note(self._runs.run, scenario, planner, options)

    def _note(self, run: Callable[..., "Run"], what: str, planner: Any, options: dict[str, Any]) -> "Run":
        from f1tenth_judge.errors import NotApplicableError

        name = f"{self._name}_{len(self._done) + 1}" if self._done else self._name
        try:
            self._done.append(run(what, planner, **{"name": name, **options}))
        except NotApplicableError as reason:
            pytest.skip(str(reason))
        return self._done[-1]


@pytest.fixture
def f1tenth(request: pytest.FixtureRequest) -> F1tenth:
    """Races and scenarios: f1tenth.race("circuit3", planner="my_planner.py:MyPlanner", laps=3, seed=4)."""
    return F1tenth(request)
