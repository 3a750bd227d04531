"""The plain planners of the stand-in move_base drive every circuit safely, in place of the racer."""

import json
import subprocess

import pytest
from patience import PATIENCE

SLOWLY = ["--set", "cars.robot1.speed_max=2.5", "--set", "limits.timeout=120"]


@pytest.mark.parametrize("circuit", ["circuit1", "circuit2", "circuit3", "circuit4", "circuit5"])
def test_a_circuit_is_driven_without_the_racer(circuit, tmp_path):
    planner = ["--planner", "race", "--arg", "planner:=teb_local_planner"]
    command = ["rosrun", "f1tenth_scenarios", "scenario", "run", circuit, *planner, *SLOWLY]
    done = subprocess.run(
        [*command, "--results", tmp_path], capture_output=True, text=True, timeout=PATIENCE, check=False
    )
    assert done.returncode == 0, done.stdout
    result = json.loads((tmp_path / circuit / "result.json").read_text(encoding="utf-8"))
    assert result["verdict"] == "success"
    assert result["minimum_clearance"] > 0.2
