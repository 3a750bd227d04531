"""Another planner in place of ours, in any scenario in which that makes sense."""

import dataclasses
from pathlib import Path
from typing import Optional

import yaml

from f1tenth_judge.errors import FileError, NotApplicableError, as_scenario_error
from f1tenth_judge.places import lookup
from f1tenth_judge.places.place import find_place
from f1tenth_judge.plan.driver_file import DriverFile, driver_file
from f1tenth_judge.scenario.car import Car
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.scenario.scenario import Scenario, Verdict
from f1tenth_judge.yaml_files.schema import read

PLANNER = "planner"  # what settings call it


def planner_setting(planner: Driver) -> str:
    """The setting KEY=VALUE for a planner."""
    return f"{PLANNER}={driver_text(planner)}"


def driver_text(driver: Driver) -> str:
    """A driver as a scenario file describes it, in one line."""
    return yaml.safe_dump(driver.as_dict(), default_flow_style=True, width=float("inf")).strip()


@as_scenario_error(FileError)
def with_planner(scenario: Scenario, node: yaml.Node, beside: Path) -> Scenario:
    """The scenario with another planner in all cars that are driven by ours, else by somebody else's.

    `node` describes it, as a scenario file describes a driver; its path is relative to `beside`.

    Raises:
        NotApplicableError: the scenario says nothing about a planner that is not ours.
        ScenarioError: there is no such driver.
    """
    planner = read(Driver, node, PLANNER)
    file = driver_file(planner, beside)
    tested = _tested(scenario)
    _require_sense(scenario, file, tested)
    circuit = _circuit(scenario, beside)
    cars = (
        _replaced(scenario, car, planner, file, circuit) if car.name in tested else car
        for car in scenario.cars
    )
    return dataclasses.replace(scenario, cars=tuple(cars))


def _tested(scenario: Scenario) -> list[str]:
    """The cars whose planner the scenario tests: ours, else that of whoever wrote it."""
    ours = [car.name for car in scenario.cars if car.driver.is_reference]
    return ours or [car.name for car in scenario.cars if not car.driver.is_ours]


def _require_sense(scenario: Scenario, file: DriverFile, tested: list[str]) -> None:
    if not tested:
        drivers = ", ".join(dict.fromkeys(car.driver.name for car in scenario.cars))
        raise NotApplicableError(f"no planner drives in it, only: {drivers}")
    for fault in scenario.faults:
        if fault.kill.partition("/")[0] in tested:
            raise NotApplicableError(f"it kills {fault.kill}, a node of another planner")
    if scenario.expected is not Verdict.SUCCESS:
        raise NotApplicableError(
            f"it expects '{scenario.expected.value}', which says nothing about another planner"
        )
    if scenario.time_to_start != Scenario.time_to_start and "time_to_start" not in file.arguments:
        raise NotApplicableError("it is about the countdown, and the planner has no argument 'time_to_start'")


def _circuit(scenario: Scenario, beside: Path) -> Optional[str]:
    """The circuit that the world is, by whose name its goals are found; other places have none."""
    place = find_place(lookup.world_file(scenario.world, beside))
    return place.world.stem if place.is_circuit else None


def _replaced(scenario: Scenario, car: Car, planner: Driver, file: DriverFile, circuit: Optional[str]) -> Car:
    goals = car.goals or (None if car.laps else circuit)
    replaced = dataclasses.replace(
        car,
        driver=planner,
        goals=goals,
        speed_max=car.speed_max if "speed_max" in file.arguments else None,
        acceleration_max=car.acceleration_max if "acceleration_max" in file.arguments else None,
    )
    if goals and "goals_file" in file.arguments:
        return replaced
    if goals not in (None, circuit, scenario.world):
        raise NotApplicableError("it is about goals, and the planner has no argument 'goals_file'")
    # A car that is given no goals is judged by the laps that they stand for.
    return dataclasses.replace(replaced, goals=None, laps=car.laps or scenario.laps)
