"""Laps past a slower car."""

import numpy as np
from f1tenth_scenarios.places import circuits
from f1tenth_scenarios.record.record import CarTrack
from f1tenth_scenarios.report.gaps import way_along
from f1tenth_scenarios.road.course import Course

from f1tenth_studies.optimum.track import load_track
from f1tenth_studies.study import CONTACTS, Column, Run, Study, slowest

# A car that drives no faster than this is clearly slower, and must be passed; m/s.
CLEARLY_SLOWER = 1.5
_OTHERS_SPEED = "cars.robot2.speed_max"


_TEXT = f"""\
Laps at race pace on a road on which another car keeps to the middle at its own speed (speed_max, m/s) and
ignores the planner's car. The planner has perfect odometry, and knows from its lidar alone where the other
car is and how fast it drives. The other car stands 2.5 m ahead at the start; a fast car meets it again in
each lap.

Wanted: no contact, and a car of up to {CLEARLY_SLOWER:g} m/s is passed."""


def count_passes(track: np.ndarray, behind: CarTrack, ahead: CarTrack) -> int:
    """How often the car that starts behind gets past the one ahead, the second and further laps included.

    `track` as of load_track.
    """
    periods = min(len(behind.x), len(ahead.x))
    total = Course(*track.T).length
    own, other = (way_along(each, track[:, :2])[:periods] for each in (behind, ahead))
    lead = own - other
    # The course may be described in the other direction.
    lead *= 1.0 if own[-1] >= own[0] else -1.0
    # At the start the car ahead may be on either side of where the course begins.
    lead -= total * np.ceil(lead[0] / total)
    return int(np.floor(lead.max() / total)) + 1


def _passes(runs) -> int:
    (run,) = runs
    tracks = run.record.tracks
    return count_passes(load_track(run.values["world"]), tracks["robot1"], tracks["robot2"])


def _defect(run: Run) -> str:
    missed = float(run.values[_OTHERS_SPEED]) <= CLEARLY_SLOWER and not _passes([run])
    return "the slower car was not passed" if missed else ""


STUDY = Study(
    title="Passing a slower car",
    text=_TEXT,
    scenario="passing",
    vary={"world": ",".join(circuits()), _OTHERS_SPEED: "0.6,1,1.25,1.5,2,2.5,3"},
    rows=("world", _OTHERS_SPEED),
    columns=(
        Column("laps", lambda runs: len(runs[0].lap_times)),
        Column("slowest lap (s)", slowest),
        Column("passed (times)", _passes),
        Column("least clearance (m)", lambda runs: float(runs[0].record.tracks["robot1"].clearance.min())),
        CONTACTS,
    ),
    defect=_defect,
)
