"""What the simulator notes of interventions is read line by line, and told in words."""

import json

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.interventions import Intervention, Jump, read_interventions

PLACED = {"time": 1.5, "kind": "set_model_state", "caller": "/helper", "model": "robot1"}
RESET = {"time": 2.0, "kind": "reset_world", "caller": "/helper", "model": ""}


def test_complete_lines_are_read(tmp_path):
    path = tmp_path / "interventions.jsonl"
    assert read_interventions(path) == []
    path.write_text(f'{json.dumps(PLACED)}\n{json.dumps(RESET)}\n{{"time": 3', encoding="utf-8")
    assert [each.as_json() for each in read_interventions(path)] == [PLACED, RESET]


def test_line_that_is_no_note_is_refused_with_its_place(tmp_path):
    path = tmp_path / "interventions.jsonl"
    path.write_text(f"{json.dumps(PLACED)}\n[]\n", encoding="utf-8")
    with pytest.raises(ScenarioError, match=f"^{path}:2: not an intervention that the simulator noted$"):
        read_interventions(path)


def test_each_is_told_in_words():
    placed, reset = (Intervention(each.pop("time"), **each) for each in (dict(PLACED), dict(RESET)))
    assert placed.describe() == "/helper called set_model_state for robot1 at 1.500 s"
    assert reset.describe() == "/helper called reset_world at 2.000 s"
    jump = Jump(1.0, "jump", "", "robot1", way=2.5, turn=0.25, period=0.025)
    assert jump.describe() == "robot1 moved by 2.50 m and 0.25 rad within 0.025 s at 1.000 s, as no car can"
