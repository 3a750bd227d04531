"""The runs' side: starts the process that serves the watchers, and tells it how all ended."""

import contextlib
import json
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Callable

from f1tenth_judge.batch.jobs import Job


@contextlib.contextmanager
def watched(runs: Sequence[Mapping[str, Any]], title: str, results: Path) -> Iterator[Callable[[str], None]]:
    """Serve runs on this machine while the block lasts.

    Nothing that watchers do reaches a run: the other process only reads what is recorded, at low priority.
    The block is given a function that sends the watchers to a page below the folder of all results.

    Args:
        runs: of task_of, or of task_of_job
        title: of the page
        results: the folder of all results
    """
    with contextlib.closing(Serving(runs, title, results)) as serving:
        yield lambda page: serving.say({"page": page})


@contextlib.contextmanager
def watched_jobs(
    jobs: Sequence[Job], title: str, results: Path, wanted: bool
) -> Iterator[Callable[[str], None]]:
    """The same of runs that processes of their own plan and drive, if that is wanted."""
    if not wanted:
        yield lambda page: None
        return
    with watched([task_of_job(job) for job in jobs], title, results) as lead_to:
        yield lead_to


def task_of_job(job: Job) -> dict[str, Any]:
    """Of a run that a process of its own will plan and drive."""
    folder = str(job.folder)
    return {
        "name": job.folder.name,
        "scenario": job.scenario,
        "settings": list(job.settings),
        "folder": folder,
    }


class Serving:
    """The process that serves runs; its address is printed."""

    def __init__(self, runs: Sequence[Mapping[str, Any]], title: str, results: Path):
        command = [sys.executable, "-m", "f1tenth_judge.report.live"]
        self._process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0, start_new_session=True
        )
        assert self._process.stdout
        self.say({"title": title, "runs": list(runs), "results": str(results)})
        address = self._process.stdout.readline().decode().strip()
        print(f"{'watch:':19}{address or 'cannot be served'}", flush=True)

    def say(self, content: Mapping[str, Any]) -> None:
        """Tell it something, a line."""
        assert self._process.stdin
        with contextlib.suppress(BrokenPipeError):  # it has ended: nobody can watch
            self._process.stdin.write(json.dumps(content).encode() + b"\n")

    def close(self) -> None:
        """Tell it that all is over; it ends when those who watch have the last page."""
        for stream in (self._process.stdin, self._process.stdout):
            assert stream
            stream.close()
