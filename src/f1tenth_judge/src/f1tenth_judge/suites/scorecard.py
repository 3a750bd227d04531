"""What came out of a suite: its worst cases."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

_SHOWN = 10  # cases


def worst_first(rows: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """Cases that failed before those that passed, and then by clearance."""
    return sorted(rows, key=lambda row: (row["passed"], _or_infinite(row["minimum_clearance"]), row["case"]))


def scorecard(rows: Sequence[Mapping[str, Any]]) -> str:
    """All cases that failed, or the worst of those that passed, a line each."""
    worst = worst_first(rows)
    shown = max(_SHOWN, sum(not row["passed"] for row in rows))
    lines = [f"{'case':32}{'verdict':12}{'clearance':>11}{'best lap':>11}  reason"]
    lines += [_line(row) for row in worst[:shown]]
    return "\n".join(lines)


def _line(row: Mapping[str, Any]) -> str:
    clearance, lap = (_with_unit(row[key], unit) for key, unit in _MEASURED.items())
    return f"{row['case']:32}{row['verdict']:12}{clearance:>11}{lap:>11}  {row['reason']}"


_MEASURED = {"minimum_clearance": "m", "lap_time": "s"}


def _with_unit(value, unit):
    return "none" if value is None else f"{value:.3f} {unit}"


def _or_infinite(value):
    return math.inf if value is None else value
