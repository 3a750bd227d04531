"""Our drivers that exist as classes, too: one run has planners of one kind."""

import dataclasses
from pathlib import Path

from f1tenth_judge.scenario.car import Car
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.scenario.scenario import Scenario

_PURSUIT = Path(__file__).parents[1] / "drivers" / "python" / "pursuit.py"
_TWINS = {"pursuit": Driver(python=f"{_PURSUIT}:Pursuit")}


def with_twins(scenario: Scenario) -> Scenario:
    """The scenario, its launch files of ours replaced by classes where another planner needs no ROS 1."""
    if all(car.driver.launch for car in scenario.cars):
        return scenario
    return dataclasses.replace(scenario, cars=tuple(map(_twin, scenario.cars)))


def _twin(car: Car) -> Car:
    return dataclasses.replace(car, driver=_TWINS.get(car.driver.name, car.driver))
