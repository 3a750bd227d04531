"""What the planner must do, in words of our own: both as a node and as a class."""

import pytest

PLANNERS = {"node": "launch/planner.launch", "class": "my_planner.py:FollowTheGap"}


@pytest.mark.parametrize("planner", PLANNERS.values(), ids=PLANNERS)
def test_a_lap_without_drama(f1tenth, planner):
    run = f1tenth.race("circuit1", planner=planner, seed=4)
    assert run.verdict == "success"
    assert max(run.lap_times) < 25.0
    assert run.trajectory["clearance"].min() > 0.1
