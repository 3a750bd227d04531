"""Runs of scenarios in processes of their own, some of them at the same time."""

import dataclasses
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.record.files import RESULT_FILE, read_json
from f1tenth_judge.stop_request import StopRequest

PROGRAM = (sys.executable, "-m", "f1tenth_judge")
# If this process dies, a run is told to end, and ends everything that it has started.
_ENDS_WITH_PARENT = ("setpriv", "--pdeathsig", "TERM")
_JUDGED = (0, 1)  # exit codes of a run that left a result
_LOOK_INTERVAL = 0.05  # wall s


@dataclasses.dataclass(frozen=True)
class Job:
    """What is to be run."""

    scenario: str  # absolute path of the file
    settings: tuple[str, ...]  # KEY=VALUE
    results: str  # folder for the folder of the results
    options: tuple[str, ...] = ()  # of `scenario run` besides
    program: tuple[str, ...] = dataclasses.field(default_factory=lambda: PROGRAM)  # the command `f1tenth`
    name: str = ""  # of the run, and of its folder; empty: that of the scenario

    @property
    def folder(self) -> Path:
        """Where the results will be."""
        return Path(self.results) / (self.name or Path(self.scenario).stem)

    @property
    def command(self) -> list[str]:
        """What runs it."""
        settings = [part for setting in self.settings for part in ("--set", setting)]
        name = ["--name", self.name] if self.name else []
        options = ["--results", self.results, *name, *settings, *self.options]
        return [*_ENDS_WITH_PARENT, *self.program, "run", *options, self.scenario]


@dataclasses.dataclass(frozen=True)
class Outcome:
    """How a job ended."""

    job: Job
    exit_code: int
    output: str
    result: Optional[dict[str, Any]]  # what is in its result.json; nothing unless this run wrote one

    @property
    def problem(self) -> str:
        """Why there is no result."""
        last = (self.output.strip().splitlines() or ["it said nothing"])[-1]
        return f"{self.job.folder}: exit code {self.exit_code}, no result: {last}"


def run_jobs(jobs: Sequence[Job], stop: StopRequest, at_once: int = 1) -> Iterator[Outcome]:
    """Run jobs; yields their outcomes in the order in which they end.

    Args:
        jobs: what to run
        stop: once it has a signal, those that run are sent it and no more are started
        at_once: how many run at the same time
    """
    waiting = list(reversed(jobs))
    running: list[_Running] = []
    told = False
    while running or (waiting and not stop.signal):
        while waiting and len(running) < at_once and not stop.signal:
            running.append(_Running(waiting.pop()))
        if stop.signal and not told:
            told = True
            for each in running:
                each.process.send_signal(stop.signal)
        for each in [each for each in running if each.process.poll() is not None]:
            running.remove(each)
            yield each.outcome()
        time.sleep(_LOOK_INTERVAL)


def run_job(job: Job) -> Outcome:
    """Run one job to its end."""
    (outcome,) = run_jobs([job], StopRequest())
    return outcome


def read_result(folder: Path) -> Optional[dict[str, Any]]:
    """The result in a folder; nothing when it is missing or broken."""
    return read_json(folder / RESULT_FILE) or None


class _Running:
    """A job that has been started."""

    def __init__(self, job: Job):
        self._job = job
        self._result_before = _identity(job.folder / RESULT_FILE)
        # A pipe that nobody reads would stop the run.
        self._output = tempfile.TemporaryFile("w+", encoding="utf-8")  # noqa: SIM115
        self.process = subprocess.Popen(
            job.command, stdin=subprocess.DEVNULL, stdout=self._output, stderr=subprocess.STDOUT
        )

    def outcome(self) -> Outcome:
        """To be called once, when it has ended."""
        code = self.process.returncode
        with self._output as output:
            output.seek(0)
            text = output.read()
        # A run that broke off early leaves the result of an earlier one where it is.
        is_new = _identity(self._job.folder / RESULT_FILE) != self._result_before
        result = read_result(self._job.folder) if code in _JUDGED and is_new else None
        return Outcome(self._job, code, text, result)


def _identity(path: Path) -> Optional[tuple[int, int]]:
    """Tells a file from one that took its place."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_ino, status.st_mtime_ns
