"""A car that is suddenly elsewhere, though nobody is noted to have put it there, has not driven there."""

import pytest
from f1tenth_judge.judge.judge import judge
from f1tenth_judge.record.interventions import Intervention
from f1tenth_judge.record.observations import Observations
from f1tenth_judge.record.row import COLUMNS
from f1tenth_judge.scenario.interventions import InterventionKind, Permission
from f1tenth_judge.scenario.scenario import Verdict
from scenario_samples import TASKS, finished, record, rows, scenario

X, YAW = COLUMNS.index("x"), COLUMNS.index("yaw")
JUMP_ROW, JUMP_STAMP = 40, 1.025  # of the row after the jump


def judgement(folder, wanted=None, way=0.0, turn=0.0, contacts=None, interventions=()):
    """Of a car that is displaced at a moment and drives on from there."""
    table = list(rows(4.0, contacts=contacts, contact_speed=0.0))
    for row in table[JUMP_ROW:]:
        row[X] += way
        row[YAW] += turn
    run = Observations(record(folder, table), (finished(3.0),), interventions=tuple(interventions))
    return judge(wanted or scenario(), TASKS, run)


@pytest.mark.parametrize(
    ("way", "turn", "said"),
    [
        (0.06, 0.0, "moved by 0.09 m and 0.00 rad within 0.025 s"),
        (-0.115, 0.0, "moved by 0.09 m and 0.00 rad within 0.025 s"),
        (0.0, 0.21, "moved by 0.03 m and 0.21 rad within 0.025 s"),
        (0.0, -0.21, "moved by 0.03 m and 0.21 rad within 0.025 s"),
    ],
)
def test_car_that_is_suddenly_elsewhere_is_disqualified(tmp_path, way, turn, said):
    found = judgement(tmp_path, way=way, turn=turn)
    assert (found.decision.verdict, found.decision.stamp) == (Verdict.DISQUALIFIED, JUMP_STAMP)
    assert found.decision.reason.startswith(f"robot1 is out: robot1 {said} at 1.025 s, as no car can")
    (event,) = found.interventions
    assert event.as_json() == {"time": JUMP_STAMP, "kind": "jump", "caller": "", "model": "robot1"}


@pytest.mark.parametrize(("way", "turn"), [(0.04, 0.0), (-0.09, 0.0), (0.0, 0.19), (0.0, 6.28)])
def test_what_a_car_may_do_within_a_period_is_no_jump(tmp_path, way, turn):
    found = judgement(tmp_path, way=way, turn=turn)
    assert found.decision.verdict is not Verdict.DISQUALIFIED
    assert found.interventions == ()


@pytest.mark.parametrize("stamp", [1.0, 1.025])
def test_jump_by_somebody_who_may_place_the_car_is_none(tmp_path, stamp):
    placed = Intervention(stamp, "set_model_state", "/helper", "robot1")
    wanted = scenario(interventions=(Permission("helper", (InterventionKind.SET_MODEL_STATE,)),))
    assert judgement(tmp_path, wanted, way=0.3, interventions=[placed]).interventions == (placed,)


@pytest.mark.parametrize("stamp", [0.975, 1.05])
def test_permission_at_another_time_accounts_for_no_jump(tmp_path, stamp):
    placed = Intervention(stamp, "set_model_state", "/helper", "robot1")
    wanted = scenario(interventions=(Permission("helper", (InterventionKind.SET_MODEL_STATE,)),))
    found = judgement(tmp_path, wanted, way=0.3, interventions=[placed])
    assert found.decision.verdict is Verdict.DISQUALIFIED


@pytest.mark.parametrize("stamp", [1.0, 1.025])
def test_what_is_pushed_out_of_another_does_not_jump(tmp_path, stamp):
    found = judgement(tmp_path, way=0.3, contacts={stamp: "Wall_1"})
    assert found.decision.verdict is Verdict.COLLISION
