"""What a scenario allows others to do to the running simulation, and what it does not."""

import itertools

import pytest
from f1tenth_judge.judge.interventions import driver_behind, forbidden
from f1tenth_judge.judge.judge import judge
from f1tenth_judge.record.interventions import Intervention
from f1tenth_judge.record.observations import Observations
from f1tenth_judge.scenario.interventions import InterventionKind, Permission
from f1tenth_judge.scenario.scenario import Box, Push, Verdict
from scenario_samples import TASKS, finished, record, rows, scenario

KINDS = [*(kind.value for kind in InterventionKind), "reset_simulation", "sim2d/done"]
CALLERS = ["/robot1/planner", "/planner", "/robot1", "/scenario"]


def intervention(stamp=1.0, kind="set_model_state", caller="/robot1/planner", model="robot1"):
    return Intervention(stamp, kind, caller, model)


@pytest.mark.parametrize(("kind", "caller"), [*itertools.product(KINDS, CALLERS)])
def test_whoever_does_anything_that_is_not_allowed_is_disqualified(tmp_path, kind, caller):
    seen = Observations(
        record(tmp_path, rows(4.0)), (finished(3.0),), interventions=(intervention(2.0, kind, caller),)
    )
    decision = judge(scenario(), TASKS, seen).decision
    assert (decision.verdict, decision.stamp) == (Verdict.DISQUALIFIED, 2.0)
    assert caller in decision.reason
    assert kind in decision.reason


def test_what_is_done_after_the_finish_changes_no_verdict(tmp_path):
    seen = Observations(record(tmp_path, rows(4.0)), (finished(3.0),), interventions=(intervention(3.5),))
    assert judge(scenario(), TASKS, seen).decision.verdict is Verdict.SUCCESS


def test_permission_is_for_its_node_and_its_kinds_only():
    permission = Permission(
        "robot1/helper", (InterventionKind.PAUSE_PHYSICS, InterventionKind.UNPAUSE_PHYSICS)
    )
    done = [
        intervention(kind="pause_physics", caller="/robot1/helper", model=""),
        intervention(kind="unpause_physics", caller="/robot1/planner", model=""),
        intervention(kind="set_model_state", caller="/robot1/helper"),
    ]
    assert list(forbidden(scenario(interventions=(permission,)), done)) == done[1:]


def test_each_push_of_a_box_accounts_for_one_change_of_that_box():
    pushed = Box("crate", 1.0, 1.0, movable=True, pushes=(Push(1.0, 2.0), Push(2.0, 2.0)))
    done = [intervention(model="crate", caller="/scenario") for _ in range(3)]
    assert list(forbidden(scenario(boxes=(pushed,)), [*done, intervention()])) == [done[2], intervention()]


def test_nobody_but_the_director_pushes_a_box():
    pushed = Box("crate", 1.0, 1.0, movable=True, pushes=(Push(1.0, 2.0),))
    done = [intervention(model="crate"), intervention(model="crate", caller="/scenario")]
    assert list(forbidden(scenario(boxes=(pushed,)), done)) == done[:1]


@pytest.mark.parametrize(
    ("caller", "car"), [("/robot2/planner", "robot2"), ("/robot10/planner", None), ("/teleport", None)]
)
def test_of_two_cars_the_one_whose_namespace_the_caller_has_is_out(caller, car):
    two = scenario(cars=("robot1", "robot2"))
    assert driver_behind(two, intervention(caller=caller)) == car
    assert driver_behind(scenario(), intervention(caller="/teleport")) == "robot1"
