"""Sockets of planners that send small messages at once.

TCP holds a small message back until the one before it is acknowledged, which takes the receiver up to 40 ms
of wall time (Nagle's algorithm, RFC 896; delayed acknowledgements, RFC 1122). A node that waits for a message
on its way like this is at rest: in lockstep, the period in which it hears of it would depend on the machine.
"""

import ctypes
import errno
import os
import socket
import time
from collections.abc import Callable, Iterable

from f1tenth_judge.drivers.rest import marked_processes

_PIDFD_GETFD = 438  # the system call's number, on every architecture
_GONE = (errno.EBADF, errno.ENOENT, errno.ESRCH)
_INTERVAL = 0.1  # wall s: a planner's first period comes 0.3 s after the last of its connections, at least


class PromptSockets:
    """Finds the sockets of planners of several processes, and sets TCP_NODELAY.

    What a socket accepts inherits it. A planner of one process has nobody whom it would keep waiting: the
    simulator asks for its commands without delay.
    """

    def __init__(self, marks: Iterable[str], clock: Callable[[], float] = time.monotonic):
        """`marks`: NAME=VALUE in the environment of a planner's processes; `clock`: wall time, s."""
        self._marks = list(marks)
        self._clock = clock
        self._looked = -_INTERVAL
        self._known: set[str] = set()
        self.refusal = ""  # why sockets cannot be reached, in words

    def poll(self) -> None:
        """Look for new ones, now and then."""
        if not self._marks or self.refusal or self._clock() - self._looked < _INTERVAL:
            return
        self._looked = self._clock()
        for pids in map(marked_processes, self._marks):
            for pid in pids if len(pids) > 1 else ():
                self._try(pid)

    def _try(self, pid: int) -> None:
        try:
            self._reach(pid)
        except AttributeError:
            self.refusal = "this Python cannot ask for them"  # built for Linux before 5.3
        except OSError as error:
            if error.errno not in _GONE:
                self.refusal = error.strerror or str(error)

    def _reach(self, pid: int) -> None:
        folder = f"/proc/{pid}/fd"
        links = {name: _link(f"{folder}/{name}") for name in os.listdir(folder)}
        sockets = {name: link for name, link in links.items() if link.startswith("socket:")}
        new = {name: link for name, link in sockets.items() if link not in self._known}
        if not new:
            return
        process = os.pidfd_open(pid)
        try:
            for name, link in new.items():
                _send_at_once(process, int(name))
                self._known.add(link)
        finally:
            os.close(process)


def _link(path: str) -> str:
    """Where it leads; empty if it is gone."""
    try:
        return os.readlink(path)
    except OSError:
        return ""


def _send_at_once(process: int, descriptor: int) -> None:
    """Of a socket that another process has open.

    Not by a socket of Python, which may give it a time limit: that would hold for the other process, too.

    Raises:
        OSError: it cannot be had.
    """
    libc = ctypes.CDLL(None, use_errno=True)
    copy = libc.syscall(_PIDFD_GETFD, process, descriptor, 0)
    if copy < 0:
        number = ctypes.get_errno()
        raise OSError(number, os.strerror(number))
    try:
        is_on = ctypes.c_int(1)
        # It fails for a socket of another kind, which is as it should be.
        size = ctypes.sizeof(is_on)
        libc.setsockopt(copy, socket.IPPROTO_TCP, socket.TCP_NODELAY, ctypes.byref(is_on), size)
    finally:
        os.close(copy)
