"""Laps on which another car is met, each with a seed of its own."""

import dataclasses
import random
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from f1tenth_judge.places import lookup
from f1tenth_judge.places.course import Course

from f1tenth_studies.made_places import seeds, track_map, track_names, write_place
from f1tenth_studies.optimum.track import load_track
from f1tenth_studies.study import Column, Run, Study, place_of

LEAST_CLEARANCE = 0.08  # m
_KEY = "encounter"
_ROWS = ("seed", "place", "manner", "speed (m/s)")  # in their order in the name of a place
_MANNERS = ("middle", "side", "weaves", "brakes", "stands")
_SLOW, _FAST = 0.5, 4.0  # m/s
_FURNISHED = "circuit_detailed"
_WEAVE, _WEAVE_RATE = 0.3, 0.5  # m, Hz
_MOST_ASIDE = 0.6  # m
_BRAKES_AFTER = (10.0, 30.0)  # m
_BLEND = 3.0  # m, over which the other gets from the middle to its line
_AHEAD = 6.0  # m, where it stands at the start, between two goals: `ahead` of robot2 in the scenario


_TEXT = f"""\
A lap that begins anywhere on a circuit or a track. Another car, {_AHEAD:g} m ahead at the start, drives at
{_SLOW:g} to {_FAST:g} m/s along its own line and ignores the planner's car: it keeps to the `middle` of the
road or to one `side`, `weaves` ({_WEAVE:g} m, {_WEAVE_RATE:g} Hz), drives and then `brakes` for good, or
`stands` from the start. On {_FURNISHED} it always stands, and laps begin at the start line: goals
elsewhere, and cars that follow the line there, touch the furniture. The planner has perfect odometry, and
knows from its lidar alone where the other car is and how fast it drives.

Wanted: nothing is touched, and a clearance of at least {LEAST_CLEARANCE:g} m."""


@dataclasses.dataclass(frozen=True)
class Encounter:
    """What one seed gives."""

    place: str  # circuit or track
    begin: float  # part of the road at which the lap begins
    manner: str
    speed: float  # m/s
    aside: float  # m, to the left
    brakes_after: float  # m


def make_encounter(seed: int) -> Encounter:
    """The encounter of a seed.

    Raises:
        ScenarioError: it is on a track, and there are none.
    """
    generator = random.Random(seed)
    place = generator.choice(lookup.circuits() if seed % 2 else track_names())
    encounter = Encounter(
        place=place,
        begin=generator.random(),
        manner=generator.choice(_MANNERS),
        speed=generator.uniform(_SLOW, _FAST),
        aside=generator.choice((-1.0, 1.0)) * generator.uniform(0.2, _MOST_ASIDE),
        brakes_after=generator.uniform(*_BRAKES_AFTER),
    )
    return dataclasses.replace(encounter, begin=0.0, manner="stands") if place == _FURNISHED else encounter


def line_of(encounter: Encounter, course: Course) -> np.ndarray:
    """Where the other drives, from the beginning of the road on: x, y (m), speed (m/s), shape (n, 3)."""
    x, y = course.x, course.y
    step_x, step_y = np.gradient(x), np.gradient(y)
    lengths = np.hypot(step_x, step_y)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    aside = _aside(encounter, along) * np.clip((along - _AHEAD) / _BLEND, 0.0, 1.0)
    speed = np.full(len(x), 0.0 if encounter.manner == "stands" else encounter.speed)
    if encounter.manner == "brakes":
        speed[along > _AHEAD + encounter.brakes_after] = 0.0
    return np.column_stack([x - aside * step_y / lengths, y + aside * step_x / lengths, speed])


def _aside(encounter: Encounter, along: np.ndarray) -> np.ndarray:
    if encounter.manner == "weaves":
        return _WEAVE * np.sin(2.0 * np.pi * _WEAVE_RATE * along / encounter.speed)
    return np.full(len(along), encounter.aside if encounter.manner == "side" else 0.0)


def _worlds(values: str, folder: Path) -> list[Path]:
    return [_write(seed, make_encounter(seed), folder) for seed in seeds(_KEY, values)]


def _write(seed: int, encounter: Encounter, folder: Path) -> Path:
    road, map_file = _road_of(encounter.place)
    track = load_track(road)
    course = Course(*np.roll(track, -int(encounter.begin * len(track)), axis=0).T)
    stem = folder / f"{seed:03}_{encounter.place}_{encounter.manner}_{encounter.speed:.1f}"
    return write_place(stem, map_file, course, line_of(encounter, course))


def _road_of(place: str) -> tuple[str, Path]:
    """What load_track reads of a circuit or track, and its map."""
    if place in lookup.circuits():
        return place, lookup.package_path(lookup.GAZEBO_PACKAGE) / "maps" / f"{place}.yaml"
    return str(track_map(place)), track_map(place)


def _clearance(run: Run) -> float:
    return float(run.record.tracks["robot1"].clearance.min())


def _contacts(runs) -> int:
    """Those of the planner's car; the other may touch a wall by itself."""
    touched = [(each["car"], *each["touched"]) for run in runs for each in run.result["contacts"]]
    return sum("robot1" in names for names in touched)


def _labels(values: Mapping[str, str]) -> dict[str, str]:
    seed, *place, manner, speed = place_of(values).split("_")
    return dict(zip(_ROWS, (seed, "_".join(place), manner, speed)))


def _defect(run: Run) -> str:
    if _clearance(run) < LEAST_CLEARANCE:
        return f"clearance {_clearance(run):.3f} m, must be at least {LEAST_CLEARANCE:g} m"
    return ""


STUDY = Study(
    title="Meeting others",
    text=_TEXT,
    scenario="encounters",
    vary={_KEY: "0:59"},
    rows=_ROWS,
    columns=(
        Column("verdict", lambda runs: runs[0].result["verdict"]),
        Column("finish (s)", lambda runs: float(runs[0].result["times"]["finish"] or "inf")),
        Column("least clearance (m)", lambda runs: _clearance(runs[0])),
        Column("contacts", _contacts),
    ),
    defect=_defect,
    places=(_KEY, _worlds),
    labels=_labels,
)
