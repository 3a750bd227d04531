"""What decides a run, and that everything after it is cut."""

import dataclasses

import pytest
from f1tenth_judge.judge.judge import is_decided, judge
from f1tenth_judge.plan.task import Task
from f1tenth_judge.record.record import Record
from f1tenth_judge.scenario.car import Car, Command, Pose
from f1tenth_judge.scenario.criteria import Criteria
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.scenario.scenario import StartLine, Verdict
from scenario_samples import (
    GOALS,
    TASKS,
    aborted,
    died,
    finished,
    racing,
    reached,
    record,
    rows,
    scenario,
    seen,
    tasks,
)  # fmt: skip


def verdict_of(*arguments, **others):
    return judge(*arguments, **others).decision.verdict


def test_all_goals_in_order_is_success(tmp_path):
    judgement = judge(scenario(), TASKS, seen(record(tmp_path, rows(4.0)), racing(), finished(3.0)))
    assert judgement.decision.verdict is Verdict.SUCCESS
    assert judgement.decision.stamp == 3.0
    assert judgement.passes["robot1"].times == [0.5, 1.5, 2.5]


def test_everything_after_the_end_is_cut(tmp_path):
    long = judge(
        scenario(), TASKS, seen(record(tmp_path, rows(9.0, contacts={5.0: "Wall_1"})), finished(3.0))
    )
    short = judge(scenario(), TASKS, seen(record(tmp_path, rows(3.0)), finished(3.0)))
    assert long.decision == short.decision
    assert long.record.hash_at_end() == short.record.hash_at_end() == "hash120"
    assert long.record.end == 3.0


def test_goal_may_be_reached_between_two_periods(tmp_path):
    # The tolerance of the last goal begins at 2.5 m, where the car is at 2.5 s.
    run = seen(record(tmp_path, rows(4.0)), racing(), finished(2.49))
    judgement = judge(scenario(), TASKS, run)
    assert judgement.decision.verdict is Verdict.SUCCESS
    assert judgement.passes["robot1"].times == [0.5, 1.5, 2.5]
    assert judgement.record.end == 2.475


def test_contact_before_the_end_is_a_collision_even_if_the_race_was_finished(tmp_path):
    judgement = judge(
        scenario(), TASKS, seen(record(tmp_path, rows(4.0, contacts={2.0: "Wall_1;crate"})), finished(3.0))
    )
    assert judgement.decision.verdict is Verdict.COLLISION
    assert judgement.decision.stamp == 2.0
    assert judgement.decision.reason == "robot1 touched Wall_1 and crate at 2.000 s with 1.00 m/s"
    assert judgement.record.hash_at_end() == "hash80"


def test_contact_in_the_last_period_is_a_collision(tmp_path):
    run = seen(record(tmp_path, rows(4.0, contacts={3.0: "Wall_1"})), finished(3.0))
    assert verdict_of(scenario(), TASKS, run) is Verdict.COLLISION


def test_planner_that_gives_up_is_aborted(tmp_path):
    judgement = judge(scenario(), TASKS, seen(record(tmp_path, rows(4.0)), racing(), aborted(2.0)))
    assert judgement.decision.verdict is Verdict.ABORTED
    assert judgement.decision.reason == (
        "robot1 gave up at 2.000 s: goal 2 of 3 aborted: Failed to find a valid plan."
    )


def test_finish_after_the_timeout_is_a_timeout(tmp_path):
    judgement = judge(scenario(timeout=2.0), TASKS, seen(record(tmp_path, rows(4.0)), finished(3.0)))
    assert judgement.decision.verdict is Verdict.TIMEOUT
    assert judgement.decision.reason == (
        "not finished after 2 s of simulated time; robot1 drove 2.0 m, 2 of 3 goals"
    )
    assert judgement.record.end == 2.0


def test_timeout_says_how_far_each_car_got_that_has_something_to_do(tmp_path):
    cars = record(tmp_path, rows(4.0), rows(4.0, car="robot2", speed=0.5), rows(4.0, car="robot3"))
    line = StartLine(x=1.0)
    laps = {car: Task(laps=2, line=line) for car in ("robot1", "robot2", "robot4")} | {"robot3": Task()}
    reason = judge(scenario(timeout=1.5), laps, seen(cars)).decision.reason
    assert reason.endswith("time; robot1 drove 1.5 m, 0 of 2 laps; robot2 drove 0.7 m, 0 of 2 laps")


def test_timeout_says_how_many_laps_were_driven(tmp_path):
    around = [(1.5, 0.0), (0.0, 6.0), (0.0, 0.0), (1.5, 0.0)]  # the line is crossed in the last step only
    table = [[*row[:2], *place, *row[4:]] for row, place in zip(rows(0.1, speed=300.0), around)]
    task = {"robot1": Task(laps=2, line=StartLine(x=1.0))}
    reason = judge(scenario(timeout=0.1), task, seen(record(tmp_path, table))).decision.reason
    assert reason.endswith(" m, 1 of 2 laps")


def test_finish_at_the_timeout_is_a_success(tmp_path):
    run = seen(record(tmp_path, rows(4.0)), finished(3.0))
    assert verdict_of(scenario(timeout=3.0), TASKS, run) is Verdict.SUCCESS


def test_broken_set_up_is_an_error_and_names_the_culprit(tmp_path):
    judgement = judge(scenario(), TASKS, seen(record(tmp_path, rows(2.0)), racing(), failure=died()))
    assert judgement.decision.verdict is Verdict.ERROR
    assert judgement.decision.reason == "robot1/move_base: was killed by signal 9"
    assert judgement.failure == died()


def test_failure_that_says_when_it_was_clear_ends_the_run_there(tmp_path):
    failure = dataclasses.replace(died(), stamp=1.0)
    judgement = judge(scenario(), TASKS, seen(record(tmp_path, rows(2.0)), failure=failure))
    assert judgement.decision.stamp == judgement.record.end == 1.0


def test_contact_before_the_set_up_broke_is_still_a_collision(tmp_path):
    run = seen(record(tmp_path, rows(2.0, contacts={1.0: "Wall_1"})), failure=died())
    assert verdict_of(scenario(), TASKS, run) is Verdict.COLLISION


def test_nothing_seen_at_all_is_an_error():
    judgement = judge(scenario(), TASKS, seen(Record({})))
    assert judgement.decision.verdict is Verdict.ERROR
    assert judgement.decision.reason == "runner: the run ended without a decision"


def test_planner_that_claims_goals_it_never_passed_is_no_success(tmp_path):
    goals = {"robot1": (Pose(1.0, 0.0), Pose(2.0, 3.0), Pose(3.0, 0.0))}
    judgement = judge(scenario(), tasks(goals), seen(record(tmp_path, rows(4.0)), finished(3.5)))
    assert judgement.decision.verdict is Verdict.ABORTED
    assert judgement.decision.reason == (
        "robot1 says that it finished, but did not pass goal 2 of 3 in order, nearest 3.00 m"
    )


def test_goals_passed_out_of_order_are_no_success(tmp_path):
    goals = {"robot1": (Pose(3.0, 0.0), Pose(1.0, 0.0))}
    judgement = judge(scenario(), tasks(goals), seen(record(tmp_path, rows(4.0)), finished(3.5, count=2)))
    assert judgement.decision.verdict is Verdict.ABORTED
    assert "did not pass goal 2 of 2 in order" in judgement.decision.reason


def test_goal_passed_in_the_wrong_direction_does_not_count(tmp_path):
    goals = {"robot1": (Pose(1.0, 0.0, 3.1),)}
    run = seen(record(tmp_path, rows(4.0)), finished(3.0, count=1))
    assert verdict_of(scenario(), tasks(goals), run) is Verdict.ABORTED


def test_record_that_ends_before_the_race_is_an_error(tmp_path):
    judgement = judge(scenario(), TASKS, seen(record(tmp_path, rows(3.0)), finished(3.5)))
    assert judgement.decision.verdict is Verdict.ERROR
    assert judgement.decision.reason == (
        "sim2d: its record ends before the race does (3.000 s instead of 3.500 s)"
    )


def test_laps_are_counted_in_loop_mode(tmp_path):
    goals = {"robot1": (Pose(1.0, 0.0), Pose(2.0, 0.0))}
    run = seen(record(tmp_path, rows(4.0)), reached(1.0, 1), reached(2.0, 2))
    assert verdict_of(scenario(), tasks(goals), run) is Verdict.SUCCESS
    assert verdict_of(scenario(laps=2), tasks(goals, laps=2), run) is Verdict.ERROR


def test_race_of_two_lasts_until_both_have_finished(tmp_path):
    both = scenario(cars=("robot1", "robot2"))
    goals = {"robot1": GOALS["robot1"], "robot2": (Pose(1.0, 1.0),)}
    run = record(tmp_path, rows(4.0), rows(4.0, car="robot2", y=1.0))
    one = (racing(car="robot2"), finished(3.0))
    two = (*one, finished(1.0, car="robot2", count=1))
    assert judge(both, tasks(goals), seen(run, *two)).decision.stamp == 3.0
    assert verdict_of(both, tasks(goals), seen(run, *one)) is Verdict.ERROR
    assert is_decided(tasks(goals), two, {})
    assert not is_decided(tasks(goals), one, {})


def test_abort_of_one_car_decides(tmp_path):
    assert is_decided(tasks({**GOALS, "robot2": GOALS["robot1"]}), [aborted(1.0)], {})


@pytest.mark.parametrize(
    ("contacts", "verdict"), [({1.0: "Wall_1"}, Verdict.COLLISION), ({}, Verdict.TIMEOUT)]
)
def test_car_on_a_command_profile_only_ends_by_contact_or_timeout(tmp_path, contacts, verdict):
    car = Car("robot1", driver=Driver.short_forms()["commands"], commands=(Command(0.0, 1.0),))
    run = seen(record(tmp_path, rows(2.0, contacts=contacts)))
    base = scenario(timeout=2.0)
    assert verdict_of(type(base)(**{**vars(base), "cars": (car,)}), {}, run) is verdict


def test_car_that_moves_before_the_start_is_out(tmp_path):
    run = seen(record(tmp_path, rows(4.0)), racing(0.5), finished(3.0))
    decision = judge(scenario(), TASKS, run).decision
    assert (decision.verdict, decision.stamp) == (Verdict.ABORTED, 0.075)
    assert decision.reason == "false start: robot1 moved at 0.075 s, before the start at 0.500 s"


def test_car_that_moves_during_the_countdown_is_out_before_a_start_was_heard(tmp_path):
    run = seen(record(tmp_path, rows(0.5)))
    decision = judge(scenario(time_to_start=2), TASKS, run).decision
    assert (decision.verdict, decision.stamp) == (Verdict.ABORTED, 0.075)
    assert decision.reason == "false start: robot1 moved at 0.075 s, before the countdown of 2 s was over"


def test_reason_of_a_false_start_does_not_depend_on_what_was_heard_later(tmp_path):
    early, late = seen(record(tmp_path, rows(0.5))), seen(record(tmp_path, rows(4.0)), racing(2.0))
    wanted = scenario(time_to_start=2)
    assert judge(wanted, TASKS, early).decision == judge(wanted, TASKS, late).decision


def test_car_that_waits_for_the_start_is_not(tmp_path):
    standing = [[row[0], row[1], max(0.0, float(row[0]) - 0.5), *row[3:]] for row in rows(4.0)]
    run = seen(record(tmp_path, standing), racing(0.5), finished(3.6))
    assert verdict_of(scenario(), TASKS, run) is Verdict.SUCCESS


def test_light_touch_does_not_end_the_race(tmp_path):
    touching = record(tmp_path, rows(4.0, contacts={1.0: "Wall_1"}))
    lenient = scenario(criteria=Criteria(light_touch=1.5))
    assert verdict_of(lenient, TASKS, seen(touching, finished(3.0))) is Verdict.SUCCESS
    assert verdict_of(scenario(), TASKS, seen(touching, finished(3.0))) is Verdict.COLLISION
