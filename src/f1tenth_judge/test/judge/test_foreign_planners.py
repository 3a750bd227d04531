"""A planner that reports nothing is judged by the record alone; one that reports must not contradict it."""

import dataclasses
import math

import pytest
from f1tenth_judge.judge.judge import is_decided, judge
from f1tenth_judge.plan.task import Task
from f1tenth_judge.record.observations import Observations
from f1tenth_judge.record.record import Record
from f1tenth_judge.scenario.car import Pose
from f1tenth_judge.scenario.criteria import Criteria
from f1tenth_judge.scenario.scenario import StartLine, Verdict
from report_samples import RADIUS, circling
from scenario_samples import GOALS, TASKS, aborted, died, finished, record, rows, scenario, seen

LINE = StartLine(RADIUS, 0.0, math.pi / 2, 1.0)
AROUND = 2 * math.pi * RADIUS  # m
LAPS = Task(laps=1, line=LINE)
GOALS_ONLY = Task(GOALS["robot1"])


def decision_of(wanted, tasks, run):
    return judge(wanted, tasks, run).decision


def test_laps_are_done_by_the_record(tmp_path):
    run = seen(record(tmp_path, circling(10.0, speed=AROUND / 5)))
    decision = decision_of(scenario(), {"robot1": LAPS}, run)
    assert (decision.verdict, decision.reason) == (Verdict.SUCCESS, "every lap was driven")
    assert decision.stamp == pytest.approx(5.0, abs=0.026)
    assert (
        decision_of(scenario(), {"robot1": dataclasses.replace(LAPS, laps=3)}, run).verdict is Verdict.TIMEOUT
    )


def test_goals_are_done_by_the_record(tmp_path):
    decision = decision_of(scenario(), {"robot1": GOALS_ONLY}, seen(record(tmp_path, rows(4.0))))
    assert (decision.verdict, decision.stamp) == (Verdict.SUCCESS, 2.5)
    assert decision.reason == "every goal was passed in order"


def test_who_is_to_report_has_to_say_that_it_is_done(tmp_path):
    run = record(tmp_path, rows(4.0))
    reports = {"robot1": dataclasses.replace(GOALS_ONLY, reports=True)}
    assert decision_of(scenario(), reports, seen(run)).verdict is Verdict.ERROR
    assert decision_of(scenario(), reports, seen(run, finished(3.0))).stamp == 3.0
    assert decision_of(scenario(), {"robot1": GOALS_ONLY}, seen(run, finished(3.0))).stamp == 3.0


def test_laps_count_whatever_is_said(tmp_path):
    run = seen(record(tmp_path, circling(4.0, speed=AROUND / 5)), finished(3.0))
    assert decision_of(scenario(), {"robot1": LAPS}, run).verdict is Verdict.ERROR


@pytest.mark.parametrize(
    ("task", "reason"),
    [
        (LAPS, "every car drove its laps"),
        (Task((Pose(0.0, 3.0, math.pi),)), "every car passed every goal in order"),
    ],
)
def test_all_of_several_have_to_be_done(tmp_path, task, reason):
    cars = {car: circling(9.0, car, speed=AROUND / lap) for car, lap in (("robot1", 5), ("robot2", 7))}
    both = scenario(cars=tuple(cars))
    decision = decision_of(both, dict.fromkeys(cars, task), seen(record(tmp_path, *cars.values())))
    assert (decision.verdict, decision.reason) == (Verdict.SUCCESS, reason)
    assert decision.stamp > 1.5


def test_who_has_nothing_to_do_is_not_waited_for(tmp_path):
    run = seen(record(tmp_path, rows(4.0), rows(4.0, car="robot2", speed=0.0, y=9.0)))
    tasks = {"robot1": GOALS_ONLY, "robot2": Task()}
    decision = decision_of(scenario(cars=tuple(tasks)), tasks, run)
    assert (decision.verdict, decision.reason) == (Verdict.SUCCESS, "every goal was passed in order")


def test_a_run_is_over_when_the_record_shows_that_all_is_done():
    tasks = {"robot1": LAPS, "robot2": GOALS_ONLY}
    assert is_decided(tasks, [], {"robot1": 3.0, "robot2": 4.0})
    assert not is_decided(tasks, [], {"robot1": 3.0, "robot2": None})
    assert not is_decided(tasks, [], {"robot1": 3.0})


@pytest.mark.parametrize(("sound_until", "verdict"), [(2.475, Verdict.ERROR), (2.5, Verdict.SUCCESS)])
def test_what_the_record_shows_counts_until_the_set_up_broke(tmp_path, sound_until, verdict):
    run = record(tmp_path, rows(4.0))
    broken = Observations(run, failure=died(), sound_until=sound_until)
    judgement = judge(scenario(), {"robot1": GOALS_ONLY}, broken)
    assert judgement.decision.verdict is verdict
    assert judgement.failure == (died() if verdict is Verdict.ERROR else None)


def test_collision_that_the_record_shows_as_a_light_touch_is_none(tmp_path):
    touching = record(tmp_path, rows(4.0, contacts={1.0: "Wall_1"}))
    lenient = scenario(criteria=Criteria(light_touch=1.5))
    run = Observations(touching, (finished(3.0),))
    assert decision_of(lenient, TASKS, run).verdict is Verdict.SUCCESS


@pytest.mark.parametrize(("light_touch", "verdict"), [(1.0, Verdict.COLLISION), (1.01, Verdict.SUCCESS)])
def test_touch_as_fast_as_the_limit_is_not_light(tmp_path, light_touch, verdict):
    run = seen(record(tmp_path, rows(4.0, contacts={1.0: "Wall_1"})), finished(3.0))
    wanted = scenario(criteria=Criteria(light_touch=light_touch))
    assert decision_of(wanted, TASKS, run).verdict is verdict


def test_decisions_name_their_car(tmp_path):
    far = {"robot2": Task((Pose(9.0, 9.0),), reports=True)}
    for run, tasks in (
        (seen(record(tmp_path, rows(4.0, "robot2", contacts={1.0: "Wall_1"}))), far),
        (seen(record(tmp_path, rows(4.0, "robot2")), aborted(2.0, "robot2")), far),
        (seen(record(tmp_path, rows(4.0, "robot2")), finished(3.0, "robot2")), far),
    ):
        assert "robot2" in decision_of(scenario(cars=("robot2",)), tasks, run).reason


def test_who_gives_up_without_a_reason_is_aborted(tmp_path):
    run = seen(record(tmp_path, rows(4.0)), aborted(2.0, reason=""))
    assert decision_of(scenario(), TASKS, run).reason == "robot1 gave up at 2.000 s: no reason given"


def test_claim_of_a_car_that_is_not_in_the_record(tmp_path):
    run = seen(record(tmp_path, rows(4.0, car="robot2")), finished(3.0))
    decision = decision_of(scenario(), TASKS, run)
    assert decision.reason == "robot1 says that it finished, but did not pass goal 1 of 3 in order"


def test_errors_are_dated_by_the_end_of_the_record(tmp_path):
    assert decision_of(scenario(), TASKS, seen(Record({}))).stamp == 0.0
    assert decision_of(scenario(), TASKS, seen(record(tmp_path, rows(3.0)), finished(3.5))).stamp == 3.0
