"""Where the report shows what went wrong."""

import urllib.parse
from collections.abc import Iterable
from pathlib import Path

from f1tenth_judge.record.files import REPORT_FILE
from f1tenth_judge.results.result import Result

_LEAD = 1.0  # s, before something happened, from which on it is to be seen


def moment_of(contacts: Iterable[float], end: float) -> float:
    """A second before the first contact, or else before the end of the run; all in s."""
    return max(min([*contacts, end]) - _LEAD, 0.0)


def address_of(folder: Path, name: str, moment: float) -> str:
    """The address of a moment (s) in the report of all results, which is there once it is written.

    `folder`: of the run, below that of all results.
    """
    report = (folder.resolve().parent / REPORT_FILE).as_uri()
    return f"{report}#{urllib.parse.quote(name, safe='')}?t={moment:.3f}"


def replay_of(result: Result) -> str:
    """The address at which the report shows what went wrong with a run."""
    contacts = (contact.start for contact in result.judgement.contacts)
    return address_of(result.folder, result.name, moment_of(contacts, result.judgement.decision.stamp))
