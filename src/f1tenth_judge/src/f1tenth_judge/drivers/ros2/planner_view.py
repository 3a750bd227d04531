"""A planner as lockstep sees it: what it hears, whether it has come up, how many commands it has sent."""

from collections.abc import Sequence
from typing import Callable

from f1tenth_judge.drivers.ros2.car_topics import CarTopics
from f1tenth_judge.drivers.ros2.connection import Connection
from f1tenth_judge.run.stage import Command

# Time (s) without a change, after which no end of a topic is about to connect. Nobody sees whether those
# within a planner have: Fast DDS repeats after 1 s what came before the other side was ready, Cyclone DDS
# sooner; and a process of Fast DDS that another one has missed announces itself again only after 3 s.
_CONNECTING, _CONNECTING_UNSEEN, _ANNOUNCING = 0.3, 2.0, 3.5


class PlannerView:
    """What the proxy driver sees and does on DDS.

    All is sent when something that publishes returns: whether somebody hears it.
    """

    def __init__(self, connection: Connection, topics: CarTopics, is_over: Callable[[], bool]):
        """`is_over`: whether the run ends."""
        self._connection = connection
        self._topics = topics
        self._commands: list[Command] = []
        self._count = 0
        self.is_over = is_over

    def helpers(self) -> Sequence[int]:
        """Processes besides the planner's that have to be at rest: none."""
        return ()

    def connections(self) -> object:
        """Who is connected to what; equal as long as nothing has changed."""
        ends = (*self._connection.published(), *self._connection.subscribed())
        return sorted(each.key for each in ends), self._connection.participants()

    def connecting(self) -> float:
        """Time (s) without a change, after which no node is about to connect."""
        alone, among_others = (
            (_CONNECTING, _CONNECTING_UNSEEN)
            if self._connection.is_all_cyclone()
            else (_CONNECTING_UNSEEN, _ANNOUNCING)
        )
        return alone if self._connection.participants() <= 1 else among_others

    def missing(self) -> set[str]:
        """What should have been heard of a planner by now, and was not: its process, then its topics."""
        if not self._connection.participants():
            return {"process"}
        has_ends = self._connection.subscribed() or self._connection.published()
        return set() if has_ends else {"topics"}

    def commands(self) -> int:
        """How many commands the planner has sent so far."""
        self._take()
        return self._count

    def has_listener(self) -> bool:
        """Whether the planner has subscribed to scans."""
        return self._topics.is_scan_heard()

    def has_node(self) -> bool:
        """Whether a process of the planner has joined the domain."""
        return self._connection.participants() > 0

    def publish_scans(self) -> bool:
        """Give the planner its scan."""
        return self._topics.publish_scans()

    def publish_clock(self, stamp: float) -> bool:
        """Tell the planner the time (s)."""
        return self._topics.publish_clock(stamp)

    def new_commands(self) -> list[Command]:
        """The commands since the last call, in order."""
        self._take()
        new, self._commands = self._commands, []
        return new

    def _take(self) -> None:
        new = self._topics.take_commands()
        self._commands += new
        self._count += len(new)
