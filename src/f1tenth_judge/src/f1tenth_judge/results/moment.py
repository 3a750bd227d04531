"""Where the report shows what went wrong."""

import urllib.parse

from f1tenth_judge.record.files import REPORT_FILE
from f1tenth_judge.results.result import Result

_LEAD = 1.0  # s, before something happened, from which on it is to be seen


def moment_of(result: Result) -> float:
    """A second before the first contact, or before the run was decided, s."""
    contacts = [contact.start for contact in result.judgement.contacts]
    return max(min([*contacts, result.judgement.decision.stamp]) - _LEAD, 0.0)


def replay_of(result: Result) -> str:
    """The address of that moment in the report of all results, which is there once it is written."""
    report = (result.folder.resolve().parent / REPORT_FILE).as_uri()
    return f"{report}#{urllib.parse.quote(result.name, safe='')}?t={moment_of(result):.3f}"
