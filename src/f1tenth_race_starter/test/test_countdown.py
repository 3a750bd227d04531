"""The countdown, told the time by hand."""

from f1tenth_race_starter.countdown import SECOND, Countdown


def test_announces_each_second_once():
    countdown = Countdown(3)
    start = 7 * SECOND
    announced = [(t, countdown.update(start + t * SECOND // 40)) for t in range(200)]
    assert [(t, due) for t, due in announced if due] == [(0, [3]), (40, [2]), (80, [1]), (120, [0])]


def test_waits_for_a_valid_clock():
    countdown = Countdown(1)
    assert countdown.update(0) == []
    assert countdown.update(5) == [1]


def test_a_countdown_from_zero_starts_at_once():
    countdown = Countdown(0)
    assert countdown.update(SECOND) == [0]
    assert countdown.finished


def test_announces_what_a_leaping_clock_skipped():
    countdown = Countdown(5)
    countdown.update(SECOND)
    assert countdown.update(3 * SECOND + 1) == [4, 3]
    assert countdown.update(100 * SECOND) == [2, 1, 0]


def test_is_not_a_nanosecond_early():
    countdown = Countdown(1)
    countdown.update(1)
    assert countdown.update(SECOND) == []
    assert not countdown.finished
    assert countdown.update(SECOND + 1) == [0]
    assert countdown.finished


def test_begins_anew_when_the_clock_goes_back():
    countdown = Countdown(2)
    countdown.update(10 * SECOND)
    countdown.update(11 * SECOND)
    assert countdown.update(SECOND) == [2]
    assert countdown.update(2 * SECOND) == [1]


def test_begins_anew_also_from_behind_its_start():
    countdown = Countdown(5)
    countdown.update(SECOND)
    countdown.update(4 * SECOND)
    assert countdown.update(2 * SECOND) == [5]
    assert countdown.update(3 * SECOND) == [4]


def test_says_nothing_after_the_start():
    countdown = Countdown(0)
    countdown.update(10 * SECOND)
    assert countdown.update(11 * SECOND) == []
    assert countdown.update(SECOND) == []


def test_clock_that_stands_repeats_nothing():
    countdown = Countdown(2)
    assert countdown.update(10 * SECOND) == [2]
    assert countdown.update(10 * SECOND) == []
    assert countdown.update(11 * SECOND) == [1]
