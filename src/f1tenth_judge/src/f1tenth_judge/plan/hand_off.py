"""What the driver of a car may be told: arguments that its launch file gets if it declares them."""

import json
from typing import Any, Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.car_description import CarDescription
from f1tenth_judge.plan.input_topics import driver_topics, odometry
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.scenario.car import Car

# s, after which the start signal is surely given: the countdown begins with the first period, not at 0.
_START_MARGIN = 0.1
# What a scenario lacks if it has no value for an argument.
_LACKS = {
    "goals_file": "the key 'goals'",
    "line": "the key 'line'",
    "commands": "the key 'commands'",
    "map_file": "a map, and there is none beside the world or in ../maps",
}


def offered_arguments(plan: Plan, car: Car) -> dict[str, Any]:
    """Names and values, without those that the scenario has no value for; see docs/extending.md."""
    opponent = opponent_of(plan, car)
    offered = {
        "car_name": car.name,
        "goals_file": plan.goals_file(car.name),
        # One more than are counted: a car that stops at the last goal would not cross the line behind it.
        "laps": car.laps + 1 if car.laps else plan.scenario.laps,
        "line": plan.cars[car.name].line,
        "road": plan.place.road_for(car.driver),
        "map_file": plan.place.map,
        "speed_max": car.speed_max,
        "acceleration_max": car.acceleration_max,
        "commands": _commands(car) if car.commands else None,
        "time_to_start": plan.scenario.time_to_start,
        "start_at": plan.scenario.time_to_start + _START_MARGIN if plan.has_countdown else 0.0,
        # Where time does not wait, it is not known beforehand when the countdown begins.
        "await_start": plan.has_countdown and not plan.scenario.lockstep,
        "lockstep": plan.scenario.lockstep,
        "odometry": odometry(plan),
        "localization": plan.scenario.localization.value,
        "seed": plan.scenario.seed,
        "opponent": opponent and opponent.name,
        **_described(plan.cars[car.name].description),
        **{f"{each.value}_topic": topic for each, topic in driver_topics(plan, car).items()},
    }
    return {name: value for name, value in offered.items() if value is not None}


def driver_arguments(plan: Plan, car: Car) -> dict[str, Any]:
    """What the car's driver is told.

    Raises:
        ScenarioError: it needs something that the scenario does not give it, or what it gives cannot be told.
    """
    file = plan.cars[car.name].driver
    offered = offered_arguments(plan, car).items()
    told = {name: value for name, value in offered if name in file.arguments} | given_arguments(plan, car)
    for name in sorted(file.required):
        if name not in told:
            what = _LACKS.get(name, f"a value for its argument '{name}'")
            raise ScenarioError(f"{car.name}: the driver '{car.driver.name}' needs {what}")
    return told


def given_arguments(plan: Plan, car: Car) -> dict[str, str]:
    """What the scenario itself gives the driver, with the paths of the files that it names.

    Raises:
        ScenarioError: a file of a package is not there, or roslaunch would make something else of a text.
    """
    return {name: _told(plan, car, name, text) for name, text in car.driver.arguments.items()}


def _told(plan: Plan, car: Car, name: str, text: str) -> str:
    place = f"{car.name}: argument '{name}'"
    if "$(" in text:
        raise ScenarioError(
            f"{place}: '{text}': roslaunch would put something else in the place of '$(';"
            " use package://PACKAGE/PATH for a file of a package"
        )
    try:
        return lookup.file_or_text(text, plan.file.parent)
    except ScenarioError as error:
        raise ScenarioError(f"{place}: {error}") from error


def _described(description: Optional[CarDescription]) -> dict[str, Any]:
    """What a driver may want to know of a car that is not the F1/10 car."""
    if description is None:
        return {}
    return {
        "wheelbase": description.wheelbase,
        "steering_max": description.dynamics["steering_max"],
        "footprint": json.dumps(description.footprint),
        "cmd_vel_steers": description.takes_steering_angle,
        "odom_period": description.odometry_period,
    }


def opponent_of(plan: Plan, car: Car) -> Optional[Car]:
    """The first other car; nothing for one that is alone."""
    return next((each for each in plan.scenario.cars if each is not car), None)


def _commands(car: Car) -> str:
    keys = ("at", "speed", "steering_angle")
    return json.dumps([{key: getattr(each, key) for key in keys} for each in car.commands])
