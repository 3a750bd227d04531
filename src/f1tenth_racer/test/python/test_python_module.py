"""f1tenth_racer_core: planning and following on arrays."""

import math

import f1tenth_racer_core as core
import numpy as np
import pytest


def room(width=8.0, height=4.0, resolution=0.05):
    """A map of a room in walls."""
    cells = np.zeros((round(height / resolution), round(width / resolution)), np.int8)
    cells[[0, 1, -1, -2], :] = 100
    cells[:, [0, 1, -1, -2]] = 100
    return cells


@pytest.fixture
def costmap():
    return core.Costmap(room(), 0.05)


def test_clearance_is_that_of_the_cars_outline(costmap):
    clearance = costmap.clearance([[4.0, 2.0, 0.0], [1.0, 2.0, math.pi], [0.1, 2.0, 0.0]])
    assert clearance[0] == pytest.approx(2.0 - 0.1 - 0.155, abs=0.06)
    assert clearance[1] == pytest.approx(1.0 - 0.455 - 0.1, abs=0.06)
    assert clearance[2] < 0.0


def test_the_origin_moves_the_map():
    moved = core.Costmap(room(), 0.05, origin=(-4.0, -2.0))
    assert moved.clearance([[0.0, 0.0, 0.0]]) == pytest.approx(
        core.Costmap(room(), 0.05).clearance([[4, 2, 0]])
    )


def test_a_plan_is_a_path_that_the_car_can_drive(costmap):
    plan = core.GlobalPlanner().plan(costmap, [1.0, 1.0, 0.0], [6.0, 3.0, 0.0])
    assert plan.found
    points = plan.path.points
    assert points.shape == (len(plan.path), 5)
    assert points[0, :3] == pytest.approx([1.0, 1.0, 0.0], abs=1e-6)
    assert points[-1, :3] == pytest.approx([6.0, 3.0, 0.0], abs=1e-5)
    assert np.abs(points[:, 3]).max() < 1.02 / 0.8
    assert costmap.clearance(points[:, :3]).min() > 0.08
    assert not plan.path.reverse.any()
    assert plan.goal_s == pytest.approx(points[-1, 4])


def test_reversing_is_an_option(costmap):
    start, goal = [4.0, 2.0, 0.0], [3.0, 2.0, 0.0]
    assert core.GlobalPlanner().plan(costmap, start, goal).path.reverse.any()
    forwards = core.GlobalPlanner(core.PlannerOptions(allow_reversing=False)).plan(costmap, start, goal)
    assert forwards.found
    assert not forwards.path.reverse.any()


def test_a_race_line_passes_the_goals_beyond():
    costmap = core.Costmap(room(16.0, 8.0), 0.05)
    beyond = [8.0, 4.6, 0.7]
    line = core.RaceLineOptions(goals_beyond=[beyond])
    assert line.goals_beyond.tolist() == [beyond]
    ends = [1.0, 4.0, 0.0], [4.0, 4.0, 0.0]
    plan = core.GlobalPlanner().plan(costmap, *ends, extension_length=6.0, race_line=line)
    assert np.hypot(*(plan.path.points[:, :2] - beyond[:2]).T).min() < 0.32


def test_why_there_is_no_plan_is_said(costmap):
    plan = core.GlobalPlanner().plan(costmap, [1.0, 1.0, 0.0], [0.1, 0.1, 0.0])
    assert not plan.found
    assert plan.status == "the car would touch an obstacle at the goal"
    assert len(plan.path) == 0


def test_a_scan_shows_what_the_map_does_not_know(costmap):
    before = costmap.clearance([[4.0, 2.0, 0.0]])[0]
    scan = {"angle_min": -0.1, "angle_increment": 0.01, "range_min": 0.05, "range_max": 10.0}
    costmap.observe([2.0, 2.0, 0.0], np.full(21, 2.9), **scan)
    assert costmap.clearance([[4.0, 2.0, 0.0]])[0] < min(before, 0.6)
    costmap.forget()
    assert costmap.clearance([[4.0, 2.0, 0.0]])[0] == before


def test_the_speed_profile_keeps_the_limits(costmap):
    path = core.GlobalPlanner().plan(costmap, [1.0, 2.0, 0.0], [6.5, 2.0, 0.0]).path
    limits = core.SpeedLimits(max_vel_x=3.0, acc_lim_x=2.0, dec_lim_x=2.0)
    speeds = core.speed_profile(path, costmap, limits)
    assert speeds.shape == (len(path),)
    assert speeds.max() <= 3.0
    assert speeds[-1] == 0.0
    change = np.diff(speeds**2) / (2 * np.diff(path.points[:, 4]))
    assert np.abs(change).max() < 2.01


def test_following_a_path_leads_along_it(costmap):
    points = np.zeros((50, 5))
    points[:, 0] = points[:, 4] = 0.1 * np.arange(50)
    points[:, :2] += [1.0, 2.0]
    follower = core.PathFollower(core.FollowerOptions(limits=core.SpeedLimits(max_vel_x=2.0)))
    follower.set_path(core.Path(points, np.zeros(50, bool)), costmap)
    step = follower.step([1.5, 2.1, 0.0], 0.5, costmap, 0.05)
    assert step.lateral == pytest.approx(0.1)
    assert step.s == pytest.approx(0.5)
    assert step.curvature < 0.0
    assert 0.0 < step.speed < 0.5, "speeds up from the last command"
    assert [step.lost, step.blocked, step.stuck, step.at_end] == [False] * 4
    assert step.prediction.shape[1] == 3


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda c: c.clearance([1.0, 2.0, 3.0]), "poses: found an array of shape (3,), must be (n, 3)"),
        (
            lambda c: core.GlobalPlanner().plan(c, [1.0, 1.0], [0, 0, 0]),
            "start: found an array of shape (2,), must be (3)",
        ),
        (lambda c: core.Path(np.zeros((1, 5)), [False]), "points: found 1, must be at least 2"),
        (
            lambda c: core.Path(np.zeros((3, 5)), [False]),
            "reverse: found an array of shape (1,), must be (3)",
        ),
        (
            lambda c: core.GlobalPlanner(core.PlannerOptions(min_turning_radius=-1.0)),
            "min_turning_radius: found -1, must be a number above 0",
        ),
        (lambda c: core.Costmap(np.zeros((1, 9), np.int8), 0.05), "map: 9 x 1 cells with 9 values"),
        (
            lambda c: core.PathFollower().step([0, 0, 0], 0, c, 0.1),
            "step: there is no path; call set_path first",
        ),
    ],
)
def test_what_cannot_be_used_is_refused(costmap, call, message):
    with pytest.raises(core.Error) as raised:
        call(costmap)
    assert message in str(raised.value)
    assert isinstance(raised.value, ValueError)


def test_an_unknown_option_is_named():
    with pytest.raises(TypeError, match="unexpected option 'turning_radius' of PlannerOptions"):
        core.PlannerOptions(turning_radius=1.0)
