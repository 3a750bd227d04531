"""The goals of a car, as race_mgr reads them."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

import f1tenth_navigation_mgr
from f1tenth_scenarios.errors import as_scenario_error
from f1tenth_scenarios.road.course import Course
from f1tenth_scenarios.scenario.car import Pose

_SPACING = 4.0  # m, between goals along a road


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
    with as_scenario_error(f1tenth_navigation_mgr.GoalsFileError):
        goals = f1tenth_navigation_mgr.load_goals_file(str(path))
    return [Pose(goal.x, goal.y, goal.yaw) for goal in goals]
