"""Inputs that fail on the road."""

import itertools
from collections.abc import Mapping
from pathlib import Path

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.scenario.settings import Setting
from f1tenth_judge.suites.suite import Suite

BEGIN, END = 3.5, 6.5  # s, simulated; the car is on the first straight
DELAY = 0.5  # s
_INPUTS = ("scan", "odom", "tf")
_SPEEDS = (1, 4, 8)  # m/s


def _all_cases() -> dict[str, tuple[Setting, ...]]:
    groups = [*itertools.combinations(_INPUTS, 1), *itertools.combinations(_INPUTS, 2)]
    found: dict[str, tuple[Setting, ...]] = {}
    for kind, group, speed in itertools.product(("missing", "late"), groups, _SPEEDS):
        delay = f", delay: {DELAY:g}" if kind == "late" else ""
        fault = f"[{{inputs: [{', '.join(group)}], at: {BEGIN:g}, until: {END:g}{delay}}}]"
        found[f"{kind}_{'_'.join(group)}_{speed}"] = (
            Setting("cars.robot1.input_faults", fault),
            Setting("cars.robot1.speed_max", str(speed)),
        )
    return found


def _cases(chosen: str, _: Path) -> Mapping[str, tuple[Setting, ...]]:
    known = _all_cases()
    names = chosen.split(",") if chosen else list(known)
    for name in names:
        if name not in known:
            raise ScenarioError(f"--cases {chosen}: found '{name}', allowed: {', '.join(known)}")
    return {name: known[name] for name in names}


SUITE = Suite(
    text="inputs of the planner are missing or late on a straight, at 1, 4 and 8 m/s: it must stop",
    scenario="safety",
    cases=_cases,
)
