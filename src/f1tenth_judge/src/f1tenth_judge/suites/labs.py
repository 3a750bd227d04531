"""The exercises of the F1TENTH course, each a scenario with its task."""

from collections.abc import Mapping
from pathlib import Path

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.suites.suite import Suite

_LABS = ("emergency_braking", "wall_following", "follow_the_gap", "pure_pursuit", "head_to_head")


def _cases(chosen: str, _: Path) -> Mapping[str, tuple]:
    names = chosen.split(",") if chosen else _LABS
    for name in names:
        if name not in _LABS:
            raise ScenarioError(f"--cases {chosen}: found '{name}', allowed: {', '.join(_LABS)}")
    return dict.fromkeys(names, ())


SUITE = Suite(
    text="exercises of the F1TENTH course, from emergency braking to head to head; --cases are names",
    scenario="labs/{case}",
    cases=_cases,
    planner_key="cars.robot1.driver",  # whatever the scenario asks of it
)
