"""What a driver's launch file would set of the run: simulator, judge and car are not its own."""

import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.participants import PROXY_DRIVER
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.scenario.car import Car

from f1tenth_scenarios.launch.bag import RECORDER

# Nodes of the run, of all cars and of each; a test compares them with what the launch files start.
RUN_NODES = ("sim2d", "map_server", "race_starter", RECORDER)
CAR_NODES = (
    "collision_detection",
    "robot_state_publisher",
    "beam_dropper",
    "faulty_inputs",
    "map_to_odom",
    PROXY_DRIVER,
)
_TIME = "/use_sim_time"


def check_parameters(plan: Plan, groups: Mapping[str, ElementTree.Element]) -> None:
    """Refuse drivers that set what is not theirs; `groups`: how each car's driver is started, by car.

    What roslaunch cannot read it says itself, with the place.

    Raises:
        ScenarioError: with the parameter and the file.
    """
    for car in plan.scenario.cars:
        if car.driver.is_ours:
            continue
        for what in _not_its_own(plan, car, *_parameters(groups[car.name])):
            raise ScenarioError(
                f"{plan.cars[car.name].driver.path}: {what}, which is the run's;"
                f" a driver's parameters are those below /{car.name} that no node of the run has"
            )


def _not_its_own(
    plan: Plan, car: Car, parameters: Mapping[str, Any], deleted: Sequence[str]
) -> Iterator[str]:
    others = tuple(each.name for each in plan.scenario.cars if each.name != car.name)
    taken = [f"/{name}/" for name in (*RUN_NODES, *others, *(f"{car.name}/{node}" for node in CAR_NODES))]
    for name, value in parameters.items():
        if name == _TIME and value is not True:
            yield f"sets the parameter {name} to {value}"
        elif any(f"{name}/".startswith(each) for each in taken):
            yield f"sets the parameter {name}"
    for name in deleted:
        tree = f"{name.rstrip('/')}/"
        if any(tree.startswith(each) or each.startswith(tree) for each in (*taken, f"{_TIME}/")):
            yield f"deletes the parameter {tree[:-1] or '/'}"


def _parameters(group: ElementTree.Element) -> tuple[dict[str, Any], list[str]]:
    """What a part of a launch file sets and deletes, by whole names; nothing if roslaunch cannot read it."""
    import roslaunch.config
    import roslaunch.xmlloader

    class Loader(roslaunch.xmlloader.XmlLoader):
        """Runs no command of the file: that is for the run, which ends what it has started."""

        def param_value(self, verbose, name, ptype, value, textfile, binfile, command):
            """See there."""
            if command is not None:
                return ""
            return super().param_value(verbose, name, ptype, value, textfile, binfile, command)

    launch = ElementTree.Element("launch")
    launch.append(group)
    config = roslaunch.config.ROSLaunchConfig()
    loader = Loader()
    try:
        loader.load_string(ElementTree.tostring(launch, encoding="unicode"), config, verbose=False)
    except Exception:  # of many kinds, as launch files may hold Python
        return {}, []
    deleted = [each.args[1] for each in config.executables if each.args[0] == "delete"]
    return {name: each.value for name, each in config.params.items()}, deleted
