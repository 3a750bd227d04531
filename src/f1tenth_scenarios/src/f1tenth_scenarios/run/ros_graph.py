"""Which nodes publish and hear which topics: what the ROS master and the nodes themselves say."""

import dataclasses
import http.client
import xmlrpc.client
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import rosgraph
from f1tenth_judge.errors import ScenarioError

from f1tenth_scenarios.ros_api import ros_api

_CALLER = "/scenario"
_ANY_TYPE = "*"
_ERRORS = (OSError, xmlrpc.client.Error, http.client.HTTPException)

Topics = Mapping[str, Sequence[str]]


@dataclasses.dataclass(frozen=True)
class RosGraph:
    """Names of nodes by topic; nodes without the leading slash."""

    publishers: Topics = dataclasses.field(default_factory=dict)
    subscribers: Topics = dataclasses.field(default_factory=dict)
    servers: Topics = dataclasses.field(default_factory=dict)  # by service

    def speaks(self, node: str) -> bool:
        """Whether a node publishes anything: one that does not, a recorder or rviz, passes nothing on."""
        return any(node in nodes for topic, nodes in self.publishers.items() if topic != "/rosout")

    @property
    def nodes(self) -> list[str]:
        """All that are known, sorted."""
        ends = (self.publishers, self.subscribers, self.servers)
        return sorted({node for each in ends for nodes in each.values() for node in nodes})


def read_graph(patience: float = 1.0) -> RosGraph:
    """As the master knows it now; empty if it does not answer in time (wall s)."""
    try:
        ends = _ask(rosgraph.get_master_uri(), patience, "getSystemState")
    except (ScenarioError, *_ERRORS):
        return RosGraph()
    return RosGraph(*({name: [each.lstrip("/") for each in nodes] for name, nodes in end} for end in ends))


def publications_of(nodes: Iterable[str]) -> Iterator[tuple[str, str]]:
    """The topics that some nodes publish, and their types, as they say: the master knows one type each."""
    return _ends_of(nodes, "getPublications")


def misread_by(nodes: Iterable[str], graph: RosGraph) -> Iterator[tuple[str, str, str]]:
    """Topics that some nodes hear as another type than that which is published; both types."""
    heard = {topic: kind for topic, kind in _ends_of(nodes, "getSubscriptions") if kind != _ANY_TYPE}
    publishers = {node for topic in heard for node in graph.publishers.get(topic, ())}
    published = dict(publications_of(sorted(publishers)))
    for topic, kind in sorted(heard.items()):
        if published.get(topic, kind) not in (kind, _ANY_TYPE):
            yield topic, kind, published[topic]


def _ends_of(nodes: Iterable[str], question: str) -> Iterator[tuple[str, str]]:
    for node in nodes:
        try:
            yield from ((topic, kind) for topic, kind in ask(node, question, patience=1.0))
        except ScenarioError:
            continue


def ask(node: str, question: str, patience: float = 10.0) -> Any:
    """What a node answers to a method of its own API (http://wiki.ros.org/ROS/Slave_API).

    Raises:
        ScenarioError: there is no such node, or it does not answer in time (wall s).
    """
    try:
        uri = _ask(rosgraph.get_master_uri(), patience, "lookupNode", f"/{node}")
        return _ask(uri, patience, question)
    except (ScenarioError, *_ERRORS) as error:
        raise ScenarioError(f"cannot find {node}: {error}") from error


def _ask(uri: str, patience: float, question: str, *arguments: str) -> Any:
    code, message, answer = getattr(ros_api(uri, patience), question)(_CALLER, *arguments)
    if code != 1:
        raise ScenarioError(message)
    return answer
