"""Making a plan of a scenario."""

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.places.course import Course, read_course
from f1tenth_judge.places.place import Place, find_place
from f1tenth_judge.plan.car_description import check_car, check_topics
from f1tenth_judge.plan.car_plan import Surroundings, plan_car
from f1tenth_judge.plan.driver_file import find_driver
from f1tenth_judge.plan.hand_off import driver_arguments
from f1tenth_judge.plan.participants import originals_among, participants
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.plan.planner import PLANNER, with_planner
from f1tenth_judge.plan.scenario_world import check_boxes
from f1tenth_judge.plan.source import read_scenario
from f1tenth_judge.plan.twins import with_twins
from f1tenth_judge.plan.without_ros import check_without_ros
from f1tenth_judge.scenario.scenario import Localization, Scenario, Verdict
from f1tenth_judge.scenario.settings import apply_settings, parse_setting
from f1tenth_judge.scenario.yaml_text import compose_text


def in_real_time(plan: Plan, why: str) -> Plan:
    """The same run without lockstep, because a driver does not fit it."""
    scenario = dataclasses.replace(plan.scenario, lockstep=False, real_time_factor=1.0)
    return dataclasses.replace(plan, scenario=scenario, note=f"run in real time, as {why}")


def make_plan(name: str, folder: Optional[Path] = None, settings: Sequence[str] = ()) -> Plan:
    """Read a scenario and check everything that it names.

    Args:
        name: of a scenario that is found by its name, or the path of a scenario file
        folder: for the results, default results/NAME
        settings: KEY=VALUE, values that replace those of the file; `planner` takes the place of ours

    Raises:
        NotApplicableError: the scenario says nothing about this planner.
        ScenarioError: with the place and what is allowed there.
    """
    file = lookup.scenario_file(name)
    parsed = [parse_setting(text) for text in settings]
    own = [each for each in parsed if each.key != PLANNER]
    scenario = read_scenario(file, lambda root: apply_settings(root, own))
    try:
        for planner in (each for each in parsed if each.key == PLANNER):
            scenario = with_planner(scenario, compose_text(planner.value, str(planner)), file.parent)
        plan = plan_scenario(file, scenario, folder or lookup.results_root() / file.stem)
        return dataclasses.replace(plan, settings=tuple(settings))
    except ScenarioError as error:
        raise type(error)(f"{file}: {error}") from error


def plan_scenario(file: Path, scenario: Scenario, folder: Path) -> Plan:
    """Find and read everything that a scenario names.

    `file`, where it is from, names the run, and paths are relative to its folder; results go to `folder`.

    Raises:
        ScenarioError: what is wrong.
    """
    if not file.stem.isprintable():
        raise ScenarioError(
            f"{file.stem!r} cannot be the name of a run: it has characters that are not printed"
        )
    scenario = with_twins(scenario)
    place = find_place(lookup.world_file(scenario.world, file.parent))
    check_boxes(place.world, scenario)
    drivers = {car.name: find_driver(car, file.parent) for car in scenario.cars}
    has_countdown = any(each.needs_countdown for each in drivers.values())
    course = _course(scenario, place, file.parent)
    around = Surroundings(scenario, place, course, file.parent, has_countdown)
    cars = {car.name: plan_car(car, drivers[car.name], around) for car in scenario.cars}
    plan = Plan(file.stem, file, scenario, place, cars, folder, course)
    _check(plan)
    if not plan.needs_ros:
        return plan
    originals = " and ".join(originals_among(participants(plan)))
    return in_real_time(plan, f"the original of {originals} knows no lockstep") if originals else plan


def _course(scenario: Scenario, place: Place, beside: Path) -> Optional[Course]:
    path = lookup.course_file(scenario.course, beside) if scenario.course else place.road
    return read_course(path) if path else None


def _check(plan: Plan) -> None:
    scenario = plan.scenario
    check_without_ros(plan)
    for car in scenario.cars:
        driver_arguments(plan, car)
        if description := plan.cars[car.name].description:
            check_car(car, description, scenario.localization)
    check_topics({name: car.description for name, car in plan.cars.items() if car.description})
    if scenario.localization is Localization.AMCL and plan.place.map is None:
        raise ScenarioError(
            f"'localization: amcl' needs a map, and {plan.place.world} has none beside it or in ../maps"
        )
    if scenario.expected is Verdict.SUCCESS and all(task.is_empty for task in plan.tasks.values()):
        raise ScenarioError(
            "'expected: success' needs a car with 'goals' or 'laps'; 'laps' outside of 'cars' repeats goals"
        )
