"""The laps beside the reference, as a table."""

import dataclasses
from collections.abc import Sequence

from f1tenth_scenarios.studies.race_pace.laps import Laps
from f1tenth_scenarios.studies.race_pace.limits import Limits

GREATEST_RATIO = 1.35
LEAST_CLEARANCE = 0.05  # m

_HEAD = """# Race pace

Flying laps of the planner beside the fastest lap that the car could drive, made by

    rosrun f1tenth_scenarios race_pace --table docs/race_pace.md

Reference: the line of least curvature and the fastest speed along it, by trajectory-planning-helpers, under
the limits of the simulator's car: {limits}.
It knows the whole circuit, needs no time to turn the wheels and passes no goals. The planner gets one goal
after the other with perfect odometry and has to pass each within the tolerance of the scenarios.

Wanted: every flying lap within {ratio} times the reference, no contact, at least {clearance:g} m of
clearance.

{columns}
"""
_COLUMNS = (
    "circuit",
    "reference (s)",
    "flying laps",
    "best (s)",
    "slowest (s)",
    "slowest / reference",
    "least clearance (m)",
    "contacts",
)


@dataclasses.dataclass(frozen=True)
class Comparison:
    """Laps of a circuit and the reference lap, s."""

    laps: Laps
    reference: float

    @property
    def ratio(self) -> float:
        """The slowest flying lap over the reference; infinite without one."""
        return max(self.laps.flying, default=float("inf")) / self.reference

    def problem(self, wanted_laps: int) -> str:
        """Why the laps are not good enough; empty when they are."""
        laps = self.laps
        if not laps.success or len(laps.flying) < wanted_laps:
            return f"{laps.circuit}: {len(laps.flying)} of {wanted_laps} flying laps: {laps.reason}"
        if laps.contacts:
            return f"{laps.circuit}: {laps.contacts} contacts, must be none"
        if self.ratio > GREATEST_RATIO:
            return f"{laps.circuit}: {self.ratio:.3f} times the reference, must be at most {GREATEST_RATIO}"
        if laps.clearance < LEAST_CLEARANCE:
            return f"{laps.circuit}: clearance {laps.clearance:.3f} m, must be at least {LEAST_CLEARANCE} m"
        return ""


def make_table(comparisons: Sequence[Comparison], limits: Limits) -> str:
    """The whole document, in Markdown."""
    head = _HEAD.format(
        limits=limits.describe(),
        ratio=GREATEST_RATIO,
        clearance=LEAST_CLEARANCE,
        columns=_line(_COLUMNS) + _line(["---"] * len(_COLUMNS)).rstrip(),
    )
    return head + "".join(map(_row, comparisons))


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |\n"


def _row(comparison: Comparison) -> str:
    laps = comparison.laps
    best, slowest = (f"{pick(laps.flying):.3f}" if laps.flying else "none" for pick in (min, max))
    cells = (
        laps.circuit,
        f"{comparison.reference:.3f}",
        str(len(laps.flying)),
        best,
        slowest,
        f"{comparison.ratio:.2f}",
        f"{laps.clearance:.3f}",
        str(laps.contacts),
    )
    return _line(cells)
