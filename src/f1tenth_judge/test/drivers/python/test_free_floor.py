"""The example that sees nothing but depths gets round, judged."""

from pathlib import Path

import pytest
from f1tenth_judge.drivers.starting import start_drivers
from f1tenth_judge.plan.race import Race, plan_race
from f1tenth_judge.run.execute import execute
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.stop_request import StopRequest
from result_schema import valid_result

SOURCES = Path(__file__).parents[4]
EXAMPLE = SOURCES / "f1tenth_sim2d" / "examples" / "free_floor.py"
TRACK = SOURCES.parent / "data" / "tracks" / "hand_drawn" / "hand_drawn_map.yaml"


@pytest.mark.parametrize("place", ["circuit1", str(TRACK)])
def test_it_drives_a_lap_without_a_contact(place, tmp_path):
    planner = Driver(python=f"{EXAMPLE}:FreeFloor")
    execute(plan_race(Race(place, 1, [planner]), tmp_path), start_drivers, StopRequest())
    result = valid_result(tmp_path / "result.json")
    assert (result["verdict"], result["contacts"]) == ("success", []), result["reason"]
