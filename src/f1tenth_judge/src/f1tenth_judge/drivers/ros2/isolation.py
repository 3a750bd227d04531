"""A DDS domain of one's own on the loopback interface, whatever the user's environment says."""

import contextlib
import os
import socket
from collections.abc import Iterator, Mapping
from pathlib import Path

from f1tenth_judge.errors import ScenarioError

_FIRST, _LAST = 1, 100  # domains whose ports are not those that Linux gives to clients
_PORT_BASE, _PORTS_PER_DOMAIN, _FIRST_UNICAST = 7400, 250, 10  # of the wire protocol (RTPS 9.6.1)
_MOST_PARTICIPANTS = 60  # of a run: ROS 2 has one per process
_LOCK = "\0f1tenth_judge/dds/{}"  # abstract: it is gone with the process that holds it
# Fast DDS announces itself by multicast, which is off: it learns of the judge by the judge's announcements.
_ANNOUNCED = "<SPDPInterval>100ms</SPDPInterval>"
_CYCLONE = (
    '<CycloneDDS><Domain Id="any"><General><AllowMulticast>false</AllowMulticast>'
    '<Interfaces><NetworkInterface address="127.0.0.1"/></Interfaces></General>'
    "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
    f"<MaxAutoParticipantIndex>{_MOST_PARTICIPANTS}</MaxAutoParticipantIndex>"
    '<Peers><Peer Address="127.0.0.1"/></Peers></Discovery></Domain></CycloneDDS>'
)
_CYCLONE_S = "rmw_cyclonedds_cpp"
_MIDDLEWARES = (_CYCLONE_S, "rmw_fastrtps_cpp")  # that speak DDS, the first one preferred


@contextlib.contextmanager
def private_domain() -> Iterator[int]:
    """The number of a domain that nobody else on this machine uses while it is held.

    Raises:
        ScenarioError: all are taken.
    """
    for domain in range(_FIRST, _LAST + 1):
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as lock:
            if _can_bind(lock, _LOCK.format(domain)) and _is_unused(domain):
                yield domain
                return
    raise ScenarioError(f"all DDS domains from {_FIRST} to {_LAST} are in use on this machine")


def child_environment(domain: int, own: Mapping[str, str] = os.environ) -> dict[str, str]:
    """The variables that keep a planner's DDS in a domain and on this machine, in place of the user's own."""
    middleware = _middleware(own)
    return {
        "ROS_DOMAIN_ID": str(domain),
        # To Cyclone DDS, ROS 2 Humble would name the interface for a second time, which is an error.
        "ROS_LOCALHOST_ONLY": "0" if middleware == _CYCLONE_S else "1",
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        "ROS_STATIC_PEERS": "",
        "CYCLONEDDS_URI": _CYCLONE,
        "RMW_IMPLEMENTATION": middleware,
    }


def domain_configuration() -> str:
    """The same for a participant of this process: Cyclone DDS's configuration."""
    return _CYCLONE.replace("<Peers>", f"{_ANNOUNCED}<Peers>")


def _can_bind(lock: socket.socket, address) -> bool:
    try:
        lock.bind(address)
    except OSError:
        return False
    return True


def _is_unused(domain: int) -> bool:
    """Whether no participant of others is in a domain: the first one has this port."""
    port = _PORT_BASE + _PORTS_PER_DOMAIN * domain + _FIRST_UNICAST
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        return _can_bind(probe, ("", port))


def _middleware(own: Mapping[str, str]) -> str:
    """The one that is installed and speaks DDS: others, such as rmw_zenoh, could not be heard.

    Where none is found, as before the command sources its workspace, ROS 2's default: it speaks DDS.
    """
    folders = [Path(each) / "lib" for each in own.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if each]
    wanted = own.get("RMW_IMPLEMENTATION", "")
    preferred = sorted(_MIDDLEWARES, key=lambda name: name != wanted)
    there = (name for name in preferred if any((each / f"lib{name}.so").exists() for each in folders))
    return next(there, "")
