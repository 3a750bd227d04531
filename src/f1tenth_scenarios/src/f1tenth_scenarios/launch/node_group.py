"""The nodes of a run: their ends are noticed at once, and all are told to end together."""

import os
import select
import signal
import time
from collections.abc import Sequence

from roslaunch.core import printerrlog, printlog_bold
from roslaunch.nodeprocess import LocalProcess

# wall s that a node has after SIGINT, and then after SIGTERM
_GRACES = ((signal.SIGINT, 4.0), (signal.SIGTERM, 2.0), (signal.SIGKILL, 2.0))
_STOP_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class NodeGroup:
    """Processes that roslaunch has described; for the main thread.

    SIGINT, SIGTERM and SIGHUP stop the wait.
    """

    def __init__(self):
        self._by_descriptor: dict[int, LocalProcess] = {}
        self._poll = select.poll()
        self._stopped = False
        self._wakeup, told = os.pipe()
        os.set_blocking(told, False)
        self._poll.register(self._wakeup, select.POLLIN)
        signal.set_wakeup_fd(told, warn_on_full_buffer=False)
        for number in _STOP_SIGNALS:
            signal.signal(number, self._on_signal)

    def wait_for_input(self, descriptor: int) -> bool:
        """Wait until there is something to read, or its end; returns whether no stop was asked for."""
        self._poll.register(descriptor, select.POLLIN)
        self._poll.poll()
        self._poll.unregister(descriptor)
        return not self._stopped

    def start(self, processes: Sequence[LocalProcess]) -> None:
        """Start them one after the other, unless a stop was asked for.

        Raises:
            roslaunch.core.RLException: an executable cannot be run.
        """
        for each in processes:
            if not self._stopped:
                self._start(each)

    def wait(self) -> None:
        """Return when a stop was asked for, a required process ended, or none is left."""
        while self._by_descriptor and not self._stopped:
            for process in self._take_ended(timeout=None):
                self._report(process)

    def stop(self) -> None:
        """End what is left, all at once. To be called once."""
        # What was asked for is being done: its wakeups would make the waits busy ones.
        signal.set_wakeup_fd(-1)
        self._poll.unregister(self._wakeup)
        for number, grace in _GRACES:
            for process in self._by_descriptor.values():
                _signal_group(process, number)
            self._wait_for_all(grace)

    def _on_signal(self, _number, _frame):
        self._stopped = True

    def _start(self, process: LocalProcess) -> None:
        process.start()
        if not process.is_alive():
            process.pid = process.popen.pid  # roslaunch keeps none of one that has failed by now
            self._report(process)
            return
        descriptor = os.pidfd_open(process.pid)
        self._by_descriptor[descriptor] = process
        self._poll.register(descriptor, select.POLLIN)

    def _take_ended(self, timeout) -> list[LocalProcess]:
        """Those that ended within a time (wall s; None: any time); fewer if a signal comes."""
        ready = self._poll.poll(None if timeout is None else timeout * 1000.0)
        return [self._collect(each) for each, _ in ready if each in self._by_descriptor]

    def _collect(self, descriptor: int) -> LocalProcess:
        self._poll.unregister(descriptor)
        os.close(descriptor)
        process = self._by_descriptor.pop(descriptor)
        process.is_alive()  # takes the exit code
        return process

    def _report(self, process: LocalProcess) -> None:
        """In the words of roslaunch."""
        described = process.get_exit_description()
        if process.required:
            self._stopped = True
            bar = "=" * 80
            printerrlog(
                f"{bar}REQUIRED process [{process.name}] has died!\n{described}\nInitiating shutdown!\n{bar}"
            )
        else:
            (printerrlog if process.exit_code else printlog_bold)(f"[{process.name}] {described}")

    def _wait_for_all(self, seconds: float) -> None:
        deadline = time.monotonic() + seconds
        while self._by_descriptor and (left := deadline - time.monotonic()) > 0:
            self._take_ended(left)


def _signal_group(process: LocalProcess, number: int) -> None:
    # A node leads a group of its own.
    try:
        os.killpg(process.pid, number)
    except ProcessLookupError:
        return
