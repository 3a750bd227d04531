"""The launch file of a run: one that a person can start again with `roslaunch log/run.launch`."""

import json
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

from f1tenth_scenarios import places
from f1tenth_scenarios.record.bag import RECORDER, recorder_arguments
from f1tenth_scenarios.scenario.participants import participants
from f1tenth_scenarios.scenario.plan import Plan
from f1tenth_scenarios.scenario.scenario import Car, Driver, Input, Localization, Scenario
from f1tenth_scenarios.scenario.scenario_world import write_world

# s, after which the start signal is surely given: the countdown begins with the first period, not at 0.
_START_MARGIN = 0.1
# What takes time and helps nobody here is left out; timeouts in wall s, for each node.
_OPTIONS = (
    "--skip-log-check",
    "--no-summary",
    "--disable-title",
    "--sigint-timeout=4",
    "--sigterm-timeout=2",
)


def launch_command(file: Path) -> list[str]:
    """The command that starts the nodes of a launch file, and ends them when it is interrupted."""
    return ["roslaunch", *_OPTIONS, str(file)]


def write_launch_file(plan: Plan) -> None:
    """Write the launch file that starts everything the scenario describes, and the files it names."""
    if plan.scenario.boxes:
        write_world(plan.world, plan.scenario, plan.run_world)
    for car in plan.scenario.cars:
        if vehicle := _vehicle(car):
            plan.vehicle_file(car.name).write_text(vehicle, encoding="utf-8")
    launch = ElementTree.Element("launch")
    _include(launch, "scenario.launch", _shared_arguments(plan))
    for car in plan.scenario.cars:
        _include(launch, "scenario_car.launch", _car_arguments(plan, car))
    cars = [car.name for car in plan.scenario.cars]
    arguments = recorder_arguments(plan.bag_file, cars)
    ElementTree.SubElement(launch, "node", pkg="rosbag", type="record", name=RECORDER, args=arguments)
    ElementTree.indent(launch)
    ElementTree.ElementTree(launch).write(plan.launch_file, encoding="utf-8")


def _shared_arguments(plan: Plan) -> dict[str, Any]:
    scenario = plan.scenario
    return {
        "world_file_name": plan.run_world,
        "map_file": plan.map or "",
        "lockstep": scenario.lockstep,
        "participants": f"[{', '.join(participants(scenario))}]",
        "lockstep_timeout": scenario.limits.answer,
        "real_time_factor": scenario.real_time_factor,
        "seed": scenario.seed,
        "record": plan.record_file,
        "odometry": _odometry(scenario),
        "result_file": plan.simulator_result_file,
        "race": any(car.driver is Driver.RACE for car in scenario.cars),
        "time_to_start": scenario.time_to_start,
    }


def _car_arguments(plan: Plan, car: Car) -> dict[str, Any]:
    return {
        "car_name": car.name,
        "x": car.start.x,
        "y": car.start.y,
        "yaw": car.start.yaw,
        "lockstep": plan.scenario.lockstep,
        "driver": car.driver.value,
        "goals_file": plan.goals_files.get(car.name, ""),
        "loop_mode": plan.scenario.laps > 1,
        "scenario_file": plan.file,
        "line": plan.lines.get(car.name, ""),
        "speed_max": "" if car.speed_max is None else car.speed_max,
        "acceleration_max": "" if car.acceleration_max is None else car.acceleration_max,
        "start_at": plan.scenario.time_to_start + _START_MARGIN if plan.goals else 0.0,
        "vehicle": plan.vehicle_file(car.name) if _vehicle(car) else "",
        "dropped_beams": car.dropped_beams,
        "faulty_inputs": " ".join(each.value for each in Input if car.faults_of(each)),
        "input_faults": json.dumps(_faults(car)),
        "odometry": _odometry(plan.scenario),
        "localization": plan.scenario.localization.value,
        "seed": plan.scenario.seed,
    }


def _vehicle(car: Car) -> str:
    """What the scenario changes of the car's parameters, as their YAML file; empty if nothing."""
    mu = "" if car.mu is None else f"mu: {car.mu!r}\n"
    return mu + ("" if car.model is None else f"model: {car.model.value}\n")


def _faults(car: Car) -> list[dict[str, Any]]:
    """The parameter `faults` of the node `faulty_inputs`."""
    faults = [(each.value, fault) for each in Input for fault in car.faults_of(each)]
    return [
        {"input": name, "at": fault.at, "until": fault.until}
        | ({} if fault.delay is None else {"delay": fault.delay})
        for name, fault in faults
    ]


def _odometry(scenario: Scenario) -> str:
    return "wheel" if scenario.localization is Localization.AMCL else "perfect"


def _include(launch: ElementTree.Element, name: str, arguments: dict[str, Any]) -> None:
    file = f"$(find {places.PACKAGE})/launch/{name}"
    include = ElementTree.SubElement(launch, "include", file=file)
    for key, value in arguments.items():
        text = str(value).lower() if isinstance(value, bool) else str(value)
        ElementTree.SubElement(include, "arg", name=key, value=text)
