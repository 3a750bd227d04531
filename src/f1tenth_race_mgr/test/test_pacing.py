"""When the race takes a step; lockstep_test.py plays the periods."""

import sys
import types

import pytest
from f1tenth_race_mgr.pacing import POLL_PERIOD, TIMEOUT, ClockPacing, LockstepPacing

from f1tenth_race_mgr import pacing


class Navigation:
    action_name = "/robot1/move_base"

    def __init__(self):
        self.timeouts = []

    def wait_for_server(self, timeout):
        self.timeouts.append(timeout)
        return True

    def is_server_gone(self):
        return False


class Participant:
    def __init__(self, name, after):
        self.name, self.after = name, after
        self.stamps = []

    def wait_for_period(self, timeout):
        assert timeout == TIMEOUT
        return self.stamps.pop(0)


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
    alone, started = lockstep(), lockstep(start_signal=object())
    assert alone._participant.name == "robot1/race_mgr"
    assert alone._participant.after == ["robot1/move_base"]
    assert started._participant.after == ["robot1/move_base", "race_starter"]


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
