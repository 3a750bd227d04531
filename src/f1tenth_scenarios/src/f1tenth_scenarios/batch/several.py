"""Several commands, some of them at the same time."""

import subprocess
import tempfile
import time
from collections.abc import Sequence
from typing import Callable

from f1tenth_scenarios.stop_request import StopRequest

_LOOK_INTERVAL = 0.05  # wall s
# If this process dies, the command is told to end, and ends everything that it has started.
ENDS_WITH_PARENT = ("setpriv", "--pdeathsig", "TERM")

Finished = Callable[[int, str], None]


def run_several(commands: Sequence[Sequence[str]], jobs: int, stop: StopRequest, finished: Finished) -> None:
    """Run commands, at most `jobs` at the same time.

    Args:
        commands: what to run, with its arguments
        jobs: with 1 the commands write where this process does
        stop: once it has a signal, those that run are sent it and no more are started
        finished: is called with the exit code of each command, and with what it has written if jobs > 1
    """
    waiting = list(reversed(commands))
    running: list[_Running] = []
    told = False
    while running or (waiting and not stop.signal):
        while waiting and len(running) < jobs and not stop.signal:
            running.append(_Running(waiting.pop(), own_output=jobs > 1))
        if stop.signal and not told:
            told = True
            for each in running:
                each.process.send_signal(stop.signal)
        for each in [each for each in running if each.process.poll() is not None]:
            running.remove(each)
            finished(each.process.returncode, each.text())
        time.sleep(_LOOK_INTERVAL)


class _Running:
    """A command that has been started."""

    def __init__(self, command: Sequence[str], own_output: bool):
        # A pipe that nobody reads would stop the command.
        self._output = tempfile.TemporaryFile("w+", encoding="utf-8") if own_output else None  # noqa: SIM115
        self.process = subprocess.Popen(
            [*ENDS_WITH_PARENT, *command],
            stdin=subprocess.DEVNULL,
            stdout=self._output,
            stderr=subprocess.STDOUT if own_output else None,
        )

    def text(self) -> str:
        """What it has written; to be called once, when it has ended."""
        if self._output is None:
            return ""
        with self._output as output:
            output.seek(0)
            return output.read()
