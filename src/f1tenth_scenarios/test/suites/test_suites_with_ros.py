"""Suites with planners that are launch files, and those of this package."""

import json
import os
from pathlib import Path

from f1tenth_judge import cli


def test_others_are_met_without_a_touch(tmp_path, monkeypatch):
    monkeypatch.delenv("F1TENTH_DATA", raising=False)
    arguments = ["suite", "encounters", "--cases", "1", "--results", str(tmp_path)]
    assert cli.main(arguments) == 0
    (case,) = (Path(each) for each in os.listdir(tmp_path / "suite" / "encounters") if each.startswith("001"))
    result = tmp_path / "suite" / "encounters" / case / "result.json"
    assert json.loads(result.read_text())["contacts"] == []


def test_a_road_never_seen_is_driven_by_another_planner(tmp_path, capsys):
    arguments = ["suite", "roads", "--cases", "3", "--planner", "gap_follower", "--set", "model=single_track"]
    assert cli.main([*arguments, "--results", str(tmp_path)]) == 0
    assert "passed:            2 of 2" in capsys.readouterr().out
