"""When the race takes a step: all the time, or once a period of lockstep."""

import sys
import types

import pytest
from f1tenth_race_mgr.pacing import POLL_PERIOD, TIMEOUT, ClockPacing, LockstepPacing

from f1tenth_race_mgr import pacing


class Navigation:
    action_name = "/robot1/move_base"

    def __init__(self):
        self.answers = []  # to wait_for_server; then True
        self.timeouts = []
        self.gone = False

    def wait_for_server(self, timeout):
        self.timeouts.append(timeout)
        return self.answers.pop(0) if self.answers else True

    def is_server_gone(self):
        return self.gone


class Participant:
    """The stamps of a run (None: not yet), and what was said."""

    def __init__(self, name, after):
        self.name, self.after = name, after
        self.stamps = []
        self.said = []

    def wait_for_period(self, timeout):
        assert timeout == TIMEOUT
        return self.stamps.pop(0)

    def done(self, stamp):
        self.said.append(stamp)

    def leave(self):
        self.said.append("left")


class StartSignal:
    def __init__(self, *left):
        self._left = list(left)
        self.asked = 0

    def seconds_left(self):
        self.asked += 1
        return self._left.pop(0) if len(self._left) > 1 else self._left[0]


class Stop:
    race = False


@pytest.fixture(autouse=True)
def _ros(monkeypatch):
    module = types.ModuleType("sim2d_lockstep")
    module.Participant = Participant
    monkeypatch.setitem(sys.modules, "sim2d_lockstep", module)
    monkeypatch.setattr(pacing.rospy, "get_name", lambda: "/robot1/race_mgr")
    monkeypatch.setattr(pacing.rospy, "get_rostime", lambda: "now")


def lockstep(navigation=None, start_signal=None, stop=None, stamps=()):
    made = LockstepPacing(navigation or Navigation(), start_signal, stop or Stop())
    made._participant.stamps = list(stamps)
    return made


def test_without_lockstep_there_is_a_step_at_each_look_at_the_clock(monkeypatch):
    slept = []
    monkeypatch.setattr(pacing.time, "sleep", slept.append)
    navigation = Navigation()
    paced = ClockPacing(navigation, None, None)
    assert paced.wait() == "now"
    assert slept == [POLL_PERIOD]
    assert navigation.timeouts == [0.0]
    assert (paced.done("now"), paced.leave()) == (None, None)


def test_participant_acts_after_the_planner_and_the_starter_if_there_is_one():
    alone, started = lockstep(), lockstep(start_signal=StartSignal(3))
    assert alone._participant.name == "robot1/race_mgr"
    assert alone._participant.after == ["robot1/move_base"]
    assert started._participant.after == ["robot1/move_base", "race_starter"]


def test_each_period_is_a_step_and_is_answered():
    paced = lockstep(stamps=[1, 2])
    assert [paced.wait(), paced.wait()] == [1, 2]
    paced.done(2)
    paced.leave()
    assert paced._participant.said == [2, "left"]


def test_while_there_is_no_period_there_is_no_step_unless_the_planner_has_gone():
    navigation = Navigation()
    paced = lockstep(navigation, stamps=[None, 1, None, None])
    assert [paced.wait(), paced.wait(), paced.wait()] == [None, 1, None]
    navigation.gone = True
    assert paced.wait() == 1


def test_first_step_waits_for_planner_and_starter_in_wall_time():
    navigation = Navigation()
    navigation.answers = [False, False]
    starter = StartSignal(None, None, 2)
    paced = lockstep(navigation, starter, stamps=[1, 2])
    assert paced.wait() == 1
    assert starter.asked == 3
    # The planner is asked with patience until it is there, then remembered, while the starter is waited for.
    assert navigation.timeouts == [TIMEOUT] * 3
    assert paced.wait() == 2


def test_stop_ends_the_wait_for_a_planner():
    stop = Stop()

    class Never(Navigation):
        def wait_for_server(self, timeout):
            stop.race = True
            return False

    paced = lockstep(Never(), stop=stop, stamps=[1, 2])
    assert paced.wait() is None
    stop.race = False
    assert paced.wait() is None
