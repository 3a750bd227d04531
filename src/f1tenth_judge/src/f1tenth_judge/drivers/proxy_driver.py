"""Takes part in lockstep for a driver whose nodes know nothing of it; docs/lockstep.md has the rules.

A period is over when all that it has brought is handled: when every thread of the driver's processes is at
rest. The driver gets its scans and its clock from the proxy driver: the scan when all other messages are
handled, the time after the scan. So a planner finds the same messages whenever it acts, though each comes
over a connection of its own.
"""

import os
import threading
import time
from typing import Any, Callable, Optional

from f1tenth_judge.drivers.granted_time import GrantedTime
from f1tenth_judge.drivers.rest import Rest, has_ended, marked_processes, processor_use
from f1tenth_judge.errors import MismatchError, NotAtRestError

_LOOK_INTERVAL = 2e-4  # wall s, between two looks at the threads
_CONNECTION_INTERVAL = 0.01  # wall s, between two looks at its connections
_SEARCH_INTERVAL = 0.25  # wall s, between two searches for processes
_NOTICING = 0.5  # wall s, for which time stands still when a process has ended, so that the runner notices it
# Exit codes of a proxy driver whose driver does not fit, or does not come to rest any more.
EXIT_MISMATCH, EXIT_NOT_AT_REST = 4, 5
# While the driver starts up; times without "wall" are granted ones (granted_time.py):
_PACE = 0.025  # s per period at least: nodes that wait by the wall clock are not overtaken
_UNCONNECTED = 4.0  # s, after which a connection is given up: its ends differ in type, or one is gone
_LOADING = 4.0  # s without rest, after which a listener gets its scan: one that spins may wait for it
_SPINNING = 1.0  # s without rest after a command, once it has had _LOADING: it spins
_LOOKS = 10  # in _PACE, for whether it is over on a busy machine
_CALM_PERIODS = 40  # without a command or a new connection, after which it is looked at less closely
_STEADY_PERIODS = 20  # with commands and without a new connection, after which it has started up
_LATE_COMMANDS = 3  # sent by a driver at rest, or without rest before the first period: more are no accident
_NOT_AT_REST = "its threads do not come to rest within {:g} s; sleep by simulated time in its loop"


class ProxyDriver:
    """Waits for the driver in each period."""

    def __init__(
        self,
        world: Any,
        mark: str,
        patience: float,
        loading: float,
        clock: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
    ):
        """What it waits for, and how long.

        Args:
            world: what it sees and does on the middleware: RosWorld of the script `proxy_driver` in ROS 1.
            mark: NAME=VALUE in the environment of the driver's processes.
            patience: time within which the driver must come to rest in a period; wall s in which its threads
                have a processor when they want one.
            loading: the same while it starts up.
            clock, sleep: wall time, s.
        """
        self._world = world
        self._mark = mark
        self._patience = patience
        self._loading = loading
        self._clock = clock
        self._sleep = sleep
        self._own = os.getpid()
        self._granted = GrantedTime(clock)
        self._pids: set[int] = set()
        self._began = self._time()  # the current period, or the one since which there was no rest
        self._is_without_rest = False  # whether the last wait has ended without rest
        self._listening_since: Optional[float] = None  # s, without rest
        self._rest = Rest(threading.get_native_id())
        self._helpers = world.helpers()
        self._ended: set[int] = set()  # those of them that are gone, and not held for yet
        self._searched: Optional[float] = None
        self._asked: Optional[float] = None  # s, of asking who sends commands, before the first period
        self._start: Optional[_Start] = _Start()

    def begin(self) -> None:
        """Let the driver load and connect, before its first period; returns when it has, or spins.

        Raises:
            MismatchError: it does not come to rest.
        """
        self._settle(may_spin=True)
        if self._start and not self._is_without_rest:
            self._let_connect(self._start)

    def act(self, stamp, has_sent: bool = True) -> None:
        """Let the driver handle a period; returns when it has.

        Args:
            stamp: the time that the driver is told.
            has_sent: whether something may have been sent to it since the last period.

        Raises:
            MismatchError: while it starts up, the driver does not come to rest, or ignores simulated time.
            NotAtRestError: later, it does not come to rest.
        """
        if not self._is_without_rest:
            self._began = self._time()
        # Who was given nothing is at rest still. While it starts up, it may have been given something unseen.
        if has_sent or self._start:
            self._settle(may_spin=True)
        if self._world.publish_scans() or self._start:
            self._settle()
        if self._world.publish_clock(stamp) or self._start:
            self._settle()
        self._hold_for_the_dead()
        if self._start:
            self._watch_start(self._start)

    def _hold_for_the_dead(self) -> None:
        self._ended |= set(filter(has_ended, self._pids))
        if self._ended:
            self._sleep(_NOTICING)
        self._pids -= self._ended
        self._ended.clear()

    def _time(self) -> float:
        """Time that the driver could use, s: what it does within some of it does not depend on the load."""
        return self._granted.now(self._pids)

    def _settle(self, may_spin: bool = False) -> None:
        """Wait until the driver is at rest; or, while it starts up, for a time if it may wait for scans."""
        self._is_without_rest = False
        self._rest.renew()
        while not self._is_at_rest() and not self._world.is_over():
            waited = self._time() - self._began
            has_listened = self._start is not None and self._has_listened()
            if not self._start and waited > self._patience:
                raise NotAtRestError(f"the driver has not come to rest within {self._patience:g} s")
            if self._start and waited > _LOADING:
                self._hear_commands(self._start)
                self._start.check_without_rest(self._world.commands(), waited)
                if waited > self._loading:
                    raise MismatchError(_NOT_AT_REST.format(self._loading))
                if may_spin and has_listened:
                    self._is_without_rest = True
                    return
            self._sleep(_LOOK_INTERVAL)
        self._listening_since = None

    def _hear_commands(self, start: "_Start") -> None:
        """Ask who sends commands: of a driver that was never at rest, nobody has asked that yet."""
        now = self._clock()
        if start.connections is None and (self._asked is None or now - self._asked > _SEARCH_INTERVAL):
            self._asked = now
            self._world.connections()

    def _has_listened(self) -> bool:
        """Whether a driver without rest has listened for scans for as long as it may take to load."""
        if not self._world.has_listener():
            return False
        if self._listening_since is None:
            self._listening_since = self._time()
        return self._time() - self._listening_since > _LOADING

    def _is_at_rest(self) -> bool:
        """Whether the driver is, and what it has sent to this process is noted."""
        if self._searched is None or self._clock() - self._searched > _SEARCH_INTERVAL:
            self._search()
        if self._start is None:
            return self._rest.is_reached([*self._pids, self._own])
        # Before the first process has been started, nothing could be at rest; and a process that waits for
        # one that it has just started is not.
        everybody = [*self._pids, self._own, *self._helpers]
        return bool(self._pids) and self._rest.is_reached(everybody) and not self._search()

    def _search(self) -> bool:
        """Look for the driver's processes; whether there are new ones."""
        self._searched = self._clock()
        before, self._pids = self._pids, marked_processes(self._mark)
        self._ended |= before - self._pids
        return not self._pids <= before

    def _watch_start(self, start: "_Start") -> None:
        at_rest = self._world.commands()
        self._let_connect(start)
        start.note(at_rest, self._world.commands())
        if start.is_over:
            self._start = None

    def _let_connect(self, start: "_Start") -> None:
        """Keep the time from overtaking a node that is about to connect, or waits by the wall clock."""
        if start.is_calm and self._world.has_node():
            # Which threads poll is known by now; before a node has come up, something is still loading.
            self._sleep(max(0.0, _PACE - (self._time() - self._began)))
        else:
            self._watch(_PACE)
            self._settle()
        while (connections := self._world.connections()) != start.connections and not self._world.is_over():
            start.note_connections(connections)
            self._await_connections(start)
            self._let_pass(self._world.connecting())
            self._settle()

    def _watch(self, duration: float) -> None:
        """Learn which threads poll, from what they do while nothing happens."""
        before, began = processor_use(self._pids), self._clock()
        self._let_pass(duration)
        self._rest.learn(before, processor_use(self._pids), self._clock() - began)

    def _let_pass(self, duration: float) -> None:
        granted = self._time()
        self._sleep(duration)
        while self._time() - granted < duration and not self._world.is_over():
            self._sleep(duration / _LOOKS)

    def _await_connections(self, start: "_Start") -> None:
        end = self._time() + _UNCONNECTED
        while (missing := self._world.missing() - start.unconnected) and not self._world.is_over():
            if self._time() > end:
                start.unconnected |= missing
            self._sleep(_CONNECTION_INTERVAL)


class _Start:
    """What is seen of a driver until it drives."""

    def __init__(self):
        self.connections: object = None
        self.unconnected: set = set()  # connections that are never established
        self._steady_periods = 0  # with commands, and without a new connection
        self._calm_periods = 0  # without a command, and without a new connection
        self._commands = 0
        self._sending_since: Optional[float] = None  # s in the current period, without rest
        self._sent = 0  # commands until then
        self._late = 0

    def note_connections(self, connections: object) -> None:
        """There are others than before."""
        self.connections, self._steady_periods, self._calm_periods = connections, 0, 0

    def check_without_rest(self, commands: int, waited: float) -> None:
        """The driver has had its time to load, and is not at rest.

        Args:
            commands: how many there were so far.
            waited: in this period, s.

        Raises:
            MismatchError: it does not rest though it sends commands.
        """
        if commands > self._commands and self._sending_since is None:
            self._sending_since, self._sent = waited, commands
        # Before it was given anything, a command may come from a node that is still loading.
        goes_on = self.connections is not None or commands - self._sent >= _LATE_COMMANDS
        if self._sending_since is not None and waited - self._sending_since > _SPINNING and goes_on:
            raise MismatchError(f"it sends commands, but {_NOT_AT_REST.format(_LOADING)}")

    def note(self, at_rest: int, later: int) -> None:
        """How many commands there were when the driver came to rest in a period, and some time later."""
        self._late += later - at_rest
        if self._late >= _LATE_COMMANDS:
            raise MismatchError("it sends commands by the wall clock, while simulated time stands still")
        self._calm_periods = 0 if later > self._commands else self._calm_periods + 1
        self._commands, self._sending_since = later, None
        self._steady_periods += bool(later)

    @property
    def is_calm(self) -> bool:
        """Whether nothing has come from the driver for a while."""
        return self._calm_periods >= _CALM_PERIODS

    @property
    def is_over(self) -> bool:
        """Whether the driver has sent commands for a while."""
        return self._steady_periods >= _STEADY_PERIODS
