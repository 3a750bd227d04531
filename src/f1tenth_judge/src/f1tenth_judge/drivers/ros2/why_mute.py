"""What the ends of a planner's topics show of a planner that cannot work: topics that lead nowhere."""

from collections.abc import Iterable, Iterator, Mapping

from f1tenth_judge.drivers.ros2.connection import Connection, Endpoint
from f1tenth_judge.drivers.ros2.quality import mismatches
from f1tenth_judge.drivers.ros2.topics import CLOCK, COMMANDS

_LIKE_COMMANDS = (
    "ackermann_msgs/msg/AckermannDriveStamped",
    "ackermann_msgs/msg/AckermannDrive",
    "geometry_msgs/msg/Twist",
    "geometry_msgs/msg/TwistStamped",
)
_OF_EVERY_NODE = ("/parameter_events", "/rosout")
_FOR_PEOPLE = ("/initialpose", "/goal_pose", "/clicked_point")  # of rviz: no fault that nobody sends these
NO_CLOCK = "no node of it hears /clock: its timers and stamps go by the wall clock (use_sim_time:=true)"


def why_mute(connection: Connection) -> list[str]:
    """Why no command of a planner may have arrived, in words."""
    offered, requested = connection.offered(), connection.requested()
    published, subscribed = connection.published(), connection.subscribed()
    wrong = [*_of_wrong_type(published, requested, "publishes"), *_astray(published, subscribed)]
    found = [*wrong, *_of_wrong_type(subscribed, offered, "hears"), *mismatched(connection)]
    unheard = _unpublished(published, subscribed, offered)
    if unheard:
        found.append(f"hears {_listed(unheard)}, which nobody publishes")
    if wrong:
        taken = [f"{requested[topic].type} on {topic}" for topic in COMMANDS]
        found.append(f"the car takes {_listed(taken, 'or')}")
    return [*found, NO_CLOCK] if ignores_clock(connection) else found


def mismatched(connection: Connection) -> list[str]:
    """Topics on which the car and the planner do not match by their quality of service, in words."""
    found = []
    for end, own in _pairs(connection.subscribed(), connection.offered()):
        found += [_mismatch(end, *each, "the car") for each in mismatches(end.qos, own.qos)]
    for end, own in _pairs(connection.published(), connection.requested()):
        found += [_mismatch(end, *each, "the planner") for each in mismatches(own.qos, end.qos)]
    return list(dict.fromkeys(found))


def ignores_clock(connection: Connection) -> bool:
    """Whether a planner that hears something does not hear the time."""
    topics = {end.topic for end in connection.subscribed()}
    return bool(topics) and CLOCK not in topics


def _pairs(ends: Iterable[Endpoint], own: Mapping[str, Endpoint]) -> Iterator[tuple[Endpoint, Endpoint]]:
    """Ends of the planner and of the car of the same topic and type."""
    for end in ends:
        if end.topic in own and own[end.topic].type == end.type:
            yield end, own[end.topic]


def _mismatch(end: Endpoint, requested: str, offered: str, who: str) -> str:
    return f"{end.topic} does not match by its QoS: requested {requested}, {who} offers {offered}"


def _of_wrong_type(ends: Iterable[Endpoint], right: Mapping[str, Endpoint], verb: str) -> list[str]:
    return [
        f"{verb} {end.type} on {end.topic}, which is {right[end.topic].type}"
        for end in ends
        if end.topic in right and end.type != right[end.topic].type
    ]


def _astray(published: Iterable[Endpoint], subscribed: Iterable[Endpoint]) -> list[str]:
    """Commands that the planner sends to nobody."""
    heard = {end.topic for end in subscribed}
    return [
        f"publishes {end.type} on {end.topic}, which nobody hears"
        for end in published
        if end.type in _LIKE_COMMANDS and end.topic not in COMMANDS and end.topic not in heard
    ]


def _unpublished(published, subscribed, offered: Iterable[str]) -> list[str]:
    there = {*offered, *(end.topic for end in published), *_OF_EVERY_NODE, *_FOR_PEOPLE}
    return sorted({end.topic for end in subscribed} - there)


def _listed(words: list[str], last: str = "and") -> str:
    return f" {last} ".join(part for part in (", ".join(words[:-1]), words[-1]) if part)
