"""Whether processes are at rest: what they were given is handled, and every thread waits for something new.

By what the kernel says of their threads (man 5 proc). A thread that is woken counts as running from that
moment on, so work that goes from hand to hand is never overlooked.
"""

import os
from collections.abc import Iterable, Iterator
from typing import Optional

_ASLEEP = b"SIZX"  # waiting, idle, or ended
_SEARCH_LIMIT = 1 << 16  # bytes of an environment that are looked through


def marked_processes(mark: str) -> set[int]:
    """The processes of this user that have NAME=VALUE in their environment: inherited, as a rule."""
    wanted = mark.encode()
    return {pid for pid in _all_processes() if wanted in _environment(pid)}


def has_ended(pid: int) -> bool:
    """Whether a process is gone, or waits to be noticed by who started it."""
    return _state_of(f"/proc/{pid}") in (b"", b"Z", b"X")


class Rest:
    """Looks at all threads of some processes."""

    def __init__(self, ignored_thread: Optional[int] = None):
        """`ignored_thread`: id of one that is not looked at, as that of who asks."""
        self._ignored = ignored_thread
        self._awake: Optional[tuple[int, int]] = None  # who was found running last: it is asked first

    def is_reached(self, pids: Iterable[int]) -> bool:
        """Whether there was a moment, since this was called, at which every thread was asleep."""
        if self._awake and self._state(*self._awake)[0]:
            return False
        before = self._look(pids)
        # Those that have not been switched to between two looks have slept all the time between them.
        return before is not None and before == self._look(pids)

    def _look(self, pids) -> Optional[dict[tuple[int, int], bytes]]:
        """How often each thread has been switched to; nothing if one of them runs."""
        found = {}
        for pid in pids:
            for thread in _threads(pid):
                if thread == self._ignored:
                    continue
                runs, switches = self._state(pid, thread)
                if runs:
                    self._awake = pid, thread
                    return None
                found[pid, thread] = switches
        return found

    @staticmethod
    def _state(pid: int, thread: int) -> tuple[bool, bytes]:
        """Whether a thread runs or wants to, and how often it was switched to; who is gone is asleep."""
        folder = f"/proc/{pid}/task/{thread}"
        switches = _read(f"{folder}/schedstat").split()
        state = _state_of(folder)
        return bool(state) and state not in _ASLEEP, switches[-1] if switches else b""


def _state_of(folder: str) -> bytes:
    """The letter for the state of a process or thread; empty when it is gone."""
    stat = _read(f"{folder}/stat")
    return stat[stat.rfind(b")") + 2 :][:1]


def _all_processes() -> Iterator[int]:
    return (int(name) for name in os.listdir("/proc") if name.isdigit())


def _threads(pid: int) -> list[int]:
    try:
        return [int(name) for name in os.listdir(f"/proc/{pid}/task")]
    except OSError:
        return []


def _environment(pid: int) -> list[bytes]:
    return _read(f"/proc/{pid}/environ", _SEARCH_LIMIT).split(b"\0")


def _read(path: str, limit: int = 4096) -> bytes:
    """Nothing of what is gone or belongs to somebody else."""
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
