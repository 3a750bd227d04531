"""What the ROS graph shows of drivers that cannot work: topics that lead nowhere, or to another car."""

import dataclasses
from collections.abc import Iterable, Mapping, Sequence
from typing import Callable, Optional

from f1tenth_judge.errors import as_typed
from f1tenth_judge.plan.car_description import CarDescription
from f1tenth_judge.plan.input_topics import absolute
from f1tenth_judge.plan.participants import PROXY_DRIVER, driver_nodes_among
from f1tenth_judge.scenario.driver import Interface

from f1tenth_scenarios.launch.launch_file import F1TENTH_OWN
from f1tenth_scenarios.run.ros_graph import RosGraph

_DRIVE, _TWIST = "ackermann_msgs/AckermannDriveStamped", "geometry_msgs/Twist"


@dataclasses.dataclass(frozen=True)
class CarTopics:
    """What a car takes and publishes; names without a slash in front are in its namespace."""

    commands: Mapping[str, str]  # and their types; none for one that only controllers drive
    sensed: Mapping[str, str]  # by the names that planners use


_SIMULATOR = "sim2d"
# Planners take their odometry for a pose in the map: in f1tenth_simulator it is one, that of wheels is not.
_EXACT = "perfect_odom"
_F1TENTH = CarTopics({"drive": _DRIVE, "cmd_vel": _TWIST}, {"scan": "scan", "odom": _EXACT, "imu": "imu"})
_LIKE_COMMANDS = (_DRIVE, _TWIST, "ackermann_msgs/AckermannDrive", "geometry_msgs/TwistStamped")
_EVERYBODYS = (
    "/tf",
    "/tf_static",
    "/clock",
    "/rosout",
    "/diagnostics",
    "/sim2d/done",
    "/map",
    "/map_metadata",
)
_RVIZ_S = ("initialpose", "move_base_simple/goal", "clicked_point")  # no fault that nobody sends these


def topics_of(description: Optional[CarDescription]) -> CarTopics:
    """Those of a car with a description of its own, or of the F1/10 car."""
    if description is None:
        return _F1TENTH
    commands = {"drive": _DRIVE, description.twist: _TWIST} if description.twist else {}
    return CarTopics(commands, {"scan": description.scan} if description.scan else {})


def driver_nodes(graph: RosGraph, car: str) -> list[str]:
    """The nodes of a car's driver, those that send commands first."""
    first = [node for name in _F1TENTH.commands for node in graph.publishers.get(f"/{car}/{name}", ())]
    return driver_nodes_among(car, dict.fromkeys([*first, *graph.nodes]))


def why_mute(
    graph: RosGraph,
    car: str,
    publications: Iterable[tuple[str, str]],
    interface: Interface,
    topics: CarTopics = _F1TENTH,
    misread: Iterable[tuple[str, str, str]] = (),
) -> list[str]:
    """Why no command of a car's driver may have arrived, in words.

    Args:
        graph, car, interface, topics: who hears whom, and what the planner and the car know
        publications: the topics that its nodes publish, and their types
        misread: topics that its nodes hear as another type than that which is published; both types
    """
    own = {absolute(f"/{car}", name): kind for name, kind in topics.commands.items()}
    published = sorted(set(publications))
    wrong = [f"publishes {kind} on {topic}" for topic, kind in published if own.get(topic, kind) != kind]
    astray = [
        (topic, kind)
        for topic, kind in published
        if kind in _LIKE_COMMANDS and topic not in own and not _is_passed_on(graph, topic)
    ]
    wrong += [f"publishes {kind} on {topic}, which nobody hears" for topic, kind in astray]
    nodes = set(driver_nodes_among(car, graph.nodes))
    silent = [
        topic
        for topic, hearers in sorted(graph.subscribers.items())
        if nodes & set(hearers) and not graph.publishers.get(topic) and not _is_optional(topic)
    ]
    found = [f"hears {_usual(topic)} as {kind}, but it is {right}" for topic, kind, right in misread] + wrong
    if nodes and not wrong:
        found += _missing_ends(graph, nodes, published, own)
    if silent:
        found.append(f"hears {_listed(silent)}, which nobody publishes")
    if wrong and own:
        found.append(f"the car takes {_taken(own)}")
    if not own:
        found.append(
            "the car is driven by controllers, which the planner's launch file is to load and to feed"
        )
    if interface is Interface.NATIVE and nodes & set(graph.subscribers.get("/tf", ())):
        found.append(f"frames of the car in /tf begin with {car}/")
    return found + _ways_out(_remaps(astray, silent, topics), interface)


def _missing_ends(
    graph: RosGraph, nodes: set[str], published: Sequence[tuple[str, str]], own: Mapping[str, str]
) -> list[str]:
    """What a driver lacks that could hear and send: a publisher of commands, any subscriber."""
    sends = any(kind in _LIKE_COMMANDS for _, kind in published)
    sends |= any(nodes & set(graph.publishers.get(topic, ())) for topic in own)
    heard = [topic for topic, hearers in graph.subscribers.items() if nodes & set(hearers)]
    found = [] if sends or not own else [f"publishes no command, which the car takes as {_taken(own)}"]
    return (
        found
        if any(not topic.endswith("/clock") for topic in heard)
        else [*found, "hears no topic, so that no callback runs"]
    )


def _usual(topic: str) -> str:
    """The name by which a planner knows a topic that its proxy driver passes on."""
    return topic.replace(f"/{PROXY_DRIVER}/", "/")


def _taken(own: Mapping[str, str]) -> str:
    return _listed([f"{kind} on {topic}" for topic, kind in own.items()], "or")


def _ways_out(remaps: Mapping[str, str], interface: Interface) -> list[str]:
    """How topics that lead nowhere get to those of the car."""
    if interface is Interface.NATIVE and remaps and F1TENTH_OWN.keys() >= remaps.keys():
        return [as_typed("use --interface f1tenth")]
    if not remaps:
        return []
    lines = "".join(f'<remap from="{topic}" to="{name}"/>' for topic, name in remaps.items())
    why = f" (odom drifts, {_EXACT} is exact)" if _EXACT in remaps.values() else ""
    return [f"in front of its nodes in the launch file, {lines} leads to the car's topics{why}"]


def _remaps(astray: Sequence[tuple[str, str]], silent: Sequence[str], topics: CarTopics) -> dict[str, str]:
    """Which topics of the car are meant, by type or name, by topics that lead nowhere."""
    commands = {kind: name for name, kind in topics.commands.items()}
    meant = {topic: commands[kind] for topic, kind in astray if kind in commands}
    named = {topic: topic.rpartition("/")[2] for topic in silent}
    return meant | {topic: topics.sensed[name] for topic, name in named.items() if name in topics.sensed}


def shared_topic(graph: RosGraph, cars: Sequence[str]) -> Optional[tuple[str, str]]:
    """A node that hears the driver of another car on a topic that both drivers publish, and what it hears.

    Nothing if there is none. What lies in a car's namespace is meant for that car.
    """
    drivers = {car: driver_nodes_among(car, graph.nodes) for car in cars}
    for topic, hearers in sorted(graph.subscribers.items()):
        if topic in _EVERYBODYS or any(topic.startswith(f"/{car}/") for car in cars):
            continue
        publishers = _by_car(drivers, graph.publishers.get(topic, ()))
        if len(publishers) < 2:
            continue
        for car, nodes in _by_car(drivers, filter(graph.speaks, hearers)).items():
            other = next(name for name in publishers if name != car)
            return nodes[0], (
                f"hears {topic} of {publishers[other][0]}, which drives another car: the drivers of"
                f" {_listed(list(publishers))} share this topic; name it without the leading slash"
            )
    return None


def meddling(
    graph: RosGraph, cars: Sequence[str], car_of: Callable[[str], Optional[str]]
) -> Optional[tuple[str, str]]:
    """A node of a car's driver that publishes what is between simulator and another car; and on which topic.

    Nothing if there is none. `car_of`: whose driver started a node that no car's namespace holds, if any did.
    """
    drivers = {node: car for car in cars for node in driver_nodes_among(car, graph.nodes)}
    for topic, publishers in sorted(graph.publishers.items()):
        owner = next((car for car in cars if topic.startswith(f"/{car}/")), None)
        ends = {*publishers, *graph.subscribers.get(topic, ())}
        if owner is None or not (_SIMULATOR in ends or topic.endswith("/initialpose")):
            continue
        for node in set(publishers) - {_SIMULATOR}:
            is_global = not node.startswith(tuple(f"{car}/" for car in cars))
            if (car_of(node) if is_global else drivers.get(node, owner)) not in (None, owner):
                return node, f"publishes {topic}, and drives another car"
    return None


def _is_passed_on(graph: RosGraph, topic: str) -> bool:
    return any(map(graph.speaks, graph.subscribers.get(topic, ())))


def _is_optional(topic: str) -> bool:
    return topic in _EVERYBODYS or topic.endswith(_RVIZ_S)


def _by_car(drivers: Mapping[str, Sequence[str]], nodes: Iterable[str]) -> dict[str, list[str]]:
    """The drivers' nodes among some, by car."""
    there = set(nodes)
    found = {car: sorted(there & set(own)) for car, own in drivers.items()}
    return {car: own for car, own in found.items() if own}


def _listed(words: Sequence[str], last: str = "and") -> str:
    return f" {last} ".join(part for part in (", ".join(words[:-1]), words[-1]) if part)
