"""One run of many: a process with a ROS master of its own, whose result is read from its folder."""

import dataclasses
import json
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Optional

from f1tenth_scenarios.batch.several import ENDS_WITH_PARENT
from f1tenth_scenarios.results.result import RESULT_FILE


@dataclasses.dataclass(frozen=True)
class Job:
    """What is to be run."""

    scenario: str  # absolute path of the file
    settings: tuple[str, ...]  # KEY=VALUE
    folder: str  # for the results

    @property
    def result_file(self) -> Path:
        """Where the result will be."""
        return Path(self.folder) / Path(self.scenario).stem / RESULT_FILE


def run_job(job: Job, program: str) -> dict[str, Any]:
    """Run a job to its end; returns the content of its result.json.

    Args:
        job: what to run
        program: path of the command `scenario`

    Raises:
        RuntimeError: it left no result; the message is what it said last.
    """
    settings = [part for setting in job.settings for part in ("--set", setting)]
    command = [sys.executable, program, "run", "--results", job.folder, *settings, job.scenario]
    done = subprocess.run(
        [*ENDS_WITH_PARENT, *command],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    result = read_finished(job)
    if result is None:
        last = (done.stdout.strip().splitlines() or ["it said nothing"])[-1]
        raise RuntimeError(f"{job.folder}: exit code {done.returncode}, no result: {last}")
    return result


def read_finished(job: Job) -> Optional[dict[str, Any]]:
    """The result of a job that was run to its end with the same settings; nothing otherwise."""
    try:
        result = json.loads(job.result_file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    told_to_stop = (result.get("culprit") or {}).get("culprit") == "runner"
    return None if told_to_stop or result.get("settings") != list(job.settings) else result


def summary_row(settings: Sequence[str], result: dict[str, Any]) -> dict[str, Any]:
    """What a table of many runs says of one."""
    return {
        **dict(setting.split("=", 1) for setting in settings),
        "verdict": result["verdict"],
        "passed": result["passed"],
        "lap_time": result["times"]["lap_time"],
        "minimum_clearance": result["minimum_clearance"],
        "trajectory_hash": result["trajectory_hash"],
        "reason": result["reason"],
    }
