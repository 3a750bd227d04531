"""What is measured is the worst of all cars and all moments, not the last or the first one."""

import math

import pytest
from f1tenth_judge.judge.contacts import find_contacts
from f1tenth_judge.judge.criterion import Measured, Status
from f1tenth_judge.judge.driving_criteria import (
    lateral_acceleration,
    least_clearance,
    minimum_clearance,
    slows_to,
    standstill,
)
from f1tenth_judge.judge.goal_passes import find_passes
from f1tenth_judge.judge.judge import Decision, Judgement, first_collision
from f1tenth_judge.record.row import COLUMNS
from f1tenth_judge.scenario.car import Pose
from f1tenth_judge.scenario.criteria import Criteria
from f1tenth_judge.scenario.scenario import Verdict
from scenario_samples import PERIOD, record, rows, scenario


def judged(folder, *cars):
    return Judgement(Decision(9.0, Verdict.SUCCESS, "over"), record(folder, *cars), {})


def drive(column, values, car="robot1", end=4.0):
    """A car on the x axis; values: what a column of the record holds, by stamp (s)."""
    table = list(rows(end, car=car))
    for row in table:
        row[COLUMNS.index(column)] = values(float(row[0]))
    return table


def limited(**limits):
    return scenario(criteria=Criteria(**limits))


def dip(at, depth):
    """A clearance of half a metre but for one moment."""
    return lambda time: depth if abs(time - at) < PERIOD / 2 else 0.5


@pytest.mark.parametrize("at", [PERIOD, 2.0, 4.0])
def test_clearance_is_that_of_the_closest_moment(tmp_path, at):
    assert least_clearance(judged(tmp_path, drive("clearance", dip(at, 0.1)))) == 0.1


@pytest.mark.parametrize("worse", ["robot1", "robot2"])
def test_clearance_is_that_of_the_closest_car(tmp_path, worse):
    cars = [
        drive("clearance", dip(1.0, 0.1 if car == worse else 0.3), car=car) for car in ("robot1", "robot2")
    ]
    found = minimum_clearance(limited(minimum_clearance=0.2), judged(tmp_path, *cars), Measured())
    assert (found.actual, found.status, found.reason) == (0.1, Status.FAILED, "came as close as 0.100 m")


@pytest.mark.parametrize(("yaw_rate", "expected"), [(2.0, 5.0), (-2.0, 1.0), (0.0, 3.0)])
def test_lateral_acceleration_is_that_of_sliding_and_of_turning_together(tmp_path, yaw_rate, expected):
    """Along with 1 m/s, aside ever faster by 3 m/s^2: to the left, as a turn to the left accelerates."""
    table = drive("v_y", lambda time: 3.0 * time)
    for row in table:
        row[COLUMNS.index("yaw_rate")] = yaw_rate
    found = lateral_acceleration(limited(lateral_acceleration=9.0), judged(tmp_path, table), Measured())
    assert found.actual == pytest.approx(expected)
    assert found.reason == f"robot1 reached {expected:.2f} m/s^2"


def test_lateral_acceleration_is_that_of_the_worst_car_and_moment(tmp_path):
    turning = drive("yaw_rate", lambda time: -4.0 if 1.0 < time < 2.0 else 0.0, car="robot2")
    found = lateral_acceleration(
        limited(lateral_acceleration=4.0), judged(tmp_path, rows(4.0), turning), Measured()
    )
    assert (found.actual, found.status, found.reason) == (4.0, Status.PASSED, "robot2 reached 4.00 m/s^2")


def test_a_single_period_has_no_lateral_acceleration_of_sliding(tmp_path):
    table = drive("yaw_rate", lambda time: 2.0, end=PERIOD)
    assert lateral_acceleration(
        limited(lateral_acceleration=4.0), judged(tmp_path, table), Measured()
    ).actual == pytest.approx(2.0)


def pausing(*pauses):
    """At 1 m/s but for some pauses (s, s), of which the first and last stamps are part."""
    return lambda time: 0.0 if any(begin - 1e-6 < time < end + 1e-6 for begin, end in pauses) else 1.0


@pytest.mark.parametrize(
    ("pauses", "longest"),
    [
        ([(0.5, 2.0), (3.0, 3.5)], 1.5),
        ([(0.5, 1.0), (2.0, 3.5)], 1.5),
        ([(0.5, 1.0), (2.0, 3.0), (3.5, 4.0)], 1.0),
        ([(0.0, 0.5)], 0.5 - PERIOD),
        ([(3.0, 4.0)], 1.0),
        ([], 0.0),
    ],
)
def test_standstill_is_the_longest_pause(tmp_path, pauses, longest):
    run = judged(tmp_path, drive("v_x", pausing(*pauses)))
    found = standstill(limited(standstill=1.2), run, Measured())
    assert found.actual == pytest.approx(longest)
    assert found.reason == f"robot1 stood for {longest:.3f} s"
    assert (found.status is Status.PASSED) == (longest <= 1.2)


def test_standing_before_the_start_is_no_standstill(tmp_path):
    run = judged(tmp_path, drive("v_x", pausing((0.0, 2.0))))
    assert standstill(limited(standstill=1.0), run, Measured(start=1.5)).actual == pytest.approx(0.5)


@pytest.mark.parametrize(("speed", "longest"), [(0.05, 4.0 - PERIOD), (0.051, 0.0), (-0.051, 0.0)])
def test_creeping_is_no_standstill(tmp_path, speed, longest):
    run = judged(tmp_path, drive("v_x", lambda time: speed))
    assert standstill(limited(standstill=1.0), run, Measured()).actual == pytest.approx(longest)


def test_every_car_is_to_slow_down(tmp_path):
    slow = drive("v_x", lambda time: 1.0 if time < 1.0 else 0.1)
    fast = drive("v_x", lambda time: 1.0 if time < 1.0 else 0.2, car="robot2")
    found = slows_to(limited(slows_to=0.2), judged(tmp_path, slow, fast), Measured())
    assert (found.actual, found.status, found.reason) == (
        0.2, Status.PASSED, "robot2 slowed down to 0.200 m/s",
    )  # fmt: skip


def test_contact_is_as_hard_as_the_record_says_not_as_fast_as_the_car_goes(tmp_path):
    table = list(rows(2.0, speed=2.0, contacts={1.0: "Wall_1"}, contact_speed=0.7))
    (contact,) = find_contacts(record(tmp_path, table))
    assert (contact.start, contact.speed) == (1.0, 0.7)


def test_car_that_drove_into_the_other_is_told_by_what_was_before_the_impact(tmp_path):
    hunted = list(rows(2.0, speed=0.0, contacts={1.0: "robot2"}))
    hunter = list(rows(2.0, car="robot2", speed=0.0, contacts={1.0: "robot1"}))
    for mine, theirs in zip(hunted, hunter):
        was_before = float(mine[0]) < 1.0 - PERIOD / 2
        mine[2], mine[5] = 3.0, 0.0 if was_before else -2.0
        theirs[2], theirs[5] = 1.0, 2.0 if was_before else 0.0
    (contact,) = find_contacts(record(tmp_path, hunted, hunter))
    assert contact.car == "robot2"


@pytest.mark.parametrize(("yaw", "v_x", "v_y"), [(math.pi, 1.0, 0.0), (math.pi / 2, 0.0, 1.0)])
def test_car_that_drove_into_the_other_is_told_by_its_heading_and_sliding(tmp_path, yaw, v_x, v_y):
    ours = list(rows(2.0, speed=0.0, contacts={1.0: "robot2"}))
    theirs = list(rows(2.0, car="robot2", speed=0.0, contacts={1.0: "robot1"}))
    for row in theirs:
        row[2], row[4], row[5], row[6] = 3.0, yaw, v_x, v_y
    (contact,) = find_contacts(record(tmp_path, ours, theirs))
    assert contact.car == "robot2"


def meeting(folder, *, ours=(1.0, 0.0), theirs=(0.0, 0.0), at=(3.0, 0.0), touched=("robot2", "robot1")):
    """Two cars that look along x and report each other at 1 s; velocities (m/s) and the other's place (m)."""
    first = rows(2.0, speed=0.0, contacts={1.0: touched[0]})
    second = rows(2.0, car="robot2", speed=0.0, contacts={1.0: touched[1]})
    first = [[*row[:5], *ours, *row[7:]] for row in first]
    second = [[*row[:2], *at, row[4], *theirs, *row[7:]] for row in second]
    return find_contacts(record(folder, first, second))


@pytest.mark.parametrize(
    ("how", "culprit"),
    [
        ({"ours": (1.0, 0.0), "theirs": (-0.9, 0.0)}, "robot1"),
        ({"ours": (0.9, 0.0), "theirs": (-1.0, 0.0)}, "robot2"),
        ({"ours": (0.0, 0.9), "theirs": (0.0, -1.0), "at": (0.0, 3.0)}, "robot2"),
        ({"ours": (0.0, 1.0), "theirs": (0.0, -0.9), "at": (0.0, 0.01)}, "robot1"),
        ({"ours": (1.0, 0.0), "theirs": (-1.0, 0.0)}, "robot2"),
        ({"ours": (3.0, 0.1), "theirs": (-3.0, -0.2), "at": (0.0, 3.0)}, "robot2"),
    ],
)
def test_who_came_faster_towards_the_other_is_to_blame(tmp_path, how, culprit):
    assert [each.car for each in meeting(tmp_path, **how)] == [culprit]


def test_the_other_car_is_not_to_blame_for_a_contact_that_it_does_not_report(tmp_path):
    assert [each.car for each in meeting(tmp_path, touched=("robot2", ""))] == ["robot1"]
    found = meeting(tmp_path, ours=(0.0, 0.0), theirs=(-1.0, 0.0), touched=("robot2", "robot1;Wall_1"))
    assert [(each.car, each.touched) for each in found] == [
        ("robot1", ("robot2",)), ("robot2", ("robot1", "Wall_1")),
    ]  # fmt: skip


def test_a_car_that_also_touched_a_wall_reports_for_itself(tmp_path):
    found = meeting(tmp_path, ours=(0.0, 0.0), theirs=(-1.0, 0.0), touched=("robot2;Wall_1", "robot1"))
    assert [each.car for each in found] == ["robot1", "robot2"]


@pytest.mark.parametrize("touching", [1, 2, 4])
def test_blame_is_that_of_the_period_before_the_contact_or_of_the_first(tmp_path, touching):
    stamp = touching * PERIOD
    ours = list(rows(4 * PERIOD, y=0.5, contacts={stamp: "robot2"}))
    theirs = list(rows(4 * PERIOD, y=0.5, car="robot2", contacts={stamp: "robot1"}))
    for number, (mine, other) in enumerate(zip(ours, theirs), 1):
        culprit = number == max(touching - 1, 1)
        mine[2], mine[5], other[2], other[5] = 0.0, 1.0, 3.0, -2.0 if culprit else 0.0
    (contact,) = find_contacts(record(tmp_path, ours, theirs))
    assert (contact.car, contact.y) == ("robot2", 0.5)


def test_contacts_of_two_cars_at_other_times_are_two(tmp_path):
    hunter = rows(3.0, speed=1.0, contacts={1.0: "robot2", 2.0: "robot2"})
    hunted = rows(3.0, car="robot2", speed=0.0, contacts={2.0: "robot1", 2.5: "robot1"})
    found = find_contacts(record(tmp_path, hunter, hunted))
    assert [(each.start, each.car) for each in found] == [(1.0, "robot1"), (2.0, "robot2"), (2.5, "robot2")]


@pytest.mark.parametrize(("limit", "is_collision"), [(0.99, True), (1.0, True), (1.01, False)])
def test_a_touch_as_fast_as_the_limit_is_a_collision(tmp_path, limit, is_collision):
    touching = record(tmp_path, rows(2.0, contacts={1.0: "Wall_1"}))
    assert (first_collision(limited(light_touch=limit), touching) is not None) == is_collision


@pytest.mark.parametrize(("yaw", "goal_yaw"), [(3.1, -3.1), (-3.1, 3.1), (3.1, 3.1 + 2 * math.pi)])
def test_a_goal_that_looks_the_other_way_round_the_circle_is_passed(tmp_path, yaw, goal_yaw):
    track = record(tmp_path, drive("yaw", lambda time: yaw)).tracks["robot1"]
    assert find_passes(track, [Pose(1.0, 0.0, goal_yaw)], 0.05, 0.1).complete


@pytest.mark.parametrize("goal_yaw", [0.11, -0.11, math.pi, 2 * math.pi - 0.11])
def test_a_goal_that_looks_elsewhere_is_not_passed(tmp_path, goal_yaw):
    track = record(tmp_path, rows(2.0)).tracks["robot1"]
    passes = find_passes(track, [Pose(1.0, 0.0, goal_yaw)], 0.05, 0.1)
    assert (passes.times, passes.wanted, passes.complete) == ([], 1, False)
    assert passes.nearest == pytest.approx(0.0, abs=1e-9)


def test_a_goal_is_passed_on_the_rim_of_its_tolerances_and_in_the_first_period_there(tmp_path):
    track = record(tmp_path, rows(2.0)).tracks["robot1"]
    passes = find_passes(track, [Pose(1.0, 0.0, 0.25), Pose(1.0, 0.5)], 0.5, 0.25)
    assert passes.times == [0.5, 1.0]


def test_the_next_goal_may_not_be_passed_before_the_one_before_it(tmp_path):
    track = record(tmp_path, rows(4.0)).tracks["robot1"]
    passes = find_passes(track, [Pose(2.0, 0.0), Pose(1.0, 0.0)], 0.01, 1.0)
    assert (passes.times, passes.wanted, passes.nearest) == ([2.0], 2, pytest.approx(1.0))


def test_a_car_that_drove_as_fast_as_the_limit_has_not_been_faster(tmp_path):
    slow = drive("v_x", lambda time: 0.2 if time > 1.0 else 0.1)
    fast = drive("v_x", lambda time: 0.2 if time < 1.0 else 0.5 if time < 2.0 else 0.19, car="robot2")
    found = slows_to(limited(slows_to=0.2), judged(tmp_path, slow, fast), Measured())
    assert found.reason == "robot2 slowed down to 0.190 m/s"


def test_goals_are_where_they_are_on_both_axes_and_headings(tmp_path):
    """Along y = 1 m, looking to the left by 0.5 rad, from the goal on which it starts."""
    table = [[*row[:3], 1.0, 0.5, *row[5:]] for row in rows(2.0)]
    track = record(tmp_path, table).tracks["robot1"]
    passes = find_passes(track, [Pose(PERIOD, 1.0, 0.5), Pose(1.0, 1.0, 0.6)], 0.01, 0.2)
    assert passes.times == [PERIOD, 1.0]


def test_no_goal_is_passed_without_a_record_of_the_car(tmp_path):
    track = record(tmp_path, rows(1.0)).tracks["robot1"].until(0.0)
    passes = find_passes(track, [Pose(1.0, 0.0)], 0.5, 0.5)
    assert (passes.times, passes.nearest) == ([], None)


def test_who_slides_away_from_the_other_is_not_to_blame(tmp_path):
    """Looking up by 30 degrees and sliding to its left is going back."""
    ours = [[*row[:4], math.pi / 6, 0.0, 1.0, *row[7:]] for row in rows(2.0, contacts={1.0: "robot2"})]
    theirs = [
        [*row[:2], 3.0, *row[3:5], 0.0, *row[6:]] for row in rows(2.0, car="robot2", contacts={1.0: "robot1"})
    ]
    assert [each.car for each in find_contacts(record(tmp_path, ours, theirs))] == ["robot2"]


def test_a_record_covers_a_stamp_up_to_the_first_period_that_is_not_before_it(tmp_path):
    run = record(tmp_path, rows(2.0), rows(1.0, car="robot2"))
    assert [run.covering(stamp).end for stamp in (0.5, 0.51, 1.5, 3.0)] == [
        0.5, 0.525, 1.5, 2.0,
    ]  # fmt: skip
