"""The launch file of a run: one that a person can start again with `roslaunch log/run.launch`."""

import json
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.places.goals import goals_text
from f1tenth_judge.plan.hand_off import driver_arguments, opponent_of
from f1tenth_judge.plan.input_topics import (
    absolute,
    driver_topics,
    filtered_topics,
    odometry,
    published_topics,
    usual_topics,
)
from f1tenth_judge.plan.participants import PROXY_DRIVER, driver_participants, has_proxy_driver, participants
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.plan.scenario_world import write_world
from f1tenth_judge.scenario.car import Car, Input
from f1tenth_judge.scenario.driver import Interface

from f1tenth_scenarios.launch.bag import RECORDER, recorder_parameters
from f1tenth_scenarios.launch.foreign_parameters import check_parameters

# What takes time and is of no use here is left out; timeouts in wall s, for each node.
_OPTIONS = (
    "--skip-log-check",
    "--no-summary",
    "--disable-title",
    "--sigint-timeout=3",
    "--sigterm-timeout=0.5",
)
# Topics of f1tenth_simulator and f1tenth_gym_ros, which give the true pose as odometry: ours for the driver's
# car, and for its opponent.
F1TENTH_OWN = {
    "/scan": "scan",
    "/drive": "drive",
    "/nav": "drive",
    "/odom": "perfect_odom",
    "/ego_racecar/odom": "perfect_odom",
    "/gt_pose": "gt_pose",
}
_TWIST = "cmd_vel"  # where the F1/10 car takes geometry_msgs/Twist
_F1TENTH_OPPONENT = {"/opp_scan": "scan", "/opp_drive": "drive", "/opp_racecar/odom": "perfect_odom"}


def launch_command(file: Path) -> list[str]:
    """The command that starts the nodes of a launch file, and ends them when it is interrupted.

    Its environment must have the variables of LaunchEvents.
    """
    return [sys.executable, "-m", "f1tenth_scenarios.launch.launcher", *_OPTIONS, str(file)]


def write_launch_file(plan: Plan) -> None:
    """Write the launch file that starts everything the scenario describes, and the files it names.

    Raises:
        ScenarioError: roslaunch would take something for what it is not, or a driver sets what is the run's.
    """
    if plan.scenario.boxes:
        write_world(plan.place.world, plan.scenario, plan.run_world)
    for car in plan.scenario.cars:
        if description := plan.cars[car.name].description:
            plan.description_file(car.name).write_text(description.text, encoding="utf-8")
        if vehicle := _vehicle(plan, car):
            plan.vehicle_file(car.name).write_text(vehicle, encoding="utf-8")
        goals_file = plan.goals_file(car.name)
        if goals_file and not plan.cars[car.name].goals_file:
            goals_file.write_text(goals_text(plan.cars[car.name].goals), encoding="utf-8")
    launch = ElementTree.Element("launch")
    # What a command in a driver's launch file has set by then is not the run's.
    ElementTree.SubElement(launch, "group", ns="sim2d", clear_params="true")
    _include(launch, _own("scenario.launch"), _shared_arguments(plan))
    drivers = {car.name: _driver(plan, car) for car in plan.scenario.cars}
    check_parameters(plan, drivers)
    for car in plan.scenario.cars:
        # Before its car: of two values of a parameter, as robot_description, roslaunch takes the later.
        launch.append(drivers[car.name])
        _include(launch, _own("scenario_car.launch"), _car_arguments(plan, car))
        if has_proxy_driver(plan, car.name):
            _include(launch, _own("proxy_driver.launch"), _proxy_driver_arguments(plan, car))
    launch.append(_recorder(plan))
    ElementTree.indent(launch)
    ElementTree.ElementTree(launch).write(plan.launch_file, encoding="utf-8")


def _shared_arguments(plan: Plan) -> dict[str, Any]:
    scenario = plan.scenario
    return {
        "world_file_name": plan.run_world,
        "map_file": plan.place.map or "",
        "lockstep": scenario.lockstep,
        "participants": f"[{', '.join(participants(plan))}]",
        "lockstep_timeout": _lockstep_timeout(plan),
        "real_time_factor": scenario.real_time_factor,
        "seed": scenario.seed,
        "record": plan.record_file,
        "interventions": plan.interventions_file,
        "odometry": odometry(plan),
        "result_file": plan.simulator_result_file,
        "race": plan.has_countdown,
        "time_to_start": scenario.time_to_start,
    }


def _lockstep_timeout(plan: Plan) -> float:
    """Longer than a proxy driver's patience, as it must say what it found before it is given up itself."""
    limits = plan.scenario.limits
    return limits.answer + (limits.load if any(has_proxy_driver(plan, car) for car in plan.cars) else 0.0)


def _car_arguments(plan: Plan, car: Car) -> dict[str, Any]:
    start, topics = plan.cars[car.name].start, published_topics(plan, car)
    return {
        "car_name": car.name,
        "frame_prefix": f"{frame_prefix(plan, car)}/",
        "x": start.x,
        "y": start.y,
        "yaw": start.yaw,
        "lockstep": plan.scenario.lockstep,
        "planner": driver_participants(plan, car.name)[0],
        "description": plan.description_file(car.name) if plan.cars[car.name].description else "",
        "vehicle": plan.vehicle_file(car.name) if _vehicle(plan, car) else "",
        "scan_topic": topics[Input.SCAN],
        "odom_topic": topics[Input.ODOM],
        "dropped_beams": car.dropped_beams,
        "input_faults": json.dumps(_faults(car)),
        "odometry": odometry(plan),
        "localization": plan.scenario.localization.value,
        "seed": plan.scenario.seed,
        "wheels": plan.watched,
    }


def frame_prefix(plan: Plan, car: Car) -> str:
    """What stands before the frames of a car; nothing, as in f1tenth_simulator, if its driver is alone."""
    alone = car.driver.interface is Interface.F1TENTH and len(plan.scenario.cars) == 1
    return "" if alone else car.name


def _proxy_driver_arguments(plan: Plan, car: Car) -> dict[str, Any]:
    return {
        "car_name": car.name,
        "driver_mark": driver_mark(plan, car),
        "driver_patience": plan.scenario.limits.answer,
        "driver_loading": plan.scenario.limits.load,
        "scan_topic": filtered_topics(plan, car)[Input.SCAN],
        "localization": plan.scenario.localization.value,
    }


def _vehicle(plan: Plan, car: Car) -> str:
    """What the scenario changes of the car's parameters, as their YAML file; empty if nothing."""
    changes = car.vehicle_changes()
    description = plan.cars[car.name].description
    if changes and description:
        # What such a file does not say is the F1/10 car's, whatever the description says.
        changes = description.dynamics | changes
    return "".join(f"{name}: {value}\n" for name, value in changes.items())


def driver_mark(plan: Plan, car: Car) -> str:
    """NAME=VALUE in the environment of the driver's processes, and of no other's."""
    return f"F1TENTH_DRIVER={car.name} of {plan.folder}"


def _faults(car: Car) -> list[dict[str, Any]]:
    """The parameter `faults` of the node `faulty_inputs`."""
    faults = [(each.value, fault) for each in Input for fault in car.faults_of(each)]
    return [
        {"input": name, "at": fault.at, "until": fault.until}
        | ({} if fault.delay is None else {"delay": fault.delay})
        for name, fault in faults
    ]


def _driver(plan: Plan, car: Car) -> ElementTree.Element:
    """What starts the driver of a car."""
    file = str(plan.cars[car.name].driver.path)
    group = ElementTree.Element("group", ns=car.name)
    name, value = driver_mark(plan, car).split("=", 1)
    ElementTree.SubElement(group, "env", name=name, value=value)
    for old, new in _remappings(plan, car).items():
        ElementTree.SubElement(group, "remap", {"from": old, "to": new})
    _check_text(file)
    _include(group, file, driver_arguments(plan, car))
    return group


def _remappings(plan: Plan, car: Car) -> dict[str, str]:
    """The topics that have other names for the driver of a car."""
    own = f"/{car.name}"
    usual, actual = usual_topics(plan), driver_topics(plan, car)
    known = usual if car.driver.is_ours else published_topics(plan, car)
    taken = plan.cars[car.name].driver.arguments
    found = {
        absolute(own, known[each]): absolute(own, actual[each])
        for each in Input
        if known[each] != actual[each] and f"{each.value}_topic" not in taken
    }
    description = plan.cars[car.name].description
    twist = description and description.twist
    if car.driver.is_ours and twist and twist != _TWIST:
        found[f"{own}/{_TWIST}"] = absolute(own, twist)
    if car.driver.interface is Interface.F1TENTH:
        found |= _by_name(own, F1TENTH_OWN, usual, actual)
        if opponent := opponent_of(plan, car):
            theirs = published_topics(plan, opponent)
            found |= _by_name(f"/{opponent.name}", _F1TENTH_OPPONENT, usual, theirs)
    if has_proxy_driver(plan, car.name):
        found["/clock"] = f"{own}/{PROXY_DRIVER}/clock"
    return found


def _by_name(
    namespace: str, names: Mapping[str, str], usual: Mapping[Input, str], actual: Mapping[Input, str]
) -> dict[str, str]:
    """Others' names for topics in a car's namespace, with the topics that take their place."""
    topics = {usual[each]: actual[each] for each in Input}
    return {old: absolute(namespace, topics.get(new, new)) for old, new in names.items()}


def _recorder(plan: Plan) -> ElementTree.Element:
    """What writes the bag."""
    node = ElementTree.Element("node", pkg=lookup.PACKAGE, type="bag_recorder", name=RECORDER)
    parameters = recorder_parameters(plan.bag_file, list(plan.cars), _topics_of_descriptions(plan))
    ElementTree.SubElement(node, "rosparam").text = json.dumps(parameters)
    return node


def _topics_of_descriptions(plan: Plan) -> list[str]:
    """Those of cars with their own descriptions, besides the usual ones."""
    descriptions = {name: car.description for name, car in plan.cars.items() if car.description}
    own = {name: (each.scan, each.twist) for name, each in descriptions.items()}
    found = {absolute(f"/{name}", topic) for name, topics in own.items() for topic in topics if topic}
    usual = {f"/{name}/{topic}" for name in own for topic in ("scan", _TWIST)}
    return sorted(found - usual)


def _include(parent: ElementTree.Element, file: str, arguments: Mapping[str, Any]) -> None:
    include = ElementTree.SubElement(parent, "include", file=file)
    for key, value in arguments.items():
        text = str(value).lower() if isinstance(value, bool) else str(value)
        _check_text(text)
        ElementTree.SubElement(include, "arg", name=key, value=text)


def _check_text(text: str) -> None:
    if "$(" in text:
        raise ScenarioError(f"'{text}': roslaunch would put something else in the place of '$('; rename it")


def _own(name: str) -> str:
    return f"$(find {lookup.PACKAGE})/launch/{name}"
