"""The goals of a car, as race_mgr reads them."""

from pathlib import Path

import f1tenth_navigation_mgr
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.scenario.scenario import Pose


def read_goals(path: Path) -> list[Pose]:
    """Read a goals file.

    Raises:
        ScenarioError: with the file, the line and what is wrong there.
    """
    try:
        goals = f1tenth_navigation_mgr.load_goals_file(str(path))
    except f1tenth_navigation_mgr.GoalsFileError as error:
        raise ScenarioError(str(error)) from error
    return [Pose(goal.x, goal.y, goal.yaw) for goal in goals]
