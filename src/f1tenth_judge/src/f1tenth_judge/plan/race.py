"""A race that is in no scenario file: some laps of a place, of one planner or more."""

import dataclasses
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Optional

import yaml

from f1tenth_judge.atomic import replacing
from f1tenth_judge.errors import FileError, ScenarioError, as_scenario_error, writing
from f1tenth_judge.places import lookup
from f1tenth_judge.places.course import read_course
from f1tenth_judge.places.place import Place, find_place, firm
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.plan.planning import plan_scenario
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.scenario.scenario import Scenario
from f1tenth_judge.scenario.settings import apply_settings, parse_setting
from f1tenth_judge.scenario.yaml_text import compose_text
from f1tenth_judge.yaml_files.schema import read

_SLOWEST = 1.0  # m/s on average, before the time is over
_STARTING = 30.0  # s, on top of that
_BESIDE = 0.6  # m, between two cars on the start line
_SEED = 1


@dataclasses.dataclass(frozen=True)
class Race:
    """What is raced."""

    place: str  # a name, or a path relative to the working directory
    laps: int
    planners: Sequence[Driver]
    timeout: Optional[float] = None  # s, simulated
    description: Optional[str] = None  # of the cars: path or package://PACKAGE/PATH; default: the F1/10 car
    called: Optional[str] = None  # default: after the place

    @property
    def name(self) -> str:
        """Names the results."""
        return self.called or f"race_{lookup.world_file(self.place, Path.cwd()).stem.removesuffix('_map')}"


@as_scenario_error(FileError)
def plan_race(race: Race, folder: Path, settings: Sequence[str] = ()) -> Plan:
    """Make a run of a race, with its results in `folder`; settings are KEY=VALUE, as for a scenario.

    Raises:
        ScenarioError: something that is named is not there, or the place has no road.
    """
    root = compose_text(race_text(race), "race")
    apply_settings(root, [parse_setting(text) for text in settings])
    plan = plan_scenario(Path.cwd() / f"{race.name}.yaml", read(Scenario, root), folder)
    return dataclasses.replace(plan, settings=tuple(settings))


def race_text(race: Race, beside: Optional[Path] = None) -> str:
    """The race as a scenario file would have it.

    If that file is to be in the folder `beside`, files are named so that it can be moved with them.

    Raises:
        ScenarioError: as plan_race.
    """
    scenario = _describe(race)
    if beside:
        scenario = _portable(scenario, beside)
    return yaml.safe_dump(scenario, sort_keys=False, width=110)


def save_race(race: Race, file: Path) -> None:
    """Write the race as a scenario file.

    Raises:
        ScenarioError: as plan_race, or the file cannot be written.
    """
    with writing(file), replacing(file) as temporary:
        temporary.write_text(race_text(race, file.parent), encoding="utf-8")


def _portable(scenario: dict[str, Any], beside: Path) -> dict[str, Any]:
    world = scenario["world"]
    # The one file that is not named by a package.
    named = lookup.relative(Path(world), beside) if lookup.is_path(world) else world
    return _with_portable_paths(scenario, beside) | {"world": named}


def _with_portable_paths(value: Any, beside: Path) -> Any:
    if isinstance(value, dict):
        return {key: _with_portable_paths(each, beside) for key, each in value.items()}
    if isinstance(value, list):
        return [_with_portable_paths(each, beside) for each in value]
    return lookup.portable(value, beside) if isinstance(value, str) else value


def _describe(race: Race) -> dict[str, Any]:
    place = find_place(lookup.world_file(race.place, Path.cwd()))
    laps = "A lap" if race.laps == 1 else f"{race.laps} laps"
    timeout = race.timeout
    if timeout is None:
        timeout = math.ceil(10 * (_STARTING + race.laps * _length(place) / _SLOWEST)) / 10
    names = " against ".join(Path(driver.name).name for driver in race.planners)
    return {
        "description": f"{laps} of {place.world.stem}, driven by {names}.",
        "world": str(place.world) if lookup.is_path(race.place) else race.place,
        "cars": [_car(race, place, number, driver) for number, driver in enumerate(race.planners)],
        "limits": {"timeout": timeout, "wall": 300.0 + 2 * timeout},
        "expected": "success",
        "seed": _SEED,
    }


def _car(race: Race, place: Place, number: int, driver: Driver) -> dict[str, Any]:
    start = place.start()
    across = _BESIDE * ((len(race.planners) - 1) / 2 - number)
    yaw = start.yaw
    beside = firm(start.x - across * math.sin(yaw), start.y + across * math.cos(yaw), yaw)
    return {
        "name": f"robot{number + 1}",
        "start": {"x": beside.x, "y": beside.y, "yaw": beside.yaw},
        "driver": driver.name if driver in Driver.short_forms().values() else driver.as_dict(),
        "laps": race.laps,
        **({"description": race.description} if race.description else {}),
    }


def _length(place: Place) -> float:
    """Of the road, m."""
    if place.road is None:
        raise ScenarioError(f"a race needs a road: {place.no_road}")
    return read_course(place.road).length
