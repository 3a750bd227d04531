"""What is connected with the driver's nodes, according to the master and to the publishers."""

import xmlrpc.client
from collections.abc import Iterator
from typing import Optional
from urllib.parse import urlparse

import rosgraph
import rosgraph.network

from f1tenth_scenarios.ros_api import ros_api

_PATIENCE = 10.0  # wall s, for a node's answer; it may be stopped for a while
_OUTGOING = "o"  # of getBusInfo (https://wiki.ros.org/ROS/Slave_API)

Connection = tuple[str, str, str]  # topic, publisher, subscriber


class Connections:
    """Those of the driver's nodes, which are known by the topic that only they subscribe to: their clock."""

    def __init__(self, caller: str, clock: str):
        """`caller`: full name of the node that asks, whose links count, too; `clock`: that of the topic."""
        self._master = rosgraph.Master(caller)
        self._caller = caller
        self._clock = clock

    def master_process(self) -> Optional[int]:
        """Its id, if the master runs on this machine."""
        host = urlparse(self._master.master_uri).hostname
        return self._master.getPid() if host and rosgraph.network.is_local_address(host) else None

    def registered(self) -> tuple[list, list]:
        """Topics with their publishers, and with their subscribers."""
        publishers, subscribers, _ = self._master.getSystemState()
        return publishers, subscribers

    def commands(self, registered: tuple[list, list], simulator: str) -> set[str]:
        """The topics on which the driver speaks to the simulator, a node's full name; see registered()."""
        publishers, subscribers = registered
        by_topic = dict(subscribers)
        driver = set(by_topic.get(self._clock, ()))
        return {
            topic for topic, names in publishers if driver & {*names} and simulator in by_topic.get(topic, ())
        }

    def missing(self) -> set[Connection]:
        """Those that should be there according to the master, and are not."""
        wanted = set(self._wanted())
        there = {
            (topic, publisher, subscriber)
            for publisher in {publisher for _, publisher, _ in wanted}
            for topic, subscriber in self._links(publisher)
        }
        return wanted - there

    def _wanted(self) -> Iterator[Connection]:
        publishers, subscribers = self.registered()
        by_topic = dict(subscribers)
        concerned = {self._caller, *by_topic.get(self._clock, ())}
        for topic, names in publishers:
            for publisher in names:
                for subscriber in by_topic.get(topic, ()):
                    if publisher != subscriber and concerned & {publisher, subscriber}:
                        yield topic, publisher, subscriber

    def _links(self, publisher: str) -> Iterator[tuple[str, str]]:
        """Topic and subscriber of each connection over which a node publishes; none if it is gone."""
        try:
            node = ros_api(self._master.lookupNode(publisher), _PATIENCE)
            _, _, links = node.getBusInfo(self._caller)
        except (rosgraph.MasterException, OSError, xmlrpc.client.Error):
            return
        for _, subscriber, direction, _, topic, *_ in links:
            if direction == _OUTGOING:
                yield topic, subscriber
