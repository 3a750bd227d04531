"""The document of the faults."""

import os
import re
from collections.abc import Sequence
from typing import Optional

from f1tenth_studies.faults.interrupts import Interrupts
from f1tenth_studies.faults.victim import MOST_SECONDS, Ending
from f1tenth_studies.table import made_by

_HEAD = """\
# Faults

How a run of `circuit1` (two laps, in lockstep) ends when something breaks after 3 s of simulated time.
{made}
`limits.answer` is 5 s here and `limits.wall` 60 s: a stopped node is noticed after the former, a stopped
clock after the latter. Wanted: the right verdict and culprit, a JUnit file, and at most {most:g} s
from the verdict until nothing of the run is left. A run that cannot begin, because there is too little memory
or nowhere to write results and JUnit file, says so in one line and ends with exit code 2.

| fault | verdict | culprit | exit code | verdict after (s) | all gone after (s) | JUnit |
| --- | --- | --- | --- | --- | --- | --- |
"""
_FOLDER = r"/\S+: "  # where this run had its results
_INTERRUPTS = """
## SIGINT

Sent at random moments of a command; wanted: exit code 130, no traceback, no process left after {most:g} s.

| command | moments | all gone after at most (s) | problems |
| --- | --- | --- | --- |
"""


def document(endings: Sequence[tuple[str, Ending]], interrupts: Sequence[Interrupts], command: str) -> str:
    """The whole document: endings by fault, and interrupted commands."""
    made = made_by(command, f", with a load of {os.getloadavg()[1]:.0f} at the end,")
    text = _HEAD.format(made=made, most=MOST_SECONDS) + "".join(_row(name, each) for name, each in endings)
    if interrupts:
        text += _INTERRUPTS.format(most=MOST_SECONDS) + "".join(map(_interrupt_row, interrupts))
    return text


def _row(name: str, ending: Ending) -> str:
    result = ending.result or {}
    culprit = (result.get("culprit") or {}).get("culprit", "–")
    verdict = result.get("verdict") or _said(ending)
    code = "killed" if ending.exit_code is None else ending.exit_code
    times = f"{ending.seconds - ending.seconds_after:.1f} | {ending.seconds_after:.1f}"
    return f"| {name} | {verdict} | {culprit} | {code} | {times} | {'yes' if ending.has_junit else 'no'} |\n"


def _said(ending: Ending) -> str:
    """What is shown in place of a verdict that could not be written."""
    lines = [line for line in ending.said.splitlines() if line.startswith("scenario: ")]
    return f"none: {re.sub(_FOLDER, '', lines[-1].removeprefix('scenario: '))}" if lines else "none"


def _interrupt_row(each: Interrupts) -> str:
    problems = ", ".join(each.problems) or "none"
    return f"| `{each.command}` | {len(each.endings)} | {each.slowest:.1f} | {problems} |\n"


def problem(ending: Ending) -> Optional[str]:
    """What is wrong with an ending, whatever the fault was; None if nothing is."""
    if ending.exit_code is None:
        return "had to be killed"
    if ending.seconds_after > MOST_SECONDS:
        return f"all gone only {ending.seconds_after:.1f} s after the verdict"
    return "a traceback" if "Traceback" in ending.said else None
