"""Each criterion as a whole: its name, what was measured, the limit, the unit and the reason."""

import dataclasses
import json
import math

import pytest
import yaml
from f1tenth_judge.judge import driving_criteria as driving
from f1tenth_judge.judge import run_criteria, verdict_criteria
from f1tenth_judge.judge.criterion import Criterion, Measured, Status
from f1tenth_judge.judge.goal_passes import GoalPasses
from f1tenth_judge.judge.judge import Decision, Judgement
from f1tenth_judge.judge.road import Excursion
from f1tenth_judge.places import lookup
from f1tenth_judge.record.observations import Failure
from f1tenth_judge.record.record import Record
from f1tenth_judge.record.replay import Poses
from f1tenth_judge.record.row import COLUMNS
from f1tenth_judge.results.result_file import SCHEMA_FILE
from f1tenth_judge.scenario.car import Car, Pose
from f1tenth_judge.scenario.criteria import Criteria
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.scenario.scenario import Verdict
from scenario_samples import record, rows, scenario

LEFT = "beyond the edge of the road, from 1.000 to 1.500 s, at (2.00, 3.25)"
PASSED, FAILED, NOT_JUDGED = Status.PASSED, Status.FAILED, Status.NOT_JUDGED


def test_words_for_the_status_are_those_of_result_files():
    allowed = json.loads(SCHEMA_FILE.read_text(encoding="utf-8"))["$defs"]["criterion"]["properties"][
        "status"
    ]
    assert [each.value for each in Status] == allowed["enum"]


def decided(verdict, tracks=None, failure=None, passes=None, reason="so it was"):
    return Judgement(Decision(3.0, verdict, reason), Record(tracks or {}), passes or {}, failure)


def judged(folder, *cars):
    return decided(Verdict.SUCCESS, record(folder, *cars).tracks)


def excursion(excess, car="robot1"):
    return Excursion(car, 1.0, 1.5, excess, 2.0, 3.25)


# Criterion, its limit, what is measured besides the record, and what it says of a car that drives with 1 m/s
# at y = 1 m, turning with 2 rad/s, half a metre away from everything.
SAYINGS = [
    (driving.minimum_clearance, 0.5, {}, (PASSED, 0.5, 0.5, "m", "came as close as 0.500 m")),
    (driving.minimum_clearance, 0.51, {}, (FAILED, 0.5, 0.51, "m", "came as close as 0.500 m")),
    (
        driving.lap_time,
        11.0,
        {"lap_times": {"robot1": [10.0, 11.0], "robot2": [9.0]}},
        (PASSED, 11.0, 11.0, "s", "lap 2 of robot1 took 11.000 s"),
    ),
    (
        driving.lap_time,
        10.9,
        {"lap_times": {"robot1": [10.0], "robot2": [11.0, 9.0]}},
        (FAILED, 11.0, 10.9, "s", "lap 1 of robot2 took 11.000 s"),
    ),
    (driving.lap_time, 10.0, {}, (FAILED, None, 10.0, "s", "no lap was completed")),
    (driving.lateral_acceleration, 2.0, {}, (PASSED, 2.0, 2.0, "m/s^2", "robot1 reached 2.00 m/s^2")),
    (driving.lateral_acceleration, 1.9, {}, (FAILED, 2.0, 1.9, "m/s^2", "robot1 reached 2.00 m/s^2")),
    (
        driving.off_road,
        0.5,
        {"excursions": [excursion(0.5), excursion(0.25)]},
        (PASSED, 0.5, 0.5, "m", f"robot1 was up to 0.500 m {LEFT}"),
    ),
    (
        driving.off_road,
        0.2,
        {"excursions": [excursion(0.1), excursion(0.25, "robot2")]},
        (FAILED, 0.25, 0.2, "m", f"robot2 was up to 0.250 m {LEFT}"),
    ),
    (driving.off_road, 0.0, {"excursions": []}, (PASSED, 0.0, 0.0, "m", "every car stayed on the road")),
    (driving.standstill, 0.0, {}, (PASSED, 0.0, 0.0, "s", "robot1 stood for 0.000 s")),
    (driving.slows_to, 1.5, {}, (FAILED, None, 1.5, "m/s", "no car was faster")),
    (driving.slows_to, 1.0, {}, (FAILED, None, 1.0, "m/s", "no car was faster")),
    (driving.slows_to, 0.9, {}, (FAILED, 1.0, 0.9, "m/s", "robot1 slowed down to 1.000 m/s")),
    (
        run_criteria.localization_error,
        0.5,
        {"estimates": {"robot1": Poses([1.0], [(1.3, 1.4, 0)])}},
        (PASSED, pytest.approx(0.5), 0.5, "m", "0.500 m (RMS), 0.500 m at most"),
    ),
    (run_criteria.localization_error, 0.5, {}, (FAILED, None, 0.5, "m", "no estimate (amcl_pose) was heard")),
    (
        run_criteria.localization_yaw_error,
        0.2,
        {"estimates": {"robot1": Poses([1.0, 2.0], [(1, 1, 0.3), (2, 1, -0.3)])}},
        (FAILED, pytest.approx(0.3), 0.2, "rad", "0.300 rad (RMS), 0.300 rad at most"),
    ),
    (
        run_criteria.localization_yaw_error,
        0.2,
        {"estimates": {"robot1": Poses([], [])}},
        (FAILED, None, 0.2, "rad", "no estimate (amcl_pose) was heard"),
    ),
    (
        run_criteria.real_time_factor,
        10.0,
        {"real_time_factor": 10.0},
        (PASSED, 10.0, 10.0, "", "10.0 simulated seconds per second"),
    ),
    (
        run_criteria.real_time_factor,
        10.0,
        {"real_time_factor": 9.5},
        (FAILED, 9.5, 10.0, "", "9.5 simulated seconds per second"),
    ),
    (run_criteria.real_time_factor, 10.0, {}, (FAILED, None, 10.0, "", "too short to measure")),
]


@pytest.mark.parametrize(("criterion", "limit", "measured", "said"), SAYINGS)
def test_criterion_with_a_limit(tmp_path, criterion, limit, measured, said):
    table = [[*row[:7], 2.0, *row[8:]] for row in rows(4.0, y=1.0)]
    wanted = scenario(criteria=Criteria(**{criterion.__name__: limit}))
    found = criterion(wanted, judged(tmp_path, table), Measured(**measured))
    assert found == Criterion(criterion.__name__, *said)


@pytest.mark.parametrize(("driver", "status"), [("race", FAILED), ("pursuit", NOT_JUDGED)])
def test_limits_of_the_reference_planner_are_for_it_alone(tmp_path, driver, status):
    limits = Criteria(
        minimum_clearance=0.6, lap_time=8.0, standstill=0.1, of_reference=("minimum_clearance", "lap_time")
    )
    cars = (Car("robot1", driver=Driver.short_forms()[driver]),)
    wanted = dataclasses.replace(scenario(criteria=limits), cars=cars)
    run, measured = judged(tmp_path, rows(4.0)), Measured(lap_times={"robot1": [10.4]})
    found = [each(wanted, run, measured) for each in (driving.minimum_clearance, driving.lap_time)]
    assert [(each.status, each.actual, each.limit) for each in found] == [
        (status, 0.5, 0.6),
        (status, 10.4, 8.0),
    ]
    of_reference = (
        found[1].reason == "lap 1 of robot1 took 10.400 s; the limit is that of the reference planner"
    )
    assert of_reference == (status is NOT_JUDGED)
    assert driving.standstill(wanted, run, measured).status is PASSED
    assert driving.lap_time(wanted, run, Measured()).status is status


def test_one_of_something_is_no_plural():
    found = [verdict_criteria.collision, verdict_criteria.goals_in_order]
    run = decided(Verdict.SUCCESS, passes={"robot1": GoalPasses([Pose(0.0, 0.0)], 0.5, 0.8)})
    assert [each(scenario(), run, Measured()).comparison for each in found] == [
        "0 contacts, limit 0 contacts",
        "0 goals, limit 1 goal",
    ]
    expected = verdict_criteria.collision(scenario(Verdict.COLLISION), run, Measured())
    assert expected.comparison == "0 contacts, limit at least 1 contact"


def test_clearance_of_nothing():
    found = driving.minimum_clearance(
        scenario(criteria=Criteria(minimum_clearance=0.1)), decided(Verdict.ABORTED), Measured()
    )
    assert found == Criterion("minimum_clearance", FAILED, None, 0.1, "m", "nothing was recorded")


def test_two_periods_are_enough_to_slide(tmp_path):
    table = list(rows(0.05))
    for row, v_y in zip(table, (0.0, 0.05)):
        row[COLUMNS.index("v_y")] = v_y
    found = driving.lateral_acceleration(
        scenario(criteria=Criteria(lateral_acceleration=1.0)), judged(tmp_path, table), Measured()
    )
    assert found.actual == pytest.approx(2.0)


@pytest.mark.parametrize(("limit", "status"), [(0.5, PASSED), (0.499, FAILED)])
def test_localization_as_wrong_as_the_limit_is_good_enough(tmp_path, limit, status):
    measured = Measured(estimates={"robot1": Poses([1.0], [(1.0, 0.5, 0)])})
    wanted = scenario(criteria=Criteria(localization_error=limit))
    found = run_criteria.localization_error(wanted, judged(tmp_path, rows(2.0)), measured)
    assert (found.actual, found.status) == (0.5, status)


def test_localization_is_told_even_where_it_is_not_judged(tmp_path):
    measured = Measured(estimates={"robot1": Poses([1.0], [(1.0, 0.5, 0)])})
    wanted = scenario(Verdict.COLLISION, criteria=Criteria(localization_error=0.1))
    found = run_criteria.localization_error(wanted, judged(tmp_path, rows(2.0)), measured)
    assert (found.actual, found.status) == (0.5, NOT_JUDGED)


@pytest.mark.parametrize("expected", [Verdict.COLLISION, Verdict.ERROR])
@pytest.mark.parametrize(
    ("criterion", "unit", "actual"),
    [
        (driving.minimum_clearance, "m", 0.5),
        (driving.lap_time, "s", None),
        (driving.standstill, "s", 0.0),
        (run_criteria.localization_error, "m", None),
        (run_criteria.localization_yaw_error, "rad", None),
    ],
)
def test_driving_is_not_judged_where_a_failure_is_expected(tmp_path, criterion, expected, unit, actual):
    wanted = scenario(expected, criteria=Criteria(**{criterion.__name__: 0.1}))
    assert criterion(wanted, judged(tmp_path, rows(1.0)), Measured()) == Criterion(
        criterion.__name__, NOT_JUDGED, actual, 0.1, unit, "a failure is expected"
    )


def test_localization_error_is_that_of_the_worst_car_over_all_moments(tmp_path):
    estimates = {
        "robot1": Poses([1.0, 2.0], [(1, 0.3, 0), (2, -0.4, 0)]),
        "robot2": Poses([1.0], [(1.1, 0, 0)]),
        "robot3": Poses([1.0], [(9, 9, 0)]),
    }
    found = run_criteria.localization_error(
        scenario(criteria=Criteria(localization_error=1.0)),
        judged(tmp_path, rows(4.0), rows(4.0, car="robot2")),
        Measured(estimates=estimates),
    )
    assert found.actual == pytest.approx(math.sqrt((0.3**2 + 0.4**2) / 2))
    assert found.reason == "0.354 m (RMS), 0.400 m at most"


def test_localization_error_is_that_at_the_stamp_of_the_estimate_across_half_a_turn(tmp_path):
    table = list(rows(4.0))
    for row in table:
        row[COLUMNS.index("yaw")] = 3.1 if float(row[0]) < 2.0 else -3.1
    estimates = {"robot1": Poses([1.0125, 1.9875 + 0.0125 / 2], [(1.0125, 0, -3.1), (2.0, 0, 3.1)])}
    wanted = scenario(criteria=Criteria(localization_error=1.0, localization_yaw_error=1.0))
    judgement, measured = judged(tmp_path, table), Measured(estimates=estimates)
    assert run_criteria.localization_error(wanted, judgement, measured).actual < 0.01
    assert 0.03 < run_criteria.localization_yaw_error(wanted, judgement, measured).actual < 0.09


def test_odometry_drift_is_that_of_the_way_it_led_along(tmp_path):
    # It began at another place, with another heading, than the car, which drove 2 m along x.
    estimates = {"robot1": Poses([1.0, 2.0, 3.0], [(5, 5, math.pi / 2), (5, 6, 1.5), (5.03, 7.04, 1.5)])}
    wanted = scenario(criteria=Criteria(odometry_drift=0.02))
    judgement = judged(tmp_path, rows(4.0))
    found = run_criteria.odometry_drift(wanted, judgement, Measured(estimates=estimates))
    assert (found.status, found.actual) == (FAILED, pytest.approx(0.025))
    assert found.reason == "0.050 m after 2.0 m"
    silent = run_criteria.odometry_drift(wanted, judgement, Measured())
    assert (silent.status, silent.reason) == (FAILED, "no odometry (visual_odom) was heard")


@pytest.mark.parametrize(("expected", "status"), [(Verdict.SUCCESS, FAILED), (Verdict.TIMEOUT, PASSED)])
def test_verdict(expected, status):
    found = verdict_criteria.verdict(scenario(expected), decided(Verdict.TIMEOUT), Measured())
    assert found == Criterion("verdict", status, "timeout", expected.value, "", "so it was")


def test_reason():
    found = verdict_criteria.reason(scenario(reason="it was"), decided(Verdict.TIMEOUT), Measured())
    assert found == Criterion("reason", PASSED, "so it was", "'it was' in it", "", "so it was")


@pytest.mark.parametrize(
    ("failure", "said"),
    [
        (Failure("sim2d", "died", "", ()), (FAILED, "sim2d", "robot1/move_base", "", "so it was")),
        (Failure("robot1/move_base", "died", "", ()), (PASSED, *["robot1/move_base"] * 2, "", "so it was")),
        (None, (FAILED, None, "robot1/move_base", "", "so it was")),
    ],
)
def test_culprit(failure, said):
    found = verdict_criteria.culprit(
        scenario(Verdict.ERROR), decided(Verdict.ERROR, failure=failure), Measured()
    )
    assert found == Criterion("culprit", *said)


def passes(times, wanted):
    found = GoalPasses([Pose(0.0, 0.0)] * wanted, 0.5, 0.5)
    found.times = times
    return found


@pytest.mark.parametrize(
    ("expected", "passes", "said"),
    [
        (
            Verdict.SUCCESS,
            {
                "robot1": passes([1.0, 2.0], 2),
                "robot2": passes([1.0], 2),
                "robot3": passes([], 1),
            },
            (FAILED, 3, 5, "goals", "not all goals passed by robot2, robot3"),
        ),
        (
            Verdict.SUCCESS,
            {"robot1": passes([1.0], 1)},
            (PASSED, 1, 1, "goals", "all goals passed"),
        ),
        (
            Verdict.TIMEOUT,
            {"robot1": passes([], 1)},
            (NOT_JUDGED, 0, 1, "goals", "not all goals passed by robot1"),
        ),
        (Verdict.SUCCESS, {}, (NOT_JUDGED, 0, 0, "goals", "no goals to be passed")),
    ],
)
def test_goals_in_order(expected, passes, said):
    judgement = decided(Verdict.SUCCESS, passes=passes)
    assert verdict_criteria.goals_in_order(scenario(expected), judgement, Measured()) == Criterion(
        "goals_in_order", *said
    )


@pytest.mark.parametrize(
    ("expected", "contacts", "verdict", "said"),
    [
        (Verdict.SUCCESS, {}, Verdict.SUCCESS, (PASSED, 0, 0, "contacts", "nothing touched")),
        (Verdict.SUCCESS, {1.0: "Wall_1"}, Verdict.COLLISION, (FAILED, 1, 0, "contacts", "so it was")),
        (
            Verdict.COLLISION,
            {1.0: "Wall_1", 2.0: "Wall_1"},
            Verdict.COLLISION,
            (PASSED, 2, "at least 1", "contacts", "so it was"),
        ),
        (Verdict.COLLISION, {}, Verdict.TIMEOUT, (FAILED, 0, "at least 1", "contacts", "nothing touched")),
        (Verdict.ERROR, {1.0: "Wall_1"}, Verdict.COLLISION, (NOT_JUDGED, 1, 0, "contacts", "so it was")),
    ],
)
def test_collision(tmp_path, expected, contacts, verdict, said):
    judgement = decided(verdict, record(tmp_path, rows(3.0, contacts=contacts)).tracks)
    wanted = scenario(expected, criteria=Criteria(light_touch=1.0))
    assert verdict_criteria.collision(wanted, judgement, Measured()) == Criterion("collision", *said)


@pytest.mark.parametrize(
    ("expected", "verdict", "said"),
    [
        (Verdict.SUCCESS, Verdict.SUCCESS, (PASSED, "ended after 3.000 s")),
        (Verdict.SUCCESS, Verdict.TIMEOUT, (FAILED, "so it was")),
        (Verdict.TIMEOUT, Verdict.TIMEOUT, (PASSED, "so it was")),
        (Verdict.TIMEOUT, Verdict.SUCCESS, (FAILED, "ended after 3.000 s")),
        (Verdict.ERROR, Verdict.TIMEOUT, (NOT_JUDGED, "so it was")),
    ],
)
def test_timeout(expected, verdict, said):
    status, text = said
    found = verdict_criteria.timeout(scenario(expected), decided(verdict), Measured())
    assert found == Criterion("timeout", status, 3.0, 10.0, "s", text)


def test_time_at_the_end_is_told_in_whole_nanoseconds():
    judgement = Judgement(Decision(0.1 + 0.2, Verdict.SUCCESS, ""), Record({}), {})
    assert verdict_criteria.timeout(scenario(), judgement, Measured()).actual == 0.3


def test_every_criterion_stands_in_a_shipped_scenario():
    folder = lookup.package_path(lookup.PACKAGE) / "scenarios"
    texts = [yaml.safe_load(path.read_text(encoding="utf-8")) for path in folder.glob("*.yaml")]
    used = {key for text in texts for key in [*text, *text.get("criteria", {})]}
    asked = {field.name for field in dataclasses.fields(Criteria) if "tolerance" not in field.name}
    assert {*asked, "culprit", "reason"} <= used


@pytest.mark.parametrize(
    ("actual", "limit", "unit", "text"),
    [
        (0.5, 0.4, "m", "0.5 m, limit 0.4 m"),
        (0.5, 0.4, "", "0.5, limit 0.4"),
        (62.097934574, 62.09793457417457, "s", "62.098 s, limit 62.098 s"),
        (None, 20.0, "s", "none, limit 20 s"),
        ("error", "success", "", "error, limit success"),
    ],
)
def test_comparison(actual, limit, unit, text):
    assert Criterion("a", PASSED, actual, limit, unit, "").comparison == text
