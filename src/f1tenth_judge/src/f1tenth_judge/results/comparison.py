"""Two runs or results folders beside each other: what has become worse?"""

import dataclasses
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Callable, NamedTuple, Optional, TypeAlias

from f1tenth_judge.record.files import RESULT_FILE
from f1tenth_judge.results.result_file import read_result, read_results

_PASSED, _FAILED = "passed", "failed"
_SEED, _ALL_SEEDS = r"(^|,)seed=\d+", "all seeds"
_Runs: TypeAlias = Sequence[Mapping[str, Any]]


class Tolerance(NamedTuple):
    """How much worse a figure may become; None: it is not compared."""

    lap_time: Optional[float] = None  # part of the base's best lap
    clearance: Optional[float] = None  # m


@dataclasses.dataclass(frozen=True)
class Comparison:
    """A scenario in both folders, or in one of them."""

    name: str
    planners: str  # where they are not the same
    verdicts: str
    laps: str  # the best ones
    clearances: str
    problems: tuple[str, ...]  # what has become worse

    @property
    def row(self) -> tuple[str, ...]:
        """Of a table."""
        name = f"{self.name} ({self.planners})" if self.planners else self.name
        result = "; ".join(self.problems) or "as good"
        return name, self.verdicts, self.laps, self.clearances, result


def compare_folders(base: Path, head: Path, tolerance: Tolerance) -> list[Comparison]:
    """All scenarios of two results folders, by name; or two runs, whatever their names.

    Runs whose names differ in `seed=N` alone, as those of a sweep do, are compared as a whole.

    Raises:
        ScenarioError: a folder has no results, or one of them cannot be read.
    """
    before, after = _runs(base), _runs(head)
    if (base / RESULT_FILE).is_file() and (head / RESULT_FILE).is_file():
        (old,), (new,) = before, after
        name = _change(old, new)
        before, after = {name: before[old]}, {name: after[new]}
    names = sorted(before | after)
    return [_compared(name, before.get(name, []), after.get(name, []), tolerance) for name in names]


def _runs(folder: Path) -> dict[str, list[Mapping[str, Any]]]:
    """The results of a folder by the names of their runs without the seed."""
    if (folder / RESULT_FILE).is_file():
        return {folder.resolve().name: [read_result(folder / RESULT_FILE)]}
    found: dict[str, list[Mapping[str, Any]]] = {}
    for name, result in read_results(folder).items():
        found.setdefault(re.sub(_SEED, "", name).strip(",") or _ALL_SEEDS, []).append(result)
    return found


def _compared(name: str, before: _Runs, after: _Runs, tolerance: Tolerance) -> Comparison:
    if max(len(before), len(after)) > 1:
        # Imported late: scipy takes longer than everything else that is done here.
        from f1tenth_judge.results.several_seeds import cells_of_seeds, problems_of_seeds

        cells = cells_of_seeds(before, after)
        problems = _problems(before, after, lambda old, new: problems_of_seeds(old, new, *tolerance))
    else:
        cells = _cells(*(each[0] if each else None for each in (before, after)))
        problems = _problems(before, after, lambda old, new: _worse(old[0], new[0], tolerance))
    old, new = (_planners(each[0]) if each else "" for each in (before, after))
    return Comparison(name, _change(old, new) if old != new and old and new else "", *cells, tuple(problems))


def _planners(result: Mapping[str, Any]) -> str:
    names = (each.get("planner", "") for each in result["cars"].values())
    return " and ".join(name.rpartition("/")[2] for name in names)


def _cells(*sides: Optional[Mapping[str, Any]]) -> tuple[str, str, str]:
    return (
        _change(*(each["verdict"] if each else "not run" for each in sides)),
        _change(*(_figure(each["times"]["lap_time"], "s") if each else "" for each in sides)),
        _change(*(_figure(each["minimum_clearance"], "m") if each else "" for each in sides)),
    )


def table(comparisons: Sequence[Comparison]) -> str:
    """A line per scenario."""
    rows = [
        ("scenario", "verdict", "best lap", "clearance", "result"),
        *(each.row for each in comparisons),
    ]
    widths = [max(map(len, column)) for column in zip(*rows)]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows
    )


def _problems(before: _Runs, after: _Runs, worse: Callable[[_Runs, _Runs], Iterator[str]]) -> Iterator[str]:
    if before and after:
        yield from worse(before, after)
    elif before:
        yield "was not run"
    # What is new is judged in its own run.


def _worse(before, after, tolerance):
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
