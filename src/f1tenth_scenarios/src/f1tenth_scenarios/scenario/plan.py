"""A scenario with everything that it names found and read: ready to run."""

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import Optional

from f1tenth_scenarios import places
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.scenario.course import Course, read_course
from f1tenth_scenarios.scenario.goals import read_goals
from f1tenth_scenarios.scenario.raceline import read_raceline
from f1tenth_scenarios.scenario.scenario import Driver, Localization, Pose, Scenario, read_scenario
from f1tenth_scenarios.scenario.scenario_world import check_boxes
from f1tenth_scenarios.scenario.settings import apply_settings, parse_setting


@dataclasses.dataclass(frozen=True)
class Plan:
    """What a run needs to know."""

    name: str
    file: Path
    scenario: Scenario
    world: Path
    map: Optional[Path]  # YAML
    goals_files: dict[str, Path]  # per car that races
    goals: dict[str, tuple[Pose, ...]]  # per car that races, of one lap
    folder: Path  # for the results
    course: Optional[Course] = None
    settings: tuple[str, ...] = ()  # KEY=VALUE, set from outside of the file
    keep_bag: bool = False  # also if the run passes
    lines: dict[str, Path] = dataclasses.field(default_factory=dict)  # per car that pursues one

    @property
    def run_world(self) -> Path:
        """The world that is simulated: with the scenario's boxes."""
        return self.log_folder / "boxes.world" if self.scenario.boxes else self.world

    def vehicle_file(self, car: str) -> Path:
        """Parameters of a car that differs from the F1/10 car."""
        return self.log_folder / f"{car}.yaml"

    @property
    def log_folder(self) -> Path:
        """Where the processes write."""
        return self.folder / "log"

    @property
    def record_file(self) -> Path:
        """What the simulator records, uncut."""
        return self.log_folder / "record.csv"

    @property
    def bag_file(self) -> Path:
        """What was said on topics."""
        return self.log_folder / "run.bag"

    @property
    def simulator_result_file(self) -> Path:
        """What the simulator says at its end."""
        return self.log_folder / "simulator.json"

    @property
    def launch_file(self) -> Path:
        """What roslaunch starts."""
        return self.log_folder / "run.launch"

    @property
    def launch_log(self) -> Path:
        """The output of roslaunch, and what the nodes write to stderr."""
        return self.log_folder / "roslaunch.log"

    @property
    def all_goals(self) -> dict[str, tuple[Pose, ...]]:
        """Per car that races, the goals of all laps."""
        return {car: goals * self.scenario.laps for car, goals in self.goals.items()}


def make_plan(name: str, folder: Optional[Path] = None, settings: Sequence[str] = ()) -> Plan:
    """Read a scenario and check everything that it names.

    Args:
        name: of a scenario of this package, or the path of a scenario file
        folder: for the results, default results/NAME
        settings: KEY=VALUE, values that replace those of the file

    Raises:
        ScenarioError: with the place and what is allowed there.
    """
    file = places.scenario_file(name)
    parsed = [parse_setting(text) for text in settings]
    scenario = read_scenario(file, lambda root: apply_settings(root, parsed))
    try:
        plan = _find_files(file, scenario, folder or places.results_folder(file.stem))
        return dataclasses.replace(plan, settings=tuple(settings))
    except ScenarioError as error:
        raise ScenarioError(f"{file}: {error}") from error


def _find_files(file, scenario, folder):
    goals_files = {
        car.name: places.goals_file(car.goals or scenario.world, file.parent)
        for car in scenario.cars
        if car.driver is Driver.RACE
    }
    lines = {
        car.name: places.course_file(car.line or scenario.world, file.parent)
        for car in scenario.cars
        if car.driver is Driver.PURSUIT
    }
    for path in lines.values():
        read_raceline(path)
    goals = {car: tuple(read_goals(path)) for car, path in goals_files.items()}
    world = places.world_file(scenario.world, file.parent)
    map_file = places.map_file(world)
    if goals and map_file is None:
        raise ScenarioError(f"the driver 'race' needs a map, and {world} has none beside it or in ../maps")
    if scenario.localization is Localization.AMCL and map_file is None:
        raise ScenarioError(f"'localization: amcl' needs a map, and {world} has none beside it or in ../maps")
    check_boxes(world, scenario)
    course = read_course(places.course_file(scenario.course, file.parent)) if scenario.course else None
    return Plan(file.stem, file, scenario, world, map_file, goals_files, goals, folder, course, lines=lines)
