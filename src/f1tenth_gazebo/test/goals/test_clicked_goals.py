"""Clicks become goals, or take one away; what cannot be reached is named."""

import dataclasses

import pytest
from f1tenth_gazebo.goals.clicked_goals import ClickedGoals
from nav_msgs.msg import OccupancyGrid


@dataclasses.dataclass
class Place:
    x: float
    y: float


def grid():
    """20 x 10 cells of 0.1 m from (-1, 0): free, a wall from x = 0 to 0.1 m, the last column unknown."""
    message = OccupancyGrid()
    message.info.resolution, message.info.width, message.info.height = 0.1, 20, 10
    message.info.origin.position.x = -1.0
    cells = [0] * 200
    for row in range(10):
        cells[20 * row + 10] = 100
        cells[20 * row + 19] = -1
    message.data = cells
    return message


def places(goals):
    return [(goal.x, goal.y) for goal in goals.poses]


def test_clicks_are_appended_to_what_is_there():
    goals = ClickedGoals([Place(0.0, 0.0)])
    assert goals.take(Place(1.0, 0.0))
    assert goals.take(Place(2.0, 0.0))
    assert places(goals) == [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)]


def test_click_on_a_goal_takes_it_away_and_the_others_move_up():
    goals = ClickedGoals([Place(0.0, 0.0), Place(1.0, 0.0), Place(2.0, 0.0)])
    assert not goals.take(Place(1.2, 0.1))
    assert places(goals) == [(0.0, 0.0), (2.0, 0.0)]
    assert goals.take(Place(1.2, 0.1))
    assert places(goals)[-1] == (1.2, 0.1)


@pytest.mark.parametrize(
    ("x", "y", "problem"),
    [
        (-0.5, 0.5, ""),
        (0.05, 0.5, "in a wall"),
        (-0.15, 0.5, "in a wall"),
        (-0.25, 0.5, ""),
        (0.29, 0.5, "in a wall"),
        (0.95, 0.5, "where the map is unknown"),
        (1.05, 0.5, "not on the map"),
        (-1.05, 0.5, "not on the map"),
        (0.5, 1.05, "not on the map"),
        (0.5, -0.05, "not on the map"),
    ],
)
def test_goal_that_cannot_be_reached_is_named(x, y, problem):
    goals = ClickedGoals([Place(-0.5, 0.5), Place(x, y)])
    goals.take_map(grid())
    assert goals.problems() == ({2: problem} if problem else {})


def test_without_a_map_nothing_is_wrong():
    assert ClickedGoals([Place(0.0, 0.5)]).problems() == {}
