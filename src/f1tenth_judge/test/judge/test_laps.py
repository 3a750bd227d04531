"""Laps are timed where the line is crossed, by direction."""

import math

import pytest
from f1tenth_judge.judge.judge import judge
from f1tenth_judge.judge.laps import lap_times
from f1tenth_judge.judge.start_line import LapCounter
from f1tenth_judge.scenario.scenario import StartLine
from report_samples import RADIUS, circling
from scenario_samples import TASKS, finished, racing, reached, record, rows, scenario, seen, tasks

# The circle is driven counter-clockwise from (RADIUS, 0).
LINE = StartLine(RADIUS, 0.0, math.pi / 2, 1.0)


def laps_on(line, places, start=0.0):
    counter = LapCounter(line, start)
    for index, (x, y) in enumerate(places):
        counter.update(float(index), x, y)
    return counter.lap_times


def test_laps_are_timed_at_the_line(tmp_path):
    wanted = scenario(start_line=LINE, timeout=60.0)
    run = seen(record(tmp_path, circling(30.0, speed=1.5)), racing(), finished(30.0))
    laps = lap_times(wanted, TASKS, judge(wanted, TASKS, run), run.updates)
    around = 2 * math.pi * RADIUS / 1.5
    assert laps == {"robot1": pytest.approx([around, around], abs=1e-3)}


def test_without_a_line_laps_end_with_their_last_goal(tmp_path):
    wanted = scenario(laps=2, timeout=20.0)
    run = seen(record(tmp_path, rows(8.0, speed=0.5)), racing(), reached(4.0, 3), reached(7.5, 6))
    twice = tasks(laps=2)
    assert lap_times(wanted, twice, judge(wanted, twice, run), run.updates) == {"robot1": [4.0, 3.5]}


def test_crossing_is_interpolated():
    line = StartLine(0.0, 0.0, 0.0, 2.0)
    assert laps_on(line, [(0, 0), (1, 9), (-1, 9), (-0.75, 0), (0.25, 0)]) == [3.75]


def test_crossing_backwards_has_to_be_made_good():
    line = StartLine(0.0, 0.0, 0.0, 2.0)
    assert laps_on(line, [(1, 0), (-1, 0), (1, 0)]) == []
    assert laps_on(line, [(1, 0), (-1, 0), (1, 0), (1, 9), (-1, 9), (-1, 0), (1, 0)]) == [5.5]


def test_passing_beside_the_line_is_no_lap():
    assert laps_on(StartLine(0.0, 0.0, 0.0, 2.0), [(1, 0), (-1, 5), (1, 5)]) == []


def test_who_starts_behind_the_line_has_to_cross_it_first():
    line = StartLine(0.0, 0.0, 0.0, 2.0)
    assert laps_on(line, [(-1, 0), (1, 0), (1, 9), (-1, 9), (-1, 0), (1, 0)]) == [4.5]


def test_first_lap_begins_at_the_start():
    line = StartLine(0.0, 0.0, 0.0, 2.0)
    assert laps_on(line, [(0, 0), (1, 9), (-1, 9), (-1, 0), (1, 0)], start=1.0) == [2.5]


@pytest.mark.parametrize("yaw", [0.0, 0.7, 2.0, -2.5])
@pytest.mark.parametrize(("across", "counts"), [(0.9, True), (-0.9, True), (1.1, False), (-1.1, False)])
def test_a_lap_counts_between_the_ends_of_a_line_wherever_it_lies(yaw, across, counts):
    """A lap in a big box, then over the line, which is at (2, -3), with a slant."""
    places = [(0.5, 0.0), (9.0, 0.0), (9.0, 9.0), (-9.0, 9.0), (-1.0, across + 0.2), (3.0, across - 0.6)]
    cosine, sine = math.cos(yaw), math.sin(yaw)
    turned = [(2 + cosine * x - sine * y, -3 + sine * x + cosine * y) for x, y in places]
    assert laps_on(StartLine(2.0, -3.0, yaw, 2.0), turned) == ([pytest.approx(4.25)] if counts else [])


def test_the_ends_of_the_line_belong_to_it():
    assert laps_on(StartLine(0.0, 0.0, 0.0, 2.0), [(1, 9), (-1, 9), (-1, 1), (1, 1)]) == [2.5]


def test_a_car_on_the_line_has_crossed_it():
    line = StartLine(0.0, 0.0, 0.0, 2.0)
    assert laps_on(line, [(0, 0), (1, 9), (-1, 9), (-1, 0), (0, 0), (1, 0)]) == [4.0]
    assert laps_on(line, [(-1, 0), (0, 0), (1, 9), (-1, 9), (-1, 0), (0, 0)]) == [5.0]
