"""Laps past a slower car."""

import numpy as np
from f1tenth_scenarios.record.record import CarTrack

from f1tenth_studies.optimum.track import circuits, load_track
from f1tenth_studies.study import CONTACTS, Column, Run, Study, slowest

# A car that drives no faster than this is clearly slower, and must be passed; m/s.
CLEARLY_SLOWER = 1.5
_OTHERS_SPEED = "cars.robot2.speed_max"


_TEXT = f"""\
Laps at race pace on a road on which another car keeps to the middle at a speed of its own (m/s) and takes no
notice. The planner has perfect odometry, and knows from its lidar alone where the other is and how fast. The
other stands 2.5 m ahead of it at the start; a fast car meets it again in each lap.

Wanted: no contact, and a car of up to {CLEARLY_SLOWER:g} m/s is passed."""


def count_passes(track: np.ndarray, behind: CarTrack, ahead: CarTrack) -> int:
    """How often the car that starts behind gets past the one ahead, the second and further laps included.

    `track` as of load_track.
    """
    periods = min(len(behind.x), len(ahead.x))
    total = _lengths(track)[-1]
    own = _progress(track, behind.x[:periods], behind.y[:periods])
    lead = own - _progress(track, ahead.x[:periods], ahead.y[:periods])
    # The course may be described in the other direction.
    lead *= 1.0 if own[-1] >= own[0] else -1.0
    # At the start the one ahead may be on either side of where the course begins.
    lead -= total * np.ceil(lead[0] / total)
    return int(np.floor(lead.max() / total)) + 1


def _progress(track: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Way along the track, m, that goes on from lap to lap."""
    lengths = _lengths(track)
    nearest = [int(np.argmin(np.hypot(track[:, 0] - px, track[:, 1] - py))) for px, py in zip(x, y)]
    return np.unwrap(lengths[nearest], period=lengths[-1])


def _lengths(track: np.ndarray) -> np.ndarray:
    """Of the track up to each point, and once around, m."""
    steps = np.hypot(*np.diff(track[:, :2], axis=0, append=track[:1, :2]).T)
    return np.concatenate([[0.0], np.cumsum(steps)])


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
