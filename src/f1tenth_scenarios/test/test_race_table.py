"""Standings of a race."""

import pytest
from f1tenth_scenarios.drivers.race_table import RaceTable
from f1tenth_scenarios.scenario.scenario import StartLine

# Around the line at the origin, crossed in the direction of x: a lap takes four places.
ROUND = [(1.0, 0.0), (1.0, 9.0), (-1.0, 9.0), (-1.0, 0.0)]


def race(laps=2, **speeds):
    """Cars that begin together and take so many seconds from place to place."""
    table = RaceTable(StartLine(), list(speeds), laps)
    times = {}
    for car, pause in speeds.items():
        for index in range(9):
            if table.take_place(car, index * pause, *ROUND[index % 4]):
                times.setdefault(car, []).append(index * pause)
    return table, times


def test_faster_car_leads():
    table, times = race(slow=2.0, fast=1.0)
    assert [each.car for each in table.standings()] == ["fast", "slow"]
    assert times == {"slow": [8.0, 16.0], "fast": [4.0, 8.0]}
    assert table.standings()[0].lap_times == (3.5, 4.0)


def test_race_is_over_when_all_have_finished():
    assert race(laps=2, one=1.0, two=2.0)[0].is_over
    assert not race(laps=3, one=1.0, two=2.0)[0].is_over


def test_laps_after_the_finish_do_not_count():
    table, times = race(laps=1, one=1.0)
    assert times == {"one": [4.0]}
    assert table.standings()[0].finished


def test_more_laps_count_more_than_an_early_crossing():
    table = RaceTable(StartLine(), ["one", "two"], 5)
    for index in range(9):
        table.take_place("one", float(index), *ROUND[index % 4])
    for index in range(5):
        table.take_place("two", 0.1 * index, *ROUND[index % 4])
    assert [each.car for each in table.standings()] == ["one", "two"]


def test_table_says_all():
    table, _ = race(fast=1.0, slow=2.0)
    table.take_contacts("slow", 3)
    assert [line.split() for line in table.text().splitlines()] == [
        ["car", "laps", "best", "lap", "total", "contacts"],
        ["1.", "fast", "2", "3.500", "s", "7.500", "s", "0"],
        ["2.", "slow", "2", "7.000", "s", "15.000", "s", "3"],
    ]


def test_car_without_a_lap_is_in_the_table_too():
    table = RaceTable(StartLine(), ["ghost"], 1)
    (ghost,) = table.standings()
    assert (ghost.lap_times, ghost.finish, ghost.finished) == ((), 0.0, False)
    assert table.text().splitlines()[1].split() == ["1.", "ghost", "0", "none", "0.000", "s", "0"]
    assert not table.is_over


@pytest.mark.parametrize("laps", [1, 2])
def test_lap_is_reported_in_the_moment_it_is_completed(laps):
    assert len(race(laps=laps, one=1.0)[1]["one"]) == laps
