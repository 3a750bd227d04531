"""Flying laps compared with the theoretical optimum."""

import functools
from pathlib import Path

from f1tenth_judge.places.lookup import circuits

from f1tenth_studies.made_places import data_folder
from f1tenth_studies.optimum.car_limits import read_limits
from f1tenth_studies.optimum.fastest_lap import compute_fastest_lap
from f1tenth_studies.optimum.track import load_track
from f1tenth_studies.study import CLEARANCE, CONTACTS, Column, Run, Study

GREATEST_RATIO = 1.35
LEAST_CLEARANCE = 0.05  # m


_TEXT = f"""\
Flying laps of the planner compared with the theoretical optimum: the line of least curvature and the fastest
speed along it, by trajectory-planning-helpers, under the limits of the simulator's car:
{read_limits().describe()}.
The optimum knows the whole road, turns the wheels instantly and has no goals to pass. The planner gets one
goal after the other, has perfect odometry, and has to pass each goal within the tolerance of the scenarios.
Both vehicle models drive: `single_track`, whose tyres' forces grow with slip, and `single_track_drift`, whose
tyres slide.

Wanted: every flying lap within {GREATEST_RATIO} times the optimum, no contact, at least
{LEAST_CLEARANCE:g} m of clearance."""


def _flying(runs) -> list[float]:
    """Without the laps from the standing start."""
    return [time for run in runs for time in run.lap_times[1:]]


@functools.cache
def _optimum(world: str) -> float:
    return compute_fastest_lap(load_track(world), read_limits()).lap_time


def _ratio(runs) -> float:
    return max(_flying(runs), default=float("inf")) / _optimum(runs[0].values["world"])


def _defect(run: Run) -> str:
    if not _flying([run]):
        return "no flying lap"
    if _ratio([run]) > GREATEST_RATIO:
        return f"{_ratio([run]):.3f} times the optimum, must be at most {GREATEST_RATIO}"
    if run.clearance < LEAST_CLEARANCE:
        return f"clearance {run.clearance:.3f} m, must be at least {LEAST_CLEARANCE} m"
    return ""


def _worlds(values: str, _: Path) -> list[str]:
    """The circuits and others' tracks, unless worlds are given."""
    if values:
        return [values]
    return [*circuits(), *sorted(map(str, data_folder().glob("*/*_map.yaml")))]


STUDY = Study(
    title="Race pace",
    text=_TEXT,
    scenario="race_pace",
    vary={"world": "", "model": "single_track,single_track_drift"},
    rows=("place", "model"),
    columns=(
        Column("optimum (s)", lambda runs: _optimum(runs[0].values["world"])),
        Column("flying laps", lambda runs: len(_flying(runs))),
        Column("best (s)", lambda runs: min(_flying(runs), default=float("inf"))),
        Column("slowest (s)", lambda runs: max(_flying(runs), default=float("inf"))),
        Column("slowest / optimum", _ratio, digits=2),
        CLEARANCE,
        CONTACTS,
    ),
    defect=_defect,
    places=("world", _worlds),
)
