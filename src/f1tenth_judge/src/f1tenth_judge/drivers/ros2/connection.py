"""What one planner's DDS domain is to the judge: its topics, and who is connected to them."""

from typing import Any, NamedTuple
from uuid import UUID

from cyclonedds.builtin import (
    BuiltinDataReader,
    BuiltinTopicDcpsParticipant,
    BuiltinTopicDcpsPublication,
    BuiltinTopicDcpsSubscription,
)
from cyclonedds.core import InstanceState
from cyclonedds.domain import Domain, DomainParticipant
from cyclonedds.internal import InvalidSample
from cyclonedds.pub import DataWriter
from cyclonedds.qos import Policy, Qos
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic

from f1tenth_judge.drivers.ros2.isolation import domain_configuration
from f1tenth_judge.drivers.ros2.quality import HEARD, REQUESTED

_MOST = 1000  # samples that are taken at once
_MOST_PATIENCE = 10 * 10**9  # ns, as long as a process that is gone counts as there
_PREFIX = "rt/"  # of topics, as ROS 2 names them on DDS
_CYCLONE = b"\x01\x10"  # the vendor, with which a participant's key begins (RTPS 9.3.1.5)


class Endpoint(NamedTuple):
    """An end of a topic."""

    key: str  # that no other end has
    topic: str  # as ROS 2 names it, with the slash in front
    type: str  # as in sensor_msgs/msg/LaserScan
    qos: Qos


class Connection:
    """A participant of a domain with its writers and readers. Not for several threads at once."""

    def __init__(self, domain: int):
        """Join the domain, on the loopback interface only.

        Raises:
            DDSException: that is not possible.
        """
        self._domain = Domain(domain, domain_configuration())
        self._participant = DomainParticipant(domain)
        self._writers: dict[str, DataWriter] = {}
        self._readers: dict[str, DataReader] = {}
        self._offered: dict[str, Endpoint] = {}
        self._requested: dict[str, Endpoint] = {}
        self._publications = _Discovery(self._participant, BuiltinTopicDcpsPublication)
        self._subscriptions = _Discovery(self._participant, BuiltinTopicDcpsSubscription)
        self._participants = BuiltinDataReader(self._participant, BuiltinTopicDcpsParticipant)

    def offer(self, topic: str, kind: type, qos: Qos) -> None:
        """Begin to publish a topic."""
        self._writers[topic] = DataWriter(self._participant, self._topic(topic, kind), qos)
        self._offered[topic] = Endpoint("", topic, type_in_ros(kind), qos)

    def request(self, topic: str, kind: type) -> None:
        """Begin to take what a planner publishes on a topic."""
        self._readers[topic] = DataReader(self._participant, self._topic(topic, kind), REQUESTED)
        self._requested[topic] = Endpoint("", topic, type_in_ros(kind), REQUESTED)

    def listen(self, end: Endpoint, kind: type) -> None:
        """Begin to take what is published at an end, as it is offered there: as much as has been kept."""
        kept = [end.qos[policy] for policy in (Policy.Reliability, Policy.Durability) if policy in end.qos]
        self._readers[end.topic] = DataReader(
            self._participant, self._topic(end.topic, kind), HEARD + Qos(*kept)
        )

    def publish(self, topic: str, message: Any) -> None:
        """Send a message; it has left this process when this returns."""
        self._writers[topic].write(message)

    def publish_whole(self, topic: str, message: Any) -> None:
        """Send a message of many packets; those who request it reliable have all of it when this returns."""
        self._writers[topic].write(message)
        self._writers[topic].wait_for_acks(_MOST_PATIENCE)

    def take(self, topic: str) -> list[Any]:
        """The messages that have come on a topic, in order."""
        taken = self._readers[topic].take(_MOST)
        return [each for each in taken if not isinstance(each, InvalidSample)]

    def process_of(self, message: Any, topic: str) -> str:
        """The process that has sent a message of a topic that is requested; empty if it is gone."""
        sender = self._readers[topic].get_matched_publication_data(message.sample_info.publication_handle)
        return str(sender.participant_key) if sender else ""

    def hearers(self, topic: str) -> int:
        """How many readers are connected to a topic that is offered."""
        return self._writers[topic].get_publication_matched_status().current_count

    def participants(self) -> int:
        """How many participants the domain has besides this one: one per process of a ROS 2 planner."""
        return len(self._others())

    def is_all_cyclone(self) -> bool:
        """Whether all participants are of Cyclone DDS, as this one."""
        return all(each.bytes.startswith(_CYCLONE) for each in self._others())

    def _others(self) -> list[UUID]:
        """The keys of the participants besides this one."""
        found = [each.key for each in self._participants.read(_MOST) if _lives(each)]
        return [key for key in found if key != self._participant.guid]

    def published(self) -> list[Endpoint]:
        """What the planner publishes."""
        return self._publications.endpoints()

    def subscribed(self) -> list[Endpoint]:
        """What the planner subscribes to."""
        return self._subscriptions.endpoints()

    def offered(self) -> dict[str, Endpoint]:
        """This end of the topics that are offered."""
        return self._offered

    def requested(self) -> dict[str, Endpoint]:
        """This end of the topics that are requested."""
        return self._requested

    def close(self) -> None:
        """Leave the domain. cyclonedds does so when its objects are dropped."""
        self._writers.clear()
        self._readers.clear()
        del self._publications, self._subscriptions, self._participants, self._participant, self._domain

    def _topic(self, topic: str, kind: type) -> Topic:
        return Topic(self._participant, _PREFIX + topic.removeprefix("/"), kind)


class _Discovery:
    """The ends that others in the domain have, of topics with ROS 2's names."""

    def __init__(self, participant: DomainParticipant, builtin_topic):
        self._own = participant.guid
        self._reader = BuiltinDataReader(participant, builtin_topic)

    def endpoints(self) -> list[Endpoint]:
        found = [
            each for each in self._reader.read(_MOST) if _lives(each) and each.participant_key != self._own
        ]
        return [
            Endpoint(str(each.key), each.topic_name.removeprefix("rt"), _in_ros(each.type_name), each.qos)
            for each in found
            if each.topic_name.startswith(_PREFIX)
        ]


def type_in_ros(kind: Any) -> str:
    """The name in ROS 2 of a message, as in sensor_msgs/msg/LaserScan."""
    return _in_ros(kind.__idl_typename__.replace(".", "::"))


def _in_ros(name: str) -> str:
    """The name in ROS 2 of a type that DDS names."""
    return name.replace("::dds_::", "::").removesuffix("_").replace("::", "/")


def _lives(sample) -> bool:
    return sample.sample_info.valid_data and sample.sample_info.instance_state == InstanceState.Alive
