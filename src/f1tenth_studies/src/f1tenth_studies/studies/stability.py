"""Whether the car keeps to its planner's limits, with slow actuators and on slippery floors."""

import functools
from collections.abc import Callable
from pathlib import Path

import numpy as np
from f1tenth_scenarios.judge.driving_criteria import lateral, longitudinal
from f1tenth_scenarios.record.record import CarTrack
from scipy.spatial import cKDTree

from f1tenth_studies.made_places import track_map
from f1tenth_studies.optimum.track import load_track
from f1tenth_studies.parameters import read_planner_limits
from f1tenth_studies.study import CLEARANCE, CONTACTS, Column, Run, Study, failed_places

_LIMITS = read_planner_limits()
LATERAL_LIMIT = _LIMITS["max_lateral_acceleration"]  # m/s^2
LONGITUDINAL_LIMIT = _LIMITS["acc_lim_x"]  # m/s^2
GREATEST_SPEED = _LIMITS["max_vel_x"]  # m/s
EXCESS = 1.1  # times either limit, at most
MOST_CHANGES = 1.0  # of the yaw rate's sign, 1/s
_CIRCUITS = ("circuit1", "circuit4")
_TRACKS = ("Oschersleben", "Spa")
_CHORD = 1.0  # m, to either side, over which the road's curvature is measured
_MARGIN = 2.0  # m, before and behind a point of a straight, within which the road is straight, too
_STRAIGHT = 0.05  # 1/m
_STILL = 0.05  # rad/s, below which a yaw rate has no sign


_TEXT = f"""\
A lap from the standing start on {", ".join(_CIRCUITS)} and the tracks {" and ".join(_TRACKS)}, with default
settings and perfect odometry, at most at 5 and at {GREATEST_SPEED:g} m/s, with both vehicle models: with the
usual friction of the floor and less (mu), and with shorter and longer delays of the actuators
(actuation_latency, s; 0.02 is usual). The planner is told neither.

Accelerations (m/s^2) are those of base_footprint, the greatest in any period of 25 ms. Changes are sign
changes of the yaw rate where the road is straight, per second; rates below {_STILL:g} rad/s do not count.

Wanted: no contact; to the side at most {EXCESS:g} times `max_lateral_acceleration` ({LATERAL_LIMIT:g}) and
along the car {EXCESS:g} times `acc_lim_x` ({LONGITUDINAL_LIMIT:g}); less than {MOST_CHANGES:g} change per
second."""


def greatest(acceleration, run: Run) -> float:
    """The greatest magnitude of an acceleration of the planner's car, m/s^2."""
    return float(np.abs(acceleration(run.record.tracks["robot1"])).max())


def changes_of_sign(track: CarTrack, road: np.ndarray) -> float:
    """How often the yaw rate changes its sign where the road, as of load_track, is straight, 1/s."""
    _, nearest = cKDTree(road[:, :2]).query(np.column_stack([track.x, track.y]))
    on_straight = _straight(road)[nearest]
    time = float(np.diff(track.time)[on_straight[1:]].sum())
    # The first sign on a straight does not count as a change.
    stretches = np.split(np.arange(len(on_straight)), np.flatnonzero(np.diff(on_straight)) + 1)
    changes = sum(_changes(track.yaw_rate[each]) for each in stretches if on_straight[each[0]])
    return changes / time if time > 0.0 else 0.0


def _changes(rates: np.ndarray) -> int:
    signs = np.sign(rates[np.abs(rates) > _STILL])
    return int(np.count_nonzero(np.diff(signs)))


def _straight(road: np.ndarray) -> np.ndarray:
    """Which points of a road lie on a straight."""
    spacing = float(np.median(np.hypot(*np.diff(road[:, :2], axis=0).T)))
    chord, margin = (max(1, round(length / spacing)) for length in (_CHORD, _MARGIN))
    ahead = np.roll(road[:, :2], -chord, axis=0) - road[:, :2]
    behind = np.roll(ahead, chord, axis=0)
    turn = np.arctan2(ahead[:, 1], ahead[:, 0]) - np.arctan2(behind[:, 1], behind[:, 0])
    bend = np.abs(np.remainder(turn + np.pi, 2.0 * np.pi) - np.pi) / (chord * spacing)
    around = [np.roll(bend, shift) for shift in range(-margin, margin + 1)]
    return np.max(around, axis=0) < _STRAIGHT


@functools.cache
def _road(world: str) -> np.ndarray:
    return load_track(world)


def _weaving(run: Run) -> float:
    return changes_of_sign(run.record.tracks["robot1"], _road(run.values["world"]))


def _worst(measure: Callable[[Run], float]) -> Callable:
    return lambda runs: max(measure(run) for run in runs)


def _defect(run: Run) -> str:
    for name, actual, limit in (
        ("to the side", greatest(lateral, run), EXCESS * LATERAL_LIMIT),
        ("along the car", greatest(longitudinal, run), EXCESS * LONGITUDINAL_LIMIT),
    ):
        if actual > limit:
            return f"{actual:.2f} m/s^2 {name}, must be at most {limit:.2f}"
    changes = _weaving(run)
    if changes >= MOST_CHANGES:
        return f"{changes:.2f} changes per second, must be less than {MOST_CHANGES:g}"
    return ""


def _worlds(values: str, _: Path) -> list[str]:
    """The circuits and the tracks, unless worlds are given."""
    return [values] if values else [*_CIRCUITS, *(str(track_map(track)) for track in _TRACKS)]


STUDY = Study(
    title="Stability",
    text=_TEXT,
    scenario="unseen_road",
    vary={
        "world": "",
        "model": "single_track,single_track_drift",
        "mu": "0.5,0.75,1.05",
        "actuation_latency": "0,0.1",
        "speed_max": f"5,{GREATEST_SPEED:g}",
    },
    rows=("model", "mu", "actuation_latency"),
    columns=(
        Column("laps", lambda runs: sum(len(run.lap_times) for run in runs)),
        Column("failed", failed_places),
        Column("to the side", _worst(lambda run: greatest(lateral, run)), digits=2),
        Column("along", _worst(lambda run: greatest(longitudinal, run)), digits=2),
        Column("changes (1/s)", _worst(_weaving), digits=2),
        CLEARANCE,
        CONTACTS,
    ),
    defect=_defect,
    places=("world", _worlds),
)
