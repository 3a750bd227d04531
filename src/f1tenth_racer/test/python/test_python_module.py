"""f1tenth_racer_core: planning on arrays."""

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
    assert plan.points.shape[1] == 5
    assert plan.points[0, :3] == pytest.approx([1.0, 1.0, 0.0], abs=1e-6)
    assert plan.points[-1, :3] == pytest.approx([6.0, 3.0, 0.0], abs=1e-5)
    assert np.abs(plan.points[:, 3]).max() < 1.02 / 0.8
    assert costmap.clearance(plan.points[:, :3]).min() > 0.08
    assert not plan.reverse.any()


def test_reversing_is_an_option(costmap):
    start, goal = [4.0, 2.0, 0.0], [3.0, 2.0, 0.0]
    assert core.GlobalPlanner().plan(costmap, start, goal).reverse.any()
    forwards = core.GlobalPlanner(core.PlannerOptions(allow_reversing=False)).plan(costmap, start, goal)
    assert forwards.found
    assert not forwards.reverse.any()


def test_a_plan_that_is_not_found_has_no_points(costmap):
    plan = core.GlobalPlanner().plan(costmap, [1.0, 1.0, 0.0], [0.1, 0.1, 0.0])
    assert not plan.found
    assert len(plan.points) == 0


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda c: c.clearance([1.0, 2.0, 3.0]), "poses: found an array of shape (3,), must be (n, 3)"),
        (
            lambda c: core.GlobalPlanner().plan(c, [1.0, 1.0], [0, 0, 0]),
            "start: found an array of shape (2,), must be (3)",
        ),
        (
            lambda c: core.GlobalPlanner(core.PlannerOptions(min_turning_radius=-1.0)),
            "min_turning_radius: found -1, must be a number above 0",
        ),
        (lambda c: core.Costmap(np.zeros((1, 9), np.int8), 0.05), "map: 9 x 1 cells with 9 values"),
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
