"""Starting a process with everything it will start, and ending all of it on every path."""

import os
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
_POLL_INTERVAL = 0.02  # wall s


class ProcessTree:
    """A child process, in a group of its own, and all its descendants."""

    def __init__(self, command: Sequence[str], log_file: Path, environment: Mapping[str, str]):
        """Start the process; its output goes to log_file. If this process dies, the child gets a SIGINT."""
        self._mark = uuid.uuid4().hex
        with open(log_file, "wb") as log:
            self._child = subprocess.Popen(
                ["setpriv", "--pdeathsig", "INT", *command],
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
                env={**os.environ, **environment, _MARK: self._mark},
                start_new_session=True,
            )

    def exit_code(self) -> Optional[int]:
        """The child's exit code; nothing while it runs."""
        return self._child.poll()

    def stop(self, grace: float, last_grace: float = 2.0) -> None:
        """End the child and all descendants; returns when none is left.

        Args:
            grace: wall seconds that the child has after SIGINT to end what it started
            last_grace: wall seconds after SIGTERM, before SIGKILL
        """
        self._signal_group(signal.SIGINT)
        self._wait_for_child(grace)
        if self._members():
            for each in self._members():
                _send(each, signal.SIGTERM)
            self._wait_for_all(last_grace)
        while self._members():
            for each in self._members():
                _send(each, signal.SIGKILL)
            time.sleep(_POLL_INTERVAL)
        self._child.wait()

    def _signal_group(self, number: int) -> None:
        if self._child.poll() is None:
            os.killpg(self._child.pid, number)

    def _wait_for_child(self, seconds: float) -> None:
        try:
            self._child.wait(seconds)
        except subprocess.TimeoutExpired:
            return

    def _wait_for_all(self, seconds: float) -> None:
        deadline = time.monotonic() + seconds
        while self._members() and time.monotonic() < deadline:
            time.sleep(_POLL_INTERVAL)

    def _members(self) -> list[psutil.Process]:
        self._child.poll()  # collects the exit code, so that the child is no zombie
        return [each for each in psutil.process_iter() if self._is_member(each)]

    def _is_member(self, process: psutil.Process) -> bool:
        try:
            return process.status() != psutil.STATUS_ZOMBIE and process.environ().get(_MARK) == self._mark
        except psutil.Error:
            return False


def _send(process: psutil.Process, number: int) -> None:
    try:
        process.send_signal(number)
    except psutil.NoSuchProcess:
        return
