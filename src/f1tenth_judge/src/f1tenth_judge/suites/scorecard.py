"""What came out of a suite, its worst cases first: as text and as a page."""

import math
from collections.abc import Iterator, Mapping, Sequence
from html import escape
from typing import Any

from f1tenth_judge.report.tables import links, number, page, run_link, table, verdict

Row = Mapping[str, Any]
_SHOWN = 10  # cases, in the text
_HEADS = ("case", "verdict", "clearance", "best lap", "lap/reference", "reason")


def worst_first(rows: Sequence[Row]) -> list[Row]:
    """Cases that failed before those that passed, and then by clearance as it is shown."""
    return sorted(rows, key=lambda row: (row["passed"], _shown(row["minimum_clearance"]), row["case"]))


def scorecard(rows: Sequence[Row]) -> str:
    """All cases that failed, or the worst of those that passed, a line each."""
    shown = max(_SHOWN, sum(not row["passed"] for row in rows))
    lines = [_HEADS, *(_cells(row) for row in worst_first(rows)[:shown])]
    return "\n".join(
        f"{case:32}{what:12}{near:>11}{lap:>11}{ratio:>14}  {reason}"
        for case, what, near, lap, ratio, reason in lines
    )


def scorecard_page(title: str, facts: Mapping[str, str], rows: Sequence[Row], files: Sequence[str]) -> str:
    """The facts about the suite, all its cases with links to their replays, and links to files beside it."""
    about = table((), ((escape(name), escape(value)) for name, value in facts.items()))
    note = (
        "<p>Lap/reference: the best lap divided by the fastest lap possible on the circuit, or else by a lap"
        " at the speeds of its raceline, or by the fastest lap along the middle of the road.</p>"
    )
    return page(title, [about, links(files), table(_HEADS, _linked(rows)), note])


def _linked(rows: Sequence[Row]) -> Iterator[list[str]]:
    for row in worst_first(rows):
        case, what, *others = _cells(row)
        yield [run_link(case, case), verdict(what, row["passed"]), *map(escape, others)]


def _cells(row: Row) -> tuple[str, ...]:
    near, lap = number(row["minimum_clearance"], "m"), number(row["lap_time"], "s")
    ratio = number(row["of_reference"])
    return row["case"], row["verdict"], near, lap, ratio, row["reason"]


def _shown(clearance):
    return math.inf if clearance is None else round(clearance, 3)
