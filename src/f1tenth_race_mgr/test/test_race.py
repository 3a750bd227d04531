"""The course of a race, with a navigation that does what it is told."""

from collections import namedtuple

import pytest
from f1tenth_race_mgr.race import Race
from f1tenth_race_mgr.state import State

from f1tenth_navigation_mgr import GoalOutcome as Outcome
from f1tenth_navigation_mgr import SpinResult as Did

Result = namedtuple("Result", "outcome text")


class Navigation:
    def __init__(self, goals_left, script):
        self.goals_left = goals_left
        self.results = []
        self.calls = []
        self._script = list(script)

    def spin(self, now):
        self.calls.append(("spin", now))
        step = self._script.pop(0)
        if isinstance(step, Result):
            self.results.append(step)
            return Did.FAILED
        return step

    def cancel(self):
        self.calls.append("cancel")

    def clear_goals(self):
        self.calls.append("clear_goals")


class Course:
    """A race and what it has published."""

    def __init__(self, goals, *script, started=True):
        self.started = started
        self.published = []
        self.navigation = Navigation(goals, script)
        self.race = Race(self.navigation, lambda: self.started, self._publish)

    def _publish(self, status, now):
        self.published.append((now, status.state.name, status.goals_reached, status.text))


def test_waits_for_the_start_signal():
    course = Course(2, Did.SENT, Did.DRIVING, started=False)
    course.race.announce(0)
    course.race.step(1)
    assert course.published == [(0, "WAITING", 0, "waiting for the start signal")]
    assert course.navigation.calls == []
    course.started = True
    course.race.step(2)
    assert course.published[1:] == [(2, "RACING", 0, "the race is on")]


def test_does_all_there_is_to_do_in_one_step():
    course = Course(2, Did.SENT, Did.DRIVING, Did.REACHED, Did.SENT, Did.DRIVING)
    course.race.step(1)
    course.race.step(2)
    assert [now for _, now in course.navigation.calls] == [1, 1, 2, 2, 2]
    assert course.published[-1] == (2, "RACING", 1, "1 goals reached of 2")


def test_takes_no_second_step_without_a_server():
    course = Course(1, Did.NOT_CONNECTED)
    course.race.step(1)
    assert course.race.status.state is State.RACING


@pytest.mark.parametrize("empty", [Did.QUEUE_EMPTY, Did.IDLE])
def test_finishes_when_the_queue_is_empty(empty):
    course = Course(1, Did.SENT, Did.REACHED, empty)
    course.race.step(1)
    assert course.published[-1] == (1, "FINISHED", 1, "finished, 1 goals reached of 1")
    assert course.race.is_over


def test_counts_laps():
    course = Course(2, *[Did.SENT, Did.REACHED] * 5, Did.SENT, Did.DRIVING)
    course.race.step(1)
    assert course.race.status.goals_reached == 5
    assert course.race.status.laps == 2


@pytest.mark.parametrize("outcome", [Outcome.ABORTED, Outcome.REJECTED, Outcome.PREEMPTED])
def test_a_goal_that_failed_aborts_with_the_planners_words(outcome):
    course = Course(3, Did.SENT, Did.REACHED, Did.SENT, Result(outcome, "No way."))
    course.race.step(1)
    assert course.published[-1] == (1, "ABORTED", 1, f"goal 2 of 3 {outcome.name.lower()}: No way.")
    assert course.race.is_over


def test_a_lost_planner_is_lost():
    course = Course(3, Did.SENT, Result(Outcome.LOST, "it has been gone for 2 s"))
    course.race.step(1)
    assert course.published[-1] == (1, "LOST", 0, "goal 1 of 3 lost: it has been gone for 2 s")


def test_counts_goals_from_one_in_every_lap():
    script = [Did.SENT, Did.REACHED] * 4
    course = Course(3, *script, Did.SENT, Result(Outcome.ABORTED, "No way."))
    course.race.step(1)
    assert course.race.status.text == "goal 2 of 3 aborted: No way."


def test_stopping_cancels_and_sends_no_more_goals():
    course = Course(3, Did.SENT, Did.DRIVING)
    course.race.step(1)
    course.race.stop(2)
    assert course.navigation.calls[-2:] == ["clear_goals", "cancel"]
    assert course.published[-1] == (2, "STOPPED", 0, "told to stop, 0 goals reached of 3")
    course.race.step(3)
    assert len(course.navigation.calls) == 4


def test_stopping_a_race_that_is_over_changes_nothing():
    course = Course(1, Did.SENT, Did.REACHED, Did.QUEUE_EMPTY)
    course.race.step(1)
    course.race.stop(2)
    assert course.race.status.state is State.FINISHED
