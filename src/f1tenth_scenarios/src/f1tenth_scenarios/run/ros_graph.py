"""Which nodes publish and hear which topics: what the ROS master and the nodes themselves say."""

import dataclasses
import http.client
import xmlrpc.client
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import rosgraph

from f1tenth_scenarios.errors import ScenarioError

_CALLER = "/scenario"
_PATIENCE = 1.0  # wall s, for a node's answer

Topics = Mapping[str, Sequence[str]]


class _Impatient(xmlrpc.client.Transport):
    """Does not wait for ever for a node that is stopped."""

    def make_connection(self, host: Any) -> http.client.HTTPConnection:
        connection = super().make_connection(host)
        connection.timeout = _PATIENCE
        return connection


@dataclasses.dataclass(frozen=True)
class RosGraph:
    """Names of nodes by topic; nodes without the leading slash."""

    publishers: Topics = dataclasses.field(default_factory=dict)
    subscribers: Topics = dataclasses.field(default_factory=dict)
    servers: Topics = dataclasses.field(default_factory=dict)  # by service

    @property
    def nodes(self) -> list[str]:
        """All that are known, sorted."""
        ends = (self.publishers, self.subscribers, self.servers)
        return sorted({node for each in ends for nodes in each.values() for node in nodes})


def read_graph() -> RosGraph:
    """As the master knows it now; empty if it does not answer."""
    try:
        ends = rosgraph.Master(_CALLER).getSystemState()
    except (rosgraph.MasterException, OSError):
        return RosGraph()
    return RosGraph(*({name: [each.lstrip("/") for each in nodes] for name, nodes in end} for end in ends))


def publications_of(nodes: Sequence[str]) -> Iterator[tuple[str, str]]:
    """The topics that some nodes publish, and their types, by their own word: the master knows one each."""
    for node in nodes:
        try:
            yield from ((topic, kind) for topic, kind in ask(node, "getPublications"))
        except ScenarioError:
            continue


def ask(node: str, question: str) -> Any:
    """What a node answers to a method of its own API (http://wiki.ros.org/ROS/Slave_API).

    Raises:
        ScenarioError: there is no such node, or it does not answer.
    """
    try:
        uri = rosgraph.Master(_CALLER).lookupNode(f"/{node}")
        server = xmlrpc.client.ServerProxy(uri, transport=_Impatient())
        code, message, answer = getattr(server, question)(_CALLER)
    except (rosgraph.MasterException, OSError, xmlrpc.client.Error) as error:
        raise ScenarioError(f"cannot find {node}: {error}") from error
    if code != 1:
        raise ScenarioError(f"cannot find {node}: {message}")
    return answer
