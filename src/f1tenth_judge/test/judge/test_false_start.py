"""Who left its place before the race began, at the limit in time and place."""

import pytest
from f1tenth_judge.judge.false_start import FirstMoves, find_false_start
from scenario_samples import TASKS, racing, scenario


def moves(*taken):
    found = FirstMoves()
    for each in taken:
        found.take(*each)
    return found


def test_each_car_moves_from_its_own_place():
    places = [(0.0, "one", 0.0, 0.0), (0.0, "two", 3.0, 0.0), (1.0, "one", 0.0, 0.0), (2.0, "two", 3.1, 0.0)]
    assert moves(*places).stamps == {"two": 2.0}


def test_a_car_may_creep_as_far_as_the_limit():
    assert moves((0.0, "one", 0.0, 0.0), (1.0, "one", 0.05, 0.0)).stamps == {}
    assert moves((0.0, "one", 0.0, 0.0), (1.0, "one", 0.0501, 0.0)).stamps == {"one": 1.0}


@pytest.mark.parametrize(("stamp", "is_false"), [(1.975, True), (2.0, False), (2.025, False)])
def test_a_car_may_move_when_the_race_begins(stamp, is_false):
    first = moves((0.0, "robot1", 0.0, 0.0), (stamp, "robot1", 1.0, 0.0))
    assert bool(find_false_start(scenario(time_to_start=2), TASKS, first, [])) == is_false
    assert bool(find_false_start(scenario(time_to_start=0), TASKS, first, [racing(2.0)])) == is_false
