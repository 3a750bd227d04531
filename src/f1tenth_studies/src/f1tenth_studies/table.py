"""The document of a study: what it is, how and where it was made, and its table, in Markdown."""

import datetime
import os
import platform
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from f1tenth_judge.results.versions import commits

from f1tenth_studies.study import Run, Study


def document(study: Study, runs: Sequence[Run], command: str) -> str:
    """The whole document, of runs in the order of their values and made by a command."""
    return f"# {study.title}\n\n{study.text.strip()}\n\n{made_by(command)}\n{table(study, runs)}"


def made_by(command: str) -> str:
    """When and where a document was made, and by what."""
    commit = commits({})["commit"]
    return f"Made on {datetime.date.today()} at commit {commit} on {machine()} by\n\n    {command}\n"


def table(study: Study, runs: Sequence[Run]) -> str:
    """A row for each combination of the keys that make one."""
    groups: dict[tuple[str, ...], list[Run]] = {}
    for run in runs:
        groups.setdefault(tuple(run.values[key] for key in study.rows), []).append(run)
    heads = [*(key.rpartition(".")[2] for key in study.rows), *(each.head for each in study.columns)]
    lines = [heads, ["---"] * len(heads)]
    for values, group in groups.items():
        lines.append([*values, *(_text(each.value(group), each.digits) for each in study.columns)])
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def machine() -> str:
    """The processor of this machine and how many of its cores may be used."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return f"{names[0] if names else platform.machine()}, {len(os.sched_getaffinity(0))} cores"


def _text(value: Any, digits: int) -> str:
    return f"{value:.{digits}f}" if isinstance(value, float) else str(value)
