"""JUnit files: the verdict and each criterion apart."""

import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from f1tenth_judge.atomic import replacing
from f1tenth_judge.judge.criterion import Criterion, Status
from f1tenth_judge.places.lookup import PACKAGE
from f1tenth_judge.results.result import Result


def junit_of(result: Result, summary: str) -> ElementTree.Element:
    """A test suite of a run, a test case for each criterion; the summary is below the first that failed."""
    suite = ElementTree.Element("testsuite", name=f"{PACKAGE}.{result.name}")
    for criterion in result.criteria:
        case = _case(suite, result.name, criterion.name)
        _add_outcome(case, criterion, summary)
        if criterion.status is Status.FAILED:
            summary = ""  # once is enough
    # The run takes its time as a whole.
    suite[0].set("time", f"{result.wall_time or 0.0:.3f}")
    return _counted(suite)


def junit_of_error(name: str, message: str) -> ElementTree.Element:
    """A test suite with one test case, the verdict, that has failed: the run could not even begin."""
    suite = ElementTree.Element("testsuite", name=f"{PACKAGE}.{name}")
    _add_text(_case(suite, name, "verdict"), "failure", f"verdict error: {message}")
    return _counted(suite)


def junit_of_cases(name: str, rows: Sequence[Mapping[str, Any]]) -> ElementTree.Element:
    """A test suite with a test case for each run; a row has `case`, `verdict`, `passed`, `reason`."""
    suite = ElementTree.Element("testsuite", name=f"{PACKAGE}.{name}")
    for row in rows:
        case = _case(suite, name, row["case"])
        if not row["passed"]:
            _add_text(case, "failure", f"verdict {row['verdict']}: {row['reason']}")
    return _counted(suite)


def write_junit(path: Path, suite: ElementTree.Element) -> None:
    """Write a JUnit file, which replaces the old one when it is complete."""
    ElementTree.indent(suite)
    with replacing(path) as temporary:
        ElementTree.ElementTree(suite).write(temporary, encoding="utf-8", xml_declaration=True)


def _case(suite, scenario: str, name: str) -> ElementTree.Element:
    return ElementTree.SubElement(
        suite, "testcase", classname=f"{PACKAGE}.{scenario}", name=f"test_{name}", time="0"
    )


def _add_outcome(case: ElementTree.Element, criterion: Criterion, summary: str) -> None:
    if criterion.status is Status.NOT_JUDGED:
        ElementTree.SubElement(case, "skipped", message=_printable(criterion.reason))
    if criterion.status is Status.FAILED:
        said = f"{criterion.name}: {criterion.comparison}: {criterion.reason}"
        _add_text(case, "failure", said, f"{said}\n{summary}".rstrip())


def _add_text(case: ElementTree.Element, tag: str, message: str, text: str = "") -> None:
    element = ElementTree.SubElement(case, tag, message=_printable(message), type="verdict")
    element.text = _printable(text or message)


def _counted(suite: ElementTree.Element) -> ElementTree.Element:
    counts = {name: len(suite.findall(f"testcase/{tag}")) for name, tag in _COUNTED.items()}
    for name, count in {"tests": len(suite), "errors": 0, **counts}.items():
        suite.set(name, str(count))
    suite.set("time", suite[0].get("time", "0"))
    return suite


_COUNTED = {"failures": "failure", "skipped": "skipped"}


def _printable(text: str) -> str:
    """Without the control characters that XML cannot hold, as a node's last words may have them."""
    return "".join(each for each in text if each.isprintable() or each in "\n\t")
