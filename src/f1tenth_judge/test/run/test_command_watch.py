"""A driver whose commands are none is noticed by what the simulator counts."""

import pytest
from f1tenth_judge.run.command_watch import CommandCount, CommandWatch

NAN = "speed is nan"


def problems(*counts, cars=("robot1",), done=(), load=0.0):
    """Of counts (stamp, accepted, refused) of robot1, with a silence of 10 s."""
    watch = CommandWatch(cars, 10.0, load)
    for stamp, accepted, refused in counts:
        watch.take(CommandCount(stamp, "robot1", accepted, refused, NAN if refused else ""))
    return [(each.car, each.text, each.stamp, each.is_mute) for each in watch.problems(set(done))]


def test_steady_driver_has_no_problem():
    assert problems(*((float(second), 40 * second, 0) for second in range(1, 60))) == []


def test_driver_that_never_speaks_is_silent():
    text = "has sent no command at all for 10 s of simulated time (limits.silence)"
    assert problems((9.0, 0, 0)) == []
    assert problems((9.0, 0, 0), (10.0, 0, 0)) == [("robot1", text, 10.0, True)]


def test_driver_may_load_before_it_speaks():
    text = "has sent no command at all for 30 s of simulated time (limits.load)"
    assert problems((29.0, 0, 0), load=30.0) == []
    assert problems((30.0, 0, 0), load=30.0) == [("robot1", text, 30.0, True)]
    assert problems((30.0, 0, 0), load=5.0)[0][1].endswith("(limits.silence)")
    text = "has sent no command for 10 s of simulated time (limits.silence), none since 25 s"
    assert problems((25.0, 5, 0), (35.0, 5, 0), load=30.0) == [("robot1", text, 35.0, False)]


def test_driver_that_falls_silent_is_noticed():
    assert problems((3.0, 120, 0), (12.0, 120, 0)) == []
    text = "has sent no command for 10 s of simulated time (limits.silence), none since 3 s"
    assert problems((3.0, 120, 0), (13.0, 120, 0)) == [("robot1", text, 13.0, False)]


def test_nonsense_is_noticed_when_it_goes_on():
    assert problems((1.0, 10, 30), (2.0, 50, 30)) == []
    assert problems((1.0, 0, 30), (2.0, 0, 70)) == [
        ("robot1", "sends only commands that the simulator refuses (at 2 s): speed is nan", 2.0, False)
    ]


@pytest.mark.parametrize(("count", "found"), [(400, 0), (401, 1)])
def test_flood_is_noticed(count, found):
    assert len(problems((1.0, 40, 0), (2.0, 40 + count, 0))) == found


def test_first_problem_is_the_one_that_is_told():
    ((_, text, stamp, _),) = problems((1.0, 5000, 0), (20.0, 5000, 0))
    assert (text, stamp) == ("sends 5000 commands per second of simulated time (at 1 s), may be 400", 1.0)


def test_who_is_done_or_not_watched_may_be_silent():
    assert problems((10.0, 0, 0), done=["robot1"]) == []
    assert problems((10.0, 0, 0), cars=["robot2"]) == []
