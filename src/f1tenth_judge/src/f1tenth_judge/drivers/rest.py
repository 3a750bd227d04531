"""Whether processes are at rest: what they were given is handled, and every thread waits for something new.

Judged by what the kernel says of their threads (man 5 proc). A thread that is woken counts as running from
that moment on, so work that one thread hands to another is never overlooked.
"""

import contextlib
import dataclasses
import math
import os
import threading
import time
import weakref
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import NamedTuple, Optional

Thread = tuple[int, int]  # ids of the process and of the thread
Switches = dict[Thread, bytes]  # how often each thread has been switched to: digits

_ASLEEP = b"SIZX"  # waiting, idle, or ended
_READY = (b"R", b"T", b"t")  # running, or stopped by a signal, a debugger or a profiler
_MOMENT = 0.015  # s; a sleep that has lasted longer is a long one
_LONGEST_POLL = 0.003  # s, between two looks of a thread that polls
_FEWEST_POLLS = 8
_NAP = b"nanosleep"  # part of what the kernel calls a sleep for some time
_NO_WAIT = (b"0", b"")  # of a thread that is not switched off yet, or may not be inspected
_LONG_ENOUGH = 0.5  # s, to fall asleep
_LONGEST_LINE = 4096  # bytes
_MOST_OPEN = 200  # threads, of which files stay open: a process may have 1,024 of them, as a rule
_SEARCH_LIMIT = 1 << 16  # bytes of an environment that are looked through


class ProcessorUse(NamedTuple):
    """What a thread has had of the processors."""

    is_ready: bool  # whether it runs, or would if it had one or were not stopped
    ran: float  # s
    waited: float  # s, ready to run
    switches: int  # how often it was switched to


def marked_processes(mark: str) -> set[int]:
    """The processes of this user that have NAME=VALUE in their environment: inherited, as a rule."""
    wanted = mark.encode()
    environments = {pid: _environment(pid) for pid in _all_processes()}
    found = {pid for pid, variables in environments.items() if wanted in variables}
    # The kernel shows none of a process that is about to begin its program: who has started it is known.
    beginning = (pid for pid, variables in environments.items() if variables == [b""])
    return found | {pid for pid in beginning if _parent_of(pid) in found and not has_ended(pid)}


def has_ended(pid: int) -> bool:
    """Whether a process is gone, or waits to be noticed by its parent."""
    return _state_of(f"/proc/{pid}") in (b"", b"Z", b"X")


def processor_use(pids: Iterable[int]) -> dict[Thread, ProcessorUse]:
    """What each thread of some processes has had of the processors so far."""
    return {(pid, thread): _use_of(pid, thread) for pid in pids for thread in _threads(pid)}


class Rest:
    """Looks at all threads of some processes.

    Some threads wake by themselves to see whether something is new, and sleep on: ros::Rate and ros::Timer do
    so every millisecond while time is simulated. And rospy sleeps for a moment between two subscribers of
    the same message. So a thread that has just begun a sleep of its own choice, or is known to poll, has to
    come round once while no other does anything; one that sleeps for longer than such a moment is at rest.
    """

    def __init__(self, ignored_thread: Optional[int] = None, clock: Callable[[], float] = time.monotonic):
        """`ignored_thread`: id of one that is not looked at, such as the caller's; `clock`: wall time, s."""
        self._ignored = ignored_thread
        self._clock = clock
        self._tells_waits = _tells_waits()
        self._threads: dict[Thread, _ThreadFiles] = {}  # those that there were last
        self._awake: Optional[_ThreadFiles] = None  # found running last: looked at first
        self._asleep: Optional[_Asleep] = None  # when all were, first
        self._naps: dict[Thread, _Nap] = {}
        self._pollers: set[Thread] = set()

    def renew(self) -> None:
        """Something new was given to the processes: what was seen of them before no longer counts."""
        self._asleep = None

    def is_reached(self, pids: Iterable[int]) -> bool:
        """Whether at a moment since renew() every thread was asleep, with nothing left to do."""
        if self._awake and self._awake.runs():
            return False
        if not self._threads:
            self._list(pids)
        found = self._look()
        if found is None:
            return False
        if self._asleep is None or not self._asleep.is_same(found):
            if not self._note_naps(found):
                self._list(pids)  # one that has ended sleeps nowhere
                return False
            self._asleep = _Asleep(self._clock(), found, set(filter(self._may_wake, found)))
        # Those that have not been switched to between two looks have slept all the time between them.
        return self._has_come_round(self._asleep, found) and self._is_still_asleep(pids, found)

    def learn(
        self, before: Mapping[Thread, ProcessorUse], after: Mapping[Thread, ProcessorUse], elapsed: float
    ) -> None:
        """Note which threads poll, by how often each was switched to in `elapsed` s with nothing new."""
        for thread, use in after.items():
            if thread in before:
                free = elapsed - (use.waited - before[thread].waited)
                if use.switches - before[thread].switches >= max(_FEWEST_POLLS, free / _LONGEST_POLL):
                    self._pollers.add(thread)

    def _look(self) -> Optional[Switches]:
        """How often each known thread has been switched to; nothing if one of them runs."""
        found = {}
        for thread, files in self._threads.items():
            found[thread] = switches = files.switches()
            if not self._sleeps_on(thread, switches) and files.runs():
                self._awake = files
                return None
        return found

    def _sleeps_on(self, thread: Thread, switches: bytes) -> bool:
        """Whether a thread was seen asleep and has not been switched to since: at most it was woken."""
        nap = self._naps.get(thread)
        return self._tells_waits and nap is not None and nap.switches == switches

    def _is_still_asleep(self, pids: Iterable[int], found: Switches) -> bool:
        """Whether no thread runs, was switched to, has come or gone, or is only about to sleep.

        They are listed anew only now: what they have started before they fell asleep is there by then.
        """
        self._list(pids)
        if self._threads.keys() != found.keys():
            return False
        for thread, files in self._threads.items():
            # Its switches last: one that is woken, works and sleeps again between two questions has others.
            if files.runs():
                self._awake = files
                return False
            if not self._sleeps_on(thread, found[thread]) and self._wait_of(thread) is None:
                return False
            if files.switches() != found[thread]:
                return False
        return True

    def _list(self, pids: Iterable[int]) -> None:
        present = [(pid, thread) for pid in pids for thread in _threads(pid) if thread != self._ignored]
        if self._threads.keys() != set(present):
            known, few = self._threads, len(present) <= _MOST_OPEN
            self._threads = {each: known.get(each) or _ThreadFiles(each, few) for each in present}

    def _note_naps(self, found: Switches) -> bool:
        """Note which have chosen to sleep since the last time; False if one of them is only about to."""
        for thread, switches in found.items():
            known = self._naps.get(thread)
            if known is None or known.switches != switches:
                wait = self._wait_of(thread)
                if wait is None:
                    return False
                self._naps[thread] = _Nap(switches, self._clock() if _NAP in wait else -math.inf)
        self._naps = {thread: self._naps[thread] for thread in found}
        return True

    def _may_wake(self, thread: Thread) -> bool:
        """Whether a thread that is asleep may wake by itself in a moment."""
        return thread in self._pollers or self._clock() - self._naps[thread].begin < _MOMENT

    def _has_come_round(self, asleep: "_Asleep", found: Switches) -> bool:
        if self._clock() - asleep.since > _MOMENT:
            return True
        return all(found[thread] != asleep.switches[thread] for thread in asleep.may_wake)

    def _wait_of(self, thread: Thread) -> Optional[bytes]:
        """Where in the kernel a thread sleeps, as far as it tells; None if the thread is only about to."""
        wait = _wait_of(*thread)
        if self._tells_waits and wait in _NO_WAIT:
            # Linux 6.12 and later count a thread that has had more than its share as running, though it
            # sleeps, until it would be its turn again or somebody asks for its system call.
            _read("/proc/{}/task/{}/syscall".format(*thread))
            wait = _wait_of(*thread)
        return None if self._tells_waits and wait in _NO_WAIT else wait


class _ThreadFiles:
    """What the kernel says of a thread. Opening a file costs more than reading it: they stay open."""

    def __init__(self, thread: Thread, are_kept_open: bool):
        folder = "/proc/{}/task/{}".format(*thread)
        self._stat = _KernelFile(f"{folder}/stat", are_kept_open)
        self._schedstat = _KernelFile(f"{folder}/schedstat", are_kept_open)

    def runs(self) -> bool:
        """Whether it runs or wants to; one that is gone is asleep."""
        state = _state_in(self._stat.read())
        return bool(state) and state not in _ASLEEP

    def switches(self) -> bytes:
        """How often it was switched to."""
        return self._schedstat.read().rpartition(b" ")[2]


class _KernelFile:
    """A file that is made anew whenever it is read from its begin."""

    def __init__(self, path: str, is_kept_open: bool):
        self._path = path
        self._descriptor: Optional[int] = None
        with contextlib.suppress(OSError):
            if is_kept_open:
                self._descriptor = os.open(path, os.O_RDONLY)
                weakref.finalize(self, os.close, self._descriptor)

    def read(self) -> bytes:
        """Its content; empty if what it tells of is gone or belongs to somebody else."""
        if self._descriptor is None:
            return _read(self._path)
        try:
            return os.pread(self._descriptor, _LONGEST_LINE, 0)
        except OSError:
            return b""


@dataclasses.dataclass(frozen=True)
class _Asleep:
    """All threads, when they were asleep."""

    since: float  # s
    switches: Switches
    may_wake: set[Thread]

    def is_same(self, found: Switches) -> bool:
        """Whether no thread has been awake since, except those that wake by themselves."""
        return found.keys() == self.switches.keys() and all(
            found[thread] == self.switches[thread] for thread in found.keys() - self.may_wake
        )


@dataclasses.dataclass(frozen=True)
class _Nap:
    """When a thread was first seen in a sleep that it had chosen; long ago if it waits for something."""

    switches: bytes
    begin: float  # s


def _wait_of(pid: int, thread: int) -> bytes:
    """The kernel's function in which a thread sleeps, if the kernel tells."""
    return _read(f"/proc/{pid}/task/{thread}/wchan")


def _use_of(pid: int, thread: int) -> ProcessorUse:
    """Nothing where the kernel does not tell; schedstat is in ns."""
    folder = f"/proc/{pid}/task/{thread}"
    ran, waited, switches = (_read(f"{folder}/schedstat").split() or (0, 0, 0))[:3]
    return ProcessorUse(_state_of(folder) in _READY, int(ran) * 1e-9, int(waited) * 1e-9, int(switches))


def _tells_waits() -> bool:
    """Whether the kernel tells where the threads of this user sleep."""
    done = threading.Event()
    sleeper = threading.Thread(target=done.wait, daemon=True)
    sleeper.start()
    end = time.monotonic() + _LONG_ENOUGH
    told = False
    while not told and time.monotonic() < end:
        time.sleep(_LONG_ENOUGH / 100)
        told = _wait_of(os.getpid(), sleeper.native_id or 0) not in _NO_WAIT
    done.set()
    return told


def _state_of(folder: str) -> bytes:
    """The letter for the state of a process or thread; empty when it is gone."""
    return _state_in(_read(f"{folder}/stat"))


def _state_in(stat: bytes) -> bytes:
    return _after_name(stat)[:1]


def _after_name(stat: bytes) -> bytes:
    return stat[stat.rfind(b")") + 2 :]


def _all_processes() -> Iterator[int]:
    return (int(name) for name in os.listdir("/proc") if name.isdigit())


def _threads(pid: int) -> list[int]:
    try:
        return [int(name) for name in os.listdir(f"/proc/{pid}/task")]
    except OSError:
        return []


def _environment(pid: int) -> list[bytes]:
    """The variables of a process; nothing at all if it is gone or belongs to somebody else."""
    try:
        with open(f"/proc/{pid}/environ", "rb", buffering=0) as file:
            return file.read(_SEARCH_LIMIT).split(b"\0")
    except OSError:
        return []


def _parent_of(pid: int) -> int:
    """Which process has started one; 0 if it is gone."""
    fields = _after_name(_read(f"/proc/{pid}/stat")).split()
    return int(fields[1]) if fields else 0


def _read(path: str, limit: int = _LONGEST_LINE) -> bytes:
    """The content of a file; empty if it is gone or belongs to somebody else."""
    try:
        descriptor = os.open(path, os.O_RDONLY)
    except OSError:
        return b""
    try:
        return os.read(descriptor, limit)
    except OSError:
        return b""
    finally:
        os.close(descriptor)
