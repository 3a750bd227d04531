"""Quality of service: what the car offers and requests, and why two ends of a topic do not match."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from cyclonedds.qos import Policy, Qos

_ENDLESS = 2**63 - 1  # ns
_BLOCKING = 10**8  # ns, for which a write may wait for readers that lag behind
_XCDR1 = Policy.DataRepresentation(use_cdrv0_representation=True)  # ROS 2's
# Planners of ROS 2 since Iron look for a hash of the type there, and warn of each topic without any data.
_NO_HASH = Policy.Userdata(b"f1tenth_judge;")
_RELIABLE = Policy.Reliability.Reliable(_BLOCKING)

# Reliable offers serve readers that request best effort (sensor data) and those that request reliable (the
# default of rclpy and rclcpp) alike. Nothing is lost in a period, so the depth is that of the defaults.
OFFERED = Qos(_RELIABLE, Policy.Durability.Volatile, Policy.History.KeepLast(10), _XCDR1, _NO_HASH)
LATCHED = Qos(_RELIABLE, Policy.Durability.TransientLocal, Policy.History.KeepLast(1), _XCDR1, _NO_HASH)
# As f1tenth_gym_ros and the drivers of the car request; all are kept, to be counted.
REQUESTED = Qos(_RELIABLE, Policy.Durability.Volatile, Policy.History.KeepAll, _XCDR1, _NO_HASH)
# Of what is only shown: nobody waits for it.
HEARD = Qos(Policy.History.KeepLast(100), _XCDR1, _NO_HASH)

# The kinds of a policy in words, weakest first: a reader may request no more than the writer offers.
_STRENGTHS: Sequence[tuple[Any, Mapping[str, str]]] = (
    (Policy.Reliability, {"BestEffort": "best effort", "Reliable": "reliable"}),
    (
        Policy.Durability,
        {
            "Volatile": "volatile",
            "TransientLocal": "transient local",
            "Transient": "transient",
            "Persistent": "persistent",
        },
    ),
    (
        Policy.Liveliness,
        {
            "Automatic": "automatic liveliness",
            "ManualByParticipant": "manual liveliness",
            "ManualByTopic": "liveliness by topic",
        },
    ),
)
# Times (ns) that a writer keeps: a reader may request none that is shorter.
_TIMES: Sequence[tuple[Any, str, Callable]] = (
    (Policy.Deadline, "deadline", lambda policy: policy.deadline),
    (Policy.Liveliness, "lease", lambda policy: policy.lease_duration),
)


def is_reliable(qos: Qos) -> bool:
    """Whether what is lost is sent again."""
    return Policy.Reliability in qos and _kind(qos[Policy.Reliability]) == "Reliable"


def mismatches(requested: Qos, offered: Qos) -> list[tuple[str, str]]:
    """The policies by which a reader and a writer do not match: what is requested, and what is offered."""
    return [*_too_weak(requested, offered), *_too_late(requested, offered)]


def _too_weak(requested: Qos, offered: Qos) -> Iterator[tuple[str, str]]:
    for policy, words in _STRENGTHS:
        kinds = list(words)
        wanted, given = (_kind(qos[policy]) if policy in qos else kinds[0] for qos in (requested, offered))
        if kinds.index(wanted) > kinds.index(given):
            yield words[wanted], words[given]


def _kind(policy) -> str:
    return type(policy).__name__.rpartition(".")[2]


def _too_late(requested: Qos, offered: Qos) -> Iterator[tuple[str, str]]:
    for policy, name, time_of in _TIMES:
        wanted, given = (time_of(qos[policy]) if policy in qos else _ENDLESS for qos in (requested, offered))
        if wanted < given:
            yield f"{name} {_seconds(wanted)}", f"{name} {_seconds(given)}"


def _seconds(nanoseconds: int) -> str:
    return "none" if nanoseconds == _ENDLESS else f"{nanoseconds / 1e9:g} s"
