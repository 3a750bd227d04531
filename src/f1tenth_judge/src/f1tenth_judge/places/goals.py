"""The goals of a car, as goals files have them."""

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places.course import Course
from f1tenth_judge.places.numbers import read_lines, read_number
from f1tenth_judge.scenario.car import TURN, Pose

_SPACING = 4.0  # m, between goals along a road
_FRAME = "frame_id:"
_KNOWN_FRAMES = ("map",)
_NAMES = {3: ("x", "y", "yaw"), 7: ("x", "y", "z", "qx", "qy", "qz", "qw")}
_FORMS = " or ".join(f'"{" ".join(names)}"' for names in _NAMES.values())
_QUATERNION_TOLERANCE = 0.01  # files written with two decimals are off by at most this much


def goals_along(course: Course) -> tuple[Pose, ...]:
    """Goals all around a road, on its middle; the last one where the course begins."""
    length = course.along()[-1]
    count = max(round(length / _SPACING), 3)
    places = np.linspace(0.0, length, count + 1)[1:]
    return tuple(Pose(*map(float, goal)) for goal in zip(*course.poses_at(places)))


def goals_text(goals: Sequence[Pose]) -> str:
    """Goals as a goals file has them."""
    return "frame_id: map\n" + "".join(f"{each.x!r} {each.y!r} {each.yaw!r}\n" for each in goals)


def read_goals(path: Path) -> list[Pose]:
    """Read a goals file.

    Raises:
        ScenarioError: with the file, the line and what is wrong there.
    """
    entries = [(place, text.split()) for place, text in read_lines(path)]
    if entries and entries[0][1][0] == _FRAME:
        _check_frame(*entries.pop(0))
    goals = [_goal(place, fields) for place, fields in entries]
    if not goals:
        raise ScenarioError(f"{path}: no goals in the file; expected lines of {_FORMS}")
    return goals


def _check_frame(place: str, fields: list[str]) -> None:
    frame = " ".join(fields[1:])
    if frame not in _KNOWN_FRAMES:
        raise ScenarioError(f'{place}: unknown frame "{frame}", expected one of: {", ".join(_KNOWN_FRAMES)}')


def _goal(place: str, fields: list[str]) -> Pose:
    if fields[0] == _FRAME:
        raise ScenarioError(f"{place}: frame_id must stand before everything else, and once")
    if len(fields) not in _NAMES:
        wrong = "too few" if len(fields) < 3 else "too many" if len(fields) > 7 else "wrong count of"
        raise ScenarioError(f"{place}: {wrong} numbers: {len(fields)}, expected 3 or 7: {_FORMS}")
    numbers = [read_number(place, *each) for each in zip(_NAMES[len(fields)], fields)]
    if len(numbers) == 3:
        if abs(numbers[2]) > TURN:
            raise ScenarioError(f"{place}: yaw is {numbers[2]:g}, must be in rad, at most a turn ({TURN:g})")
        return Pose(*numbers)
    x, y, _, qx, qy, qz, qw = numbers
    length = math.sqrt(qx * qx + qy * qy + qz * qz + qw * qw)
    if abs(length - 1.0) > _QUATERNION_TOLERANCE:
        raise ScenarioError(
            f"{place}: qx qy qz qw is not a unit quaternion: its length is {length:g}, expected 1 within "
            f"{_QUATERNION_TOLERANCE}"
        )
    return Pose(x, y, yaw_of(qx, qy, qz, qw))


def yaw_of(x: float, y: float, z: float, w: float) -> float:
    """The heading that a unit quaternion means in the plane, rad."""
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
