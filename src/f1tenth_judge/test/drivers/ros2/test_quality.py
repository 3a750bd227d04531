"""When two ends of a topic match by their quality of service: as DDS itself finds."""

import itertools

import pytest
from cyclonedds.domain import Domain, DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.qos import Policy, Qos
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from f1tenth_judge.drivers.ros2.connection import Connection
from f1tenth_judge.drivers.ros2.isolation import domain_configuration, private_domain
from f1tenth_judge.drivers.ros2.messages.basic import Clock
from f1tenth_judge.drivers.ros2.quality import LATCHED, OFFERED, REQUESTED, mismatches
from patience import wait_for

RELIABLE, SECOND = Policy.Reliability.Reliable(10**8), 10**9
QUALITIES = [
    OFFERED,
    LATCHED,
    REQUESTED,
    Qos(Policy.Reliability.BestEffort),
    Qos(Policy.Reliability.BestEffort, Policy.Durability.TransientLocal),
    Qos(RELIABLE, Policy.Deadline(SECOND)),
    Qos(RELIABLE, Policy.Deadline(2 * SECOND)),
    Qos(RELIABLE, Policy.Liveliness.Automatic(SECOND)),
    Qos(RELIABLE, Policy.Liveliness.ManualByTopic(SECOND)),
    Qos(RELIABLE, Policy.Liveliness.ManualByParticipant(2 * SECOND)),
]


@pytest.fixture(scope="module")
def participant():
    with private_domain() as number:
        domain = Domain(number, domain_configuration())
        yield DomainParticipant(number)
        del domain


@pytest.mark.parametrize(("requested", "offered"), [*itertools.product(QUALITIES, repeat=2)])
def test_mismatch_is_found_where_dds_finds_one(participant, requested, offered):
    topic = Topic(participant, "clock", Clock)
    writer, reader = DataWriter(participant, topic, offered), DataReader(participant, topic, requested)
    assert bool(writer.get_matched_subscriptions()) == (not mismatches(requested, offered))
    del reader


@pytest.mark.parametrize(
    ("requested", "offered", "words"),
    [
        (Qos(RELIABLE), Qos(Policy.Reliability.BestEffort), ("reliable", "best effort")),
        (LATCHED, OFFERED, ("transient local", "volatile")),
        (Qos(Policy.Deadline(SECOND // 2)), OFFERED, ("deadline 0.5 s", "deadline none")),
        (
            Qos(Policy.Liveliness.ManualByTopic(2**63 - 1)),
            OFFERED,
            ("liveliness by topic", "automatic liveliness"),
        ),
    ],
)
def test_both_sides_of_a_mismatch_are_named(requested, offered, words):
    assert mismatches(requested, offered) == [words]


def test_readers_that_have_come_are_counted_until_they_go():
    with private_domain() as number:
        connection = Connection(number)
        connection.offer("clock", Clock, OFFERED)
        other = DomainParticipant(number)
        readers = [DataReader(other, Topic(other, "rt/clock", Clock)) for _ in range(2)]
        assert wait_for(lambda: connection.hearers("clock") == 2)
        readers.pop()
        assert wait_for(lambda: connection.hearers("clock") == 1)
        connection.close()
