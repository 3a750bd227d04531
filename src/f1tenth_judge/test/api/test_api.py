"""Races from Python."""

from pathlib import Path

import f1tenth
import numpy as np
import pytest
from f1tenth_judge.api.run import COLUMNS
from f1tenth_judge.errors import ScenarioError

PLANNER = Path(__file__).parents[1] / "drivers" / "python" / "classes.py"


def test_a_race_gives_the_verdict_and_what_the_car_did(tmp_path):
    races = f1tenth.Runs(tmp_path, planner=f"{PLANNER}:Follower")
    run = races.race("circuit1", seed=4, settings=["limits.timeout=2"], name="short")
    assert (run.verdict, run.passed, run.lap_times, run.contacts) == ("timeout", False, [], [])
    assert (run.result["seed"], run.folder, run.interventions) == (4, tmp_path / "short", [])
    assert run.picture.is_file()
    table = run.trajectory
    assert (table.dtype.names, len(table)) == (tuple(COLUMNS), 80)
    assert table["time"][[0, -1]].tolist() == [0.025, 2.0]
    assert 0.1 < table["clearance"].min() < table["clearance"].max() <= 5.0
    turned = np.diff(table["steering_angle"])
    assert np.allclose(table["steering_rate"], [0.0, *turned / 0.025])
    assert run.of("robot1").lap_times == []
    with pytest.raises(KeyError, match="no car 'robot2'; there are: robot1"):
        run.of("robot2")


def test_what_is_not_there_is_named(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ScenarioError, match=f"a.py:A: no such file: {tmp_path}/a.py; allowed: a launch file"):
        f1tenth.race("circuit1", planner="a.py:A")
    with pytest.raises(ScenarioError, match="no scenario 'nowhere'; there are: "):
        f1tenth.run("nowhere")
