"""Laps of others' tracks, in both directions."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from f1tenth_judge.places.course import Course, read_course
from f1tenth_judge.scenario.settings import Setting
from f1tenth_judge.suites.made_places import track_map, track_names, write_place
from f1tenth_judge.suites.suite import Suite, with_models


def backwards(course: Course) -> Course:
    """The same road in the other direction, from the same start."""
    x, y, right, left = (np.roll(each[::-1], 1) for each in (course.x, course.y, course.right, course.left))
    return Course(x, y, left, right)


def _there_and_back(name: str, folder: Path) -> dict[str, Path]:
    map_file = track_map(name)
    course = read_course(map_file.with_name(f"{name}_centerline.csv"))
    return {
        name: write_place(folder / name, map_file, course),
        f"{name}_reverse": write_place(folder / f"{name}_reverse", map_file, backwards(course)),
    }


def _cases(chosen: str, folder: Path) -> Mapping[str, tuple[Setting, ...]]:
    names = chosen.split(",") if chosen else track_names()
    places = {each: world for name in names for each, world in _there_and_back(name, folder).items()}
    return {name: (*settings, Setting("laps", "3")) for name, settings in with_models(places).items()}


SUITE = Suite(
    text="three laps of a track of $F1TENTH_DATA, there and back; both vehicle models; --cases are names",
    scenario="unseen_road",
    cases=_cases,
)
