"""Starting a process with everything it will start, and ending all of it on every path."""

import contextlib
import ctypes
import os
import re
import select
import signal
import subprocess
import time
import uuid
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Optional

import psutil

# Every process of a tree inherits this variable: one that left its parent or its group is found as well.
_MARK = "F1TENTH_SCENARIO_TREE"
# This process becomes the parent of those that lose theirs (prctl(2), PR_SET_CHILD_SUBREAPER): so one that
# has thrown the variable away is found, too.
_ADOPT_ORPHANS = 36
_INTERPRETER = re.compile(r"(^|/)python[0-9.]*$")


def _adopt_orphans(does: bool) -> None:
    ctypes.CDLL(None).prctl(_ADOPT_ORPHANS, int(does), 0, 0, 0)


def process_start() -> float:
    """When this process was started, as time.monotonic() counts (s)."""
    return time.monotonic() - (time.time() - psutil.Process().create_time())


def program_of(pid: int) -> str:
    """What a process runs, PACKAGE/TYPE of a node; empty if it is not there."""
    try:
        words = psutil.Process(pid).cmdline()
    except psutil.Error:
        return ""
    program = next((word for word in words if not _INTERPRETER.search(word)), "")
    return "/".join(Path(program).parts[-2:])


_started: set[int] = set()  # the children of all trees that are not stopped


class ProcessTree:
    """A child process, in a group of its own, and all its descendants."""

    def __init__(
        self,
        command: Sequence[str],
        log_file: Path,
        environment: Mapping[str, str],
        descriptors: Sequence[int] = (),
    ):
        """Start the process; its output goes to log_file. If this process dies, the child gets a SIGINT.

        It inherits `descriptors`, files that are open here.
        """
        self._mark = uuid.uuid4().hex
        self._interrupted_at: Optional[float] = None
        _adopt_orphans(True)
        self._before = {each.pid for each in psutil.Process().children()}
        with open(log_file, "wb") as log:
            self._child = subprocess.Popen(
                ["setpriv", "--pdeathsig", "INT", *command],
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
                env={**os.environ, **environment, _MARK: self._mark},
                start_new_session=True,
                pass_fds=descriptors,
            )
        _started.add(self._child.pid)
        self._ending = [self._child.pid]  # the processes that are told to end

    def exit_code(self) -> Optional[int]:
        """The child's exit code; nothing while it runs."""
        return self._child.poll()

    def wait(self, patience: float) -> Optional[int]:
        """The child's exit code as soon as it has ended; nothing if it runs on for a time (wall s)."""
        wait_for_ends([self._child.pid], time.monotonic() + patience)
        return self._child.poll()

    def interrupt(self, pid: Optional[int], patience: float) -> None:
        """Tell the child to end all that it has started, and wait until a process, else the child, has ended.

        Args:
            pid: of the process; none: the child
            patience: wall seconds from the first SIGINT
        """
        wait_for_ends([pid or self._child.pid], self._interrupt() + patience)

    def stop(self, grace: float, last_grace: float = 1.0) -> None:
        """End the child and all descendants; returns when none is left.

        Args:
            grace: wall seconds that the child has after the first SIGINT to end what it started
            last_grace: wall seconds after SIGTERM, before SIGKILL
        """
        deadline = self._interrupt() + grace
        wait_for_ends(self._ending, deadline)
        wait_for_ends(self._send(signal.SIGTERM), time.monotonic() + last_grace)
        while killed := self._send(signal.SIGKILL):
            wait_for_ends(killed, time.monotonic() + last_grace)
        self._child.wait()
        _started.discard(self._child.pid)
        if not _started:
            _adopt_orphans(False)

    def _interrupt(self) -> float:
        """Tell the child to end, and those that it can no longer tell; only once. Returns when that was."""
        if self._interrupted_at is None:
            self._interrupted_at = time.monotonic()
            # A stopped process could not end, and none could end without the master.
            _signal([*self._members(), *psutil.Process().children()], signal.SIGCONT)
            if self._child.poll() is None:
                os.killpg(self._child.pid, signal.SIGINT)
            else:
                self._ending = self._send(signal.SIGINT)
        return self._interrupted_at

    def _send(self, number: int) -> list[int]:
        """Signal all that are left; returns their process ids."""
        members = self._members()
        _signal(members, number)
        return [each.pid for each in members]

    def _members(self) -> list[psutil.Process]:
        self._child.poll()  # collects the exit code, so that the child is no zombie
        return [*processes_with(_MARK, self._mark), *self._unmarked_orphans()]

    def _unmarked_orphans(self) -> list[psutil.Process]:
        """What this process has adopted since, and bears no mark of any tree."""
        known = self._before | _started
        return [each for each in psutil.Process().children() if each.pid not in known and _is_unmarked(each)]


def processes_with(name: str, value: str) -> list[psutil.Process]:
    """All that run with this variable in their environment, which processes inherit."""
    return [each for each in psutil.process_iter() if _has(each, name, value)]


def _is_unmarked(process: psutil.Process) -> bool:
    """Whether a child of this process lives, and was started by another one without our variable."""
    try:
        # What this process starts stays in its session, except for trees, or was there before.
        if os.getsid(process.pid) == os.getsid(0):
            return False
        if process.status() == psutil.STATUS_ZOMBIE:
            os.waitpid(process.pid, os.WNOHANG)
            return False
        return _MARK not in process.environ()
    except (OSError, psutil.Error):
        return False


def _has(process: psutil.Process, name: str, value: str) -> bool:
    try:
        return process.status() != psutil.STATUS_ZOMBIE and process.environ().get(name) == value
    except psutil.Error:
        return False


def _signal(processes: Sequence[psutil.Process], number: int) -> None:
    for each in processes:
        with contextlib.suppress(psutil.NoSuchProcess):
            each.send_signal(number)


def wait_for_ends(pids: Sequence[int], deadline: float) -> bool:
    """Wait until all processes have ended, or for a time, as time.monotonic() counts; whether they have."""
    with contextlib.ExitStack() as stack:
        running = select.poll()
        left = 0
        for pid in pids:
            with contextlib.suppress(ProcessLookupError):
                descriptor = os.pidfd_open(pid)
                stack.callback(os.close, descriptor)
                running.register(descriptor, select.POLLIN)
                left += 1
        while left and (patience := deadline - time.monotonic()) > 0:
            for descriptor, _ in running.poll(patience * 1000.0):
                running.unregister(descriptor)
                left -= 1
    return not left
