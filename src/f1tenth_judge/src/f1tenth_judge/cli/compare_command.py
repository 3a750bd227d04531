"""f1tenth compare."""

import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Optional

from f1tenth_judge.cli.exit_codes import NOT_PASSED, PASSED
from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.results.comparison import Comparison, Tolerance, compare_folders, table
from f1tenth_judge.results.junit import write_junit

_SUITE = "f1tenth compare"


def compare(options) -> int:
    """Compare results with those of another commit or planner."""
    tolerance = Tolerance(
        _number("--lap-time", options.lap_time, r"\+?(\d+(?:\.\d+)?) ?%", "+N%, as in +2%", 0.01),
        _number("--clearance", options.clearance, r"-?(\d+(?:\.\d+)?)", "-M, as in -0.02", 1.0),
    )
    found = compare_folders(options.base, options.head, tolerance)
    worse = [each for each in found if each.problems]
    print(table(found))
    print(f"{len(worse)} of {len(found)} scenarios became worse")
    if options.junit:
        _write_junit(options.junit, found)
    return NOT_PASSED if worse else PASSED


def _number(option: str, text: Optional[str], pattern: str, rule: str, unit: float) -> Optional[float]:
    if text is None:
        return None
    match = re.fullmatch(pattern, text)
    if not match:
        raise ScenarioError(f"{option} {text}: must be {rule}")
    return float(match[1]) * unit


def _write_junit(path: Path, comparisons: list[Comparison]) -> None:
    failures = sum(bool(each.problems) for each in comparisons)
    suite = ElementTree.Element("testsuite", name=_SUITE, tests=str(len(comparisons)), failures=str(failures))
    for each in comparisons:
        case = ElementTree.SubElement(suite, "testcase", classname=_SUITE, name=each.name)
        if each.problems:
            ElementTree.SubElement(case, "failure", message="; ".join(each.problems))
    with writing(path):
        write_junit(path, suite)
