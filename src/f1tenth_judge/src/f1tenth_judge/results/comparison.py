"""Two results folders beside each other: what has become worse?"""

import dataclasses
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.results.result_file import read_results

_PASSED, _FAILED = "passed", "failed"


@dataclasses.dataclass(frozen=True)
class Tolerance:
    """How much worse a figure may become; None: it is not compared."""

    lap_time: Optional[float] = None  # part of the base's best lap
    clearance: Optional[float] = None  # m


@dataclasses.dataclass(frozen=True)
class Comparison:
    """A scenario in both folders, or in one of them."""

    name: str
    base: Optional[Mapping[str, Any]]  # what its result.json says; nothing where it was not run
    head: Optional[Mapping[str, Any]]
    problems: tuple[str, ...]  # what has become worse

    def cells(self) -> tuple[str, ...]:
        """A row of a table: name, verdicts, best laps, clearances, and what has become worse."""
        sides = (self.base, self.head)
        return (
            self.name,
            _change(*(each["verdict"] if each else "not run" for each in sides)),
            _change(*(_figure(each["times"]["lap_time"], "s") if each else "" for each in sides)),
            _change(*(_figure(each["minimum_clearance"], "m") if each else "" for each in sides)),
            "; ".join(self.problems) or "as good",
        )


def compare_folders(base: Path, head: Path, tolerance: Tolerance) -> list[Comparison]:
    """All scenarios of two results folders, by name.

    Raises:
        ScenarioError: a folder has no results, or one of them cannot be read.
    """
    before, after = read_results(base), read_results(head)
    return [
        Comparison(
            name,
            before.get(name),
            after.get(name),
            tuple(_problems(before.get(name), after.get(name), tolerance)),
        )
        for name in sorted(before | after)
    ]


def table(comparisons: Sequence[Comparison]) -> str:
    """A line per scenario."""
    rows = [
        ("scenario", "verdict", "best lap", "clearance", "result"),
        *(each.cells() for each in comparisons),
    ]
    widths = [max(map(len, column)) for column in zip(*rows)]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows
    )


def _problems(before, after, tolerance):
    if before is None:
        return  # new; whether it passes is judged in its own run
    if after is None:
        yield "was not run"
        return
    if before["passed"] and not after["passed"]:
        yield f"did not pass: {after['reason']}"
    elif before["verdict"] != after["verdict"] and not after["passed"]:
        yield f"verdict {after['verdict']} instead of {before['verdict']}"
    yield from _criteria_lost(before, after)
    yield from _slower(before, after, tolerance.lap_time)
    yield from _closer(before, after, tolerance.clearance)


def _criteria_lost(before, after):
    met = {each["name"] for each in before["criteria"] if each["status"] == _PASSED}
    for each in after["criteria"]:
        if each["name"] in met and each["status"] == _FAILED:
            yield f"criterion {each['name']} failed: {each['reason']}"


def _slower(before, after, part: Optional[float]):
    old, new = before["times"]["lap_time"], after["times"]["lap_time"]
    if part is None or old is None:
        return
    if new is None:
        yield "no lap was completed"
    elif new > old * (1 + part):
        yield f"lap time {new:.3f} s, {100 * (new / old - 1):+.1f} %, may be {100 * part:+.1f} %"


def _closer(before, after, metres: Optional[float]):
    old, new = before["minimum_clearance"], after["minimum_clearance"]
    if metres is not None and old is not None and new is not None and new < old - metres:
        yield f"clearance {new:.3f} m, {new - old:+.3f} m, may be {-metres:+.3f} m"


def _figure(value: Optional[float], unit: str) -> str:
    return "none" if value is None else f"{value:.3f} {unit}"


def _change(before: str, after: str) -> str:
    return before if before == after else f"{before} -> {after}"
