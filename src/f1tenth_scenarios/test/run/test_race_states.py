"""The judge, which knows no ROS, means by a state of a race what race_mgr's message means by its number."""

from f1tenth_judge.record.observations import RaceState
from f1tenth_race_mgr.state import State


def test_states_have_the_names_and_numbers_of_the_message():
    assert {each.name: each.value for each in RaceState} == {each.name: each.value for each in State}
