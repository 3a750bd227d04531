"""Laps on which another car is met, each with a seed of its own."""

import dataclasses
import random
from pathlib import Path

import numpy as np

from f1tenth_judge.places import lookup
from f1tenth_judge.places.course import Course
from f1tenth_judge.reference.track import load_track
from f1tenth_judge.scenario.settings import Setting
from f1tenth_judge.suites.made_places import track_map, track_names, write_place
from f1tenth_judge.suites.suite import Suite, seeds

_MANNERS = ("middle", "side", "weaves", "brakes", "stands")
_SLOW, _FAST = 0.5, 4.0  # m/s
_FURNISHED = "circuit_detailed"
_WEAVE, _WEAVE_RATE = 0.3, 0.5  # m, Hz
_MOST_ASIDE = 0.6  # m
_BRAKES_AFTER = (10.0, 30.0)  # m
_BLEND = 3.0  # m, over which the other gets from the middle to its line
_AHEAD = 6.0  # m, where it stands at the start, between two goals: `ahead` of robot2 in the scenario


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


def _cases(chosen: str, folder: Path) -> dict[str, tuple[Setting]]:
    made = {seed: make_encounter(seed) for seed in seeds(chosen)}
    return {
        f"{seed:03}_{each.place}_{each.manner}_{each.speed:.1f}": (
            Setting("world", str(_write(folder / f"{seed:03}", each))),
        )
        for seed, each in made.items()
    }


def _write(stem: Path, encounter: Encounter) -> Path:
    road, map_file = _road_of(encounter.place)
    track = load_track(road)
    course = Course(*np.roll(track, -int(encounter.begin * len(track)), axis=0).T)
    return write_place(stem, map_file, course, line_of(encounter, course))


def _road_of(place: str) -> tuple[str, Path]:
    """What load_track reads of a circuit or track, and its map."""
    if place in lookup.circuits():
        return place, lookup.package_path(lookup.GAZEBO_PACKAGE) / "maps" / f"{place}.yaml"
    return str(track_map(place)), track_map(place)


SUITE = Suite(
    text="a lap on which another car keeps to the middle or a side, weaves, brakes or stands; --cases are "
    "seeds: odd ones are on circuits, even ones on the tracks of $F1TENTH_DATA",
    scenario="encounters",
    cases=_cases,
    chosen="0:59",
)
