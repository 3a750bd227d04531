"""The real-time factor leaves out how long it took to start."""

from f1tenth_judge.record.pace import Pace


def test_starting_up_does_not_count():
    pace = Pace()
    for simulated, wall in ((None, 0.0), (0.025, 8.0), (10.025, 9.0), (20.025, 10.0)):
        pace.note(simulated, wall)
    assert pace.factor == 10.0


def test_standing_still_at_the_end_does_not_count():
    pace = Pace()
    for simulated, wall in ((0.0, 0.0), (4.0, 1.0), (4.0, 9.0)):
        pace.note(simulated, wall)
    assert pace.factor == 4.0


def test_one_moment_is_not_enough():
    pace = Pace()
    assert pace.factor is None
    pace.note(1.0, 1.0)
    assert pace.factor is None


def test_time_stands_since_it_last_went_on():
    pace = Pace()
    assert pace.standing(3.0) == 3.0
    for simulated, wall in ((None, 4.0), (1.0, 5.0), (2.0, 6.0), (2.0, 9.0)):
        pace.note(simulated, wall)
    assert pace.standing(9.5) == 3.5
