"""What a suite is."""

import dataclasses
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.scenario.settings import Setting, parse_variation

MODELS = ("single_track", "single_track_drift")  # tyres whose forces grow with slip, and tyres that slide


@dataclasses.dataclass(frozen=True)
class Suite:
    """Cases of a scenario. A case is passed if its run ends as the scenario expects."""

    text: str  # one line: what a case is
    scenario: str  # file beside this one, without .yaml; `{case}` in it stands for the name of the case
    cases: Callable[[str, Path], Mapping[str, Sequence[Setting]]]  # of chosen ones; writes places to a folder
    planner_key: str = "planner"  # of the setting that names the planner
    chosen: str = ""  # the usual ones, as the option --cases names them; empty: all that there are


def seeds(text: str, option: str = "--cases") -> list[int]:
    """The seeds that an option names: `0:59`, `3` or `1,5`.

    Raises:
        ScenarioError: one is not a whole number.
    """
    found = []
    for setting in parse_variation(f"{option}={text}"):
        if not setting.value.isdecimal():
            raise ScenarioError(f"{option} {text}: found '{setting.value}', must be a seed, a whole number")
        found.append(int(setting.value))
    return found


def with_models(places: Mapping[str, Path | str]) -> dict[str, tuple[Setting, Setting]]:
    """A case for each place, by its name, and each vehicle model."""
    return {
        f"{name}_{model}": (Setting("world", str(world)), Setting("model", model))
        for name, world in places.items()
        for model in MODELS
    }
