"""Each criterion reports what was measured and what is asked for, and each can fail."""

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest
from f1tenth_judge.judge.criteria import evaluate
from f1tenth_judge.judge.criterion import Measured, Status
from f1tenth_judge.judge.driving_criteria import lateral, longitudinal
from f1tenth_judge.judge.judge import judge
from f1tenth_judge.judge.road import Excursion
from f1tenth_judge.record.interventions import Intervention
from f1tenth_judge.record.observations import Observations
from f1tenth_judge.record.record import Record
from f1tenth_judge.record.replay import Poses
from f1tenth_judge.scenario.criteria import Criteria
from f1tenth_judge.scenario.scenario import Verdict
from scenario_samples import TASKS, aborted, died, finished, record, rows, scenario, seen, with_clearance


def results(wanted, run, **measured):
    return {each.name: each for each in evaluate(wanted, judge(wanted, TASKS, run), Measured(**measured))}


def names(wanted):
    return set(results(wanted, seen(Record({}), aborted(0.0))))


def limited(expected=Verdict.SUCCESS, **limits):
    return scenario(expected, criteria=Criteria(**limits))


@pytest.fixture
def runs(tmp_path):
    return {
        Verdict.SUCCESS: seen(record(tmp_path, rows(4.0)), finished(3.0)),
        Verdict.COLLISION: seen(record(tmp_path, rows(4.0, contacts={2.0: "Wall_1"})), finished(3.0)),
        Verdict.TIMEOUT: seen(record(tmp_path, rows(10.0, speed=0.1))),
        Verdict.DISQUALIFIED: Observations(
            record(tmp_path, rows(4.0)),
            interventions=(Intervention(2.0, "set_model_state", "/robot1/planner", "robot1"),),
        ),
        Verdict.ABORTED: seen(record(tmp_path, rows(4.0)), aborted(2.0)),
        Verdict.ERROR: seen(record(tmp_path, rows(2.0)), failure=died()),
    }


@pytest.mark.parametrize("expected", Verdict)
def test_expected_ending_passes(runs, expected):
    found = results(scenario(expected), runs[expected])
    assert found["verdict"].status is Status.PASSED
    assert all(each.status is not Status.FAILED for each in found.values())


@pytest.mark.parametrize("expected", Verdict)
@pytest.mark.parametrize("actual", Verdict)
def test_wrong_expectation_fails(runs, expected, actual):
    verdict = results(scenario(expected), runs[actual])["verdict"]
    assert (verdict.status is Status.PASSED) == (expected is actual)
    assert (verdict.actual, verdict.limit) == (actual.value, expected.value)


def test_error_of_somebody_else_fails(runs):
    found = results(scenario(Verdict.ERROR, culprit="sim2d"), runs[Verdict.ERROR])
    assert found["verdict"].status is Status.PASSED
    assert (found["culprit"].status, found["culprit"].actual) == (Status.FAILED, "robot1/move_base")


def test_culprit_is_judged_only_if_an_error_is_expected(runs):
    assert "culprit" not in results(scenario(), runs[Verdict.ERROR])


def test_missed_goals_fail_with_their_number(runs):
    found = results(scenario(), runs[Verdict.ABORTED])["goals_in_order"]
    assert (found.status, found.actual, found.limit, found.unit) == (Status.FAILED, 2, 3, "goals")
    assert found.reason == "not all goals passed by robot1"


def test_contact_fails_unless_expected(runs):
    found = results(scenario(), runs[Verdict.COLLISION])["collision"]
    assert (found.status, found.actual, found.limit) == (Status.FAILED, 1, 0)
    assert found.reason == "robot1 touched Wall_1 at 2.000 s with 1.00 m/s"


def test_missing_contact_fails_if_expected(runs):
    found = results(scenario(Verdict.COLLISION), runs[Verdict.SUCCESS])["collision"]
    assert (found.status, found.actual, found.limit) == (Status.FAILED, 0, "at least 1")


def test_timeout_fails_unless_expected(runs):
    found = results(scenario(), runs[Verdict.TIMEOUT])["timeout"]
    assert (found.status, found.actual, found.limit, found.unit) == (Status.FAILED, 10.0, 10.0, "s")


def test_timeout_that_did_not_come_fails_if_expected(runs):
    assert results(scenario(Verdict.TIMEOUT), runs[Verdict.SUCCESS])["timeout"].status is Status.FAILED


@pytest.mark.parametrize(("limit", "status"), [(0.5, Status.PASSED), (0.51, Status.FAILED)])
def test_clearance_is_held_against_its_limit(runs, limit, status):
    found = results(with_clearance(limit), runs[Verdict.SUCCESS])["minimum_clearance"]
    assert (found.status, found.actual, found.limit, found.unit) == (status, 0.5, limit, "m")


def test_clearance_after_the_end_does_not_count(tmp_path):
    late = [*rows(3.0, clearance=0.5), *list(rows(4.0, clearance=0.0))[120:]]
    run = seen(record(tmp_path, late), finished(3.0))
    assert results(with_clearance(0.4), run)["minimum_clearance"].actual == 0.5


def test_clearance_without_a_record_fails():
    run = seen(Record({}), aborted(0.0))
    assert (
        results(with_clearance(0.1, expected=Verdict.ABORTED), run)["minimum_clearance"].status
        is Status.FAILED
    )


def test_clearance_is_judged_only_with_a_limit():
    assert "minimum_clearance" not in names(scenario())
    assert "minimum_clearance" in names(with_clearance(0.1))


def test_goals_are_judged_only_if_success_is_expected(runs):
    found = results(scenario(Verdict.ABORTED), runs[Verdict.ABORTED])["goals_in_order"]
    assert found.status is Status.NOT_JUDGED


@pytest.mark.parametrize(
    ("words", "status"), [("Failed to find", Status.PASSED), ("Robot is", Status.FAILED)]
)
def test_reason_must_hold_the_expected_words(runs, words, status):
    found = results(scenario(Verdict.ABORTED, reason=words), runs[Verdict.ABORTED])["reason"]
    assert (found.status, found.limit) == (status, f"'{words}' in it")
    assert found.actual.startswith("robot1 gave up at 2.000 s: ")


def test_light_touch_is_no_collision(runs):
    touching = runs[Verdict.COLLISION]
    assert results(limited(light_touch=1.1), touching)["collision"].actual == 0
    assert results(limited(light_touch=1.1), touching)["verdict"].status is Status.PASSED
    assert results(limited(light_touch=0.9), touching)["collision"].actual == 1
    assert results(limited(light_touch=0.9), touching)["verdict"].status is Status.FAILED


# Limit, what is measured besides the record, the actual value.
MEASURES = {
    "minimum_clearance": (0.4, {}, 0.5),
    "lap_time": (12.0, {"lap_times": {"robot1": [10.0, 11.0], "robot2": [9.0]}}, 11.0),
    "lateral_acceleration": (2.5, {}, 2.0),
    "standstill": (2.0, {"start": 0.5}, 0.975),
    "localization_error": (
        0.6,
        {"estimates": {"robot1": Poses([1.0, 2.0], [(1, 1.5, 0), (2, 0.5, 0)])}},
        0.5,
    ),
    "localization_yaw_error": (0.2, {"estimates": {"robot1": Poses([1.0], [(1, 1, 6.2831853 - 0.1)])}}, 0.1),
    "odometry_drift": (0.3, {"estimates": {"robot1": Poses([1.0, 2.0], [(0, 0, 0), (1, 0.2, 0)])}}, 0.2),
    "real_time_factor": (10.0, {"real_time_factor": 12.0}, 12.0),
}
# With a test of its own.
OTHER_MEASURES = {"slows_to"}
LOWER_LIMITS = {"minimum_clearance", "real_time_factor"}


def recorded(folder):
    """Straight on at y = 1 m with 1 m/s, said to turn at 2 rad/s, and to be at rest at last."""
    table = []
    for row in rows(4.0, y=1.0):
        row[7] = 2.0 if float(row[0]) < 2.0 else 0.0
        row[5] = 0.0 if 0.9 < float(row[0]) - 2.0 < 1.92 else row[5]
        table.append(row)
    return record(folder, table)


def test_every_criterion_with_a_limit_is_among_these():
    limits = {field.name: 1.0 for field in dataclasses.fields(Criteria) if field.default is None}
    assert names(limited(**limits)) - names(scenario()) == {*MEASURES, *OTHER_MEASURES}


@pytest.mark.parametrize("name", MEASURES)
def test_measure_is_held_against_its_limit(tmp_path, name):
    limit, measured, actual = MEASURES[name]
    run = seen(recorded(tmp_path), finished(4.0))
    found = results(limited(**{name: limit}), run, **measured)[name]
    assert (found.status, found.limit) == (Status.PASSED, limit)
    assert found.actual == pytest.approx(actual, abs=1e-3)
    missed = limit * 2 if name in LOWER_LIMITS else limit / 10
    assert results(limited(**{name: missed}), run, **measured)[name].status is Status.FAILED


@pytest.mark.parametrize(
    ("speeds", "status", "actual"),
    [
        ((0.0, 2.0, 0.1), Status.PASSED, 0.1),
        ((0.0, 2.0, 1.0), Status.FAILED, 1.0),
        ((0.0, 0.2, 0.1), Status.FAILED, None),
        ((0.3, 0.0, 2.0, 1.0), Status.FAILED, 1.0),
    ],
)
def test_car_that_is_to_stop_must_slow_down_after_it_was_faster(tmp_path, speeds, status, actual):
    table = list(rows(0.025 * len(speeds)))
    for row, speed in zip(table, speeds):
        row[5] = speed
    run = seen(record(tmp_path, table), aborted(0.025 * len(speeds)))
    found = results(limited(Verdict.ABORTED, slows_to=0.3), run)["slows_to"]
    assert (found.status, found.actual, found.limit) == (status, actual, 0.3)


@pytest.mark.parametrize("name", MEASURES)
def test_measure_that_is_missing_fails(name):
    run = seen(Record({}), aborted(0.0))
    found = results(limited(Verdict.ABORTED, **{name: 1.0}), run)[name]
    assert (found.status, found.actual) == (Status.FAILED, None)
    assert found.reason


@pytest.mark.parametrize("name", sorted({*MEASURES} - {"real_time_factor"}))
def test_measure_of_driving_is_not_judged_where_a_crash_is_expected(runs, name):
    found = results(limited(Verdict.COLLISION, **{name: 1.0}), runs[Verdict.COLLISION])[name]
    assert found.status is Status.NOT_JUDGED


@pytest.mark.parametrize("name", MEASURES)
def test_measure_is_judged_only_with_a_limit(name):
    assert name not in names(scenario())
    assert name in names(limited(**{name: 1.0}))


def test_road_is_judged_wherever_it_is_known(runs):
    left = {"excursions": [Excursion("robot1", 1.0, 2.0, 0.5, 1.0, 1.0)]}
    assert "off_road" not in names(scenario())
    assert results(scenario(), runs[Verdict.SUCCESS], excursions=[])["off_road"].status is Status.PASSED
    assert results(scenario(), runs[Verdict.SUCCESS], **left)["off_road"].status is Status.FAILED
    assert results(limited(off_road=0.5), runs[Verdict.SUCCESS], **left)["off_road"].status is Status.PASSED
    crash = results(scenario(Verdict.COLLISION), runs[Verdict.COLLISION], **left)["off_road"]
    assert crash.status is Status.NOT_JUDGED


def test_accelerations_are_those_of_the_turning_body():
    time = np.linspace(0.0, 2.0, 2001)
    yaw, yaw_rate = 0.7 * time, np.full_like(time, 0.7)
    # Sliding straight on, braked by 1 m/s^2, while it turns.
    speed = 4.0 - time
    track = SimpleNamespace(time=time, v_x=speed * np.cos(yaw), v_y=-speed * np.sin(yaw), yaw_rate=yaw_rate)
    np.testing.assert_allclose(longitudinal(track), -np.cos(yaw), atol=0.005)
    np.testing.assert_allclose(lateral(track), np.sin(yaw), atol=0.005)


def test_speed_of_a_single_row_has_no_rate():
    one = np.ones(1)
    track = SimpleNamespace(time=one, v_x=3 * one, v_y=5 * one, yaw_rate=2 * one)
    assert longitudinal(track).tolist() == [-10.0]
    assert lateral(track).tolist() == [6.0]
