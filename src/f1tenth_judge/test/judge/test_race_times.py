"""When a race began, and what its laps count from."""

import math

import pytest
from f1tenth_judge.judge.judge import judge
from f1tenth_judge.judge.laps import lap_times, start_of_race
from f1tenth_judge.plan.task import Task
from f1tenth_judge.scenario.car import Pose
from f1tenth_judge.scenario.scenario import StartLine
from report_samples import RADIUS, circling
from scenario_samples import (
    GOALS,
    PERIOD,
    TASKS,
    finished,
    racing,
    reached,
    record,
    rows,
    scenario,
    seen,
    tasks,
)

LINE = StartLine(RADIUS, 0.0, math.pi / 2, 1.0)
SPEED = 2 * math.pi * RADIUS / 5.0  # m/s: a lap in 5 s


def laps_of(wanted, task, run):
    return lap_times(wanted, task, judge(wanted, task, run), run.updates)


def start_of(wanted, task, run):
    return start_of_race(task, judge(wanted, task, run), run.updates)


def waiting_first(seconds, moving):
    """Rows of a car that stands for a while (s) before it moves."""
    first, *_ = moving = list(moving)
    still = [[f"{PERIOD * number:.9f}", *first[1:]] for number in range(1, round(seconds / PERIOD) + 1)]
    return [*still, *([f"{float(stamp) + seconds:.9f}", *others] for stamp, *others in moving)]


@pytest.mark.parametrize(("signal", "start"), [(0.0, 0.0), (3.0, 3.0), (3.025, 0.075)])
def test_a_race_begins_with_a_signal_that_was_heard_before_its_end(tmp_path, signal, start):
    run = seen(record(tmp_path, rows(4.0)), racing(signal, "robot2"), finished(3.0))
    task = {"robot1": Task(GOALS["robot1"], reports=True)}
    assert start_of(scenario(), task, run) == pytest.approx(start)


def test_without_a_signal_a_race_begins_when_the_first_moves_that_has_a_task(tmp_path):
    run = seen(
        record(
            tmp_path,
            waiting_first(1.0, rows(3.0)),
            waiting_first(0.5, rows(3.5, "robot2", y=2.0)),
            rows(4.0, "robot3", y=4.0),
            rows(4.0, "robot4", speed=0.0, y=6.0),
        )
    )
    cars = {"robot1": Task(GOALS["robot1"]), "robot2": Task((Pose(9.0, 9.0),)), "robot3": Task()}
    cars["robot4"] = Task((Pose(9.0, 9.0),))
    wanted = scenario(cars=tuple(cars), timeout=4.0)
    assert start_of(wanted, cars, run) == pytest.approx(0.575)
    assert start_of(wanted, {"robot3": Task(), "robot4": cars["robot4"]}, run) is None


@pytest.mark.parametrize(
    ("obeys_start", "first"),
    [(False, 4.95), (True, 4.5)],  # from its own first move, or from the signal
)
def test_first_lap_over_a_line_begins_with_the_signal_only_for_who_waits_for_it(tmp_path, obeys_start, first):
    run = seen(record(tmp_path, circling(10.0, speed=SPEED)), racing(0.5, "robot2"))
    task = {"robot1": Task(laps=1, line=LINE, obeys_start=obeys_start)}
    judgement = judge(scenario(timeout=9.0), {"robot1": Task(laps=1, line=LINE)}, run)
    found = lap_times(scenario(timeout=9.0), task, judgement, run.updates)["robot1"]
    assert found == [pytest.approx(first, abs=0.026)]


def test_goals_without_reports_count_from_the_signal_of_others(tmp_path):
    run = seen(record(tmp_path, rows(4.0)), racing(0.25, "robot2"))
    task = {"robot1": Task(GOALS["robot1"])}
    assert laps_of(scenario(), task, run) == {"robot1": [2.25]}


def test_goals_without_reports_or_a_signal_count_from_the_first_move(tmp_path):
    run = seen(record(tmp_path, waiting_first(1.0, rows(6.0, speed=2.0))))
    twice = {"robot1": Task((Pose(1.0, 0.0), Pose(4.0, 0.0), Pose(6.0, 0.0), Pose(9.0, 0.0)))}
    moved, ends = 1.075, (2.75, 5.25)  # a car has moved when it is more than 0.05 m away
    found = laps_of(scenario(laps=2), twice, run)["robot1"]
    assert found == pytest.approx([ends[0] - moved, ends[1] - ends[0]])


def test_a_lap_that_was_not_completed_has_no_time(tmp_path):
    path = record(tmp_path, waiting_first(1.0, rows(3.0)))
    twice = (Pose(1.0, 0.0), Pose(9.0, 0.0))
    found = laps_of(scenario(laps=2, timeout=4.0), {"robot1": Task(twice)}, seen(path))
    assert found == {"robot1": [pytest.approx(0.425)]}
    said = seen(path, racing(0.0), reached(2.0, 1))
    assert laps_of(scenario(laps=2, timeout=4.0), tasks({"robot1": twice}), said) == {"robot1": [2.0]}


def test_who_reports_counts_from_its_own_signal(tmp_path):
    run = seen(record(tmp_path, rows(4.0)), racing(0.0, "robot2"), racing(0.05), finished(3.0))
    assert laps_of(scenario(), TASKS, run)["robot1"] == [2.95]


def test_who_never_moves_counts_from_zero(tmp_path):
    at_its_goal = record(tmp_path, rows(1.0, speed=0.0))
    assert laps_of(scenario(), {"robot1": Task((Pose(0.0, 0.0),))}, seen(at_its_goal)) == {"robot1": [0.025]}
    line = StartLine(0.0, 0.0, 0.0, 0.02)
    places = [(0.0, 0.0), (0.0, 0.03), (-0.01, 0.03), (-0.01, 0.0), (0.0, 0.0)]
    tiny = [[*row[:2], x, y, *row[4:]] for row, (x, y) in zip(rows(0.125), places)]
    run = seen(record(tmp_path, tiny))
    assert laps_of(scenario(), {"robot1": Task(laps=1, line=line)}, run) == {"robot1": [pytest.approx(0.125)]}


def test_a_car_that_is_not_in_the_record_has_no_laps(tmp_path):
    run = seen(record(tmp_path, rows(4.0)), finished(3.0))
    others = {**TASKS, "robot2": Task(laps=1, line=LINE)}
    judgement = judge(scenario(), TASKS, run)
    assert lap_times(scenario(), others, judgement, run.updates)["robot2"] == []
