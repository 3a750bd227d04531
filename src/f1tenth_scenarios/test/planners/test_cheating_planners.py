"""Whatever a planner does to the world: it is out, and the reason says what it did."""

import pytest
from test_misbehaving_planners import judged  # noqa: F401

CHEATS = {
    "places_itself": "set_model_state for robot1",
    "places_itself_by_the_topic": "set_model_state for robot1",
    "moves_the_walls": "set_model_state for ",
    "stops_time_meanwhile": "pause_physics",
    "resets_the_world": "reset_world",
    "resets_everything": "reset_simulation",
    "deletes_its_car": "delete_model for robot1",
    "deletes_the_walls": "delete_model for ",
    "puts_something_in_the_way": "spawn_urdf_model for box",
}


@pytest.mark.parametrize("how", CHEATS)
def test_planner_that_changes_the_world_is_disqualified(judged, how):  # noqa: F811
    result, said = judged("--arg", f"how:={how}", "--arg", "type:=cheating.py")
    assert (result["verdict"], result["passed"]) == ("disqualified", False)
    assert result["reason"].startswith(f"robot1 is out: /robot1/planner called {CHEATS[how]}")
    assert result["reason"] in said
    assert result["interventions"][0]["caller"] == "/robot1/planner"


@pytest.mark.parametrize(
    ("how", "words"),
    [
        ("removes_the_logs", "record.csv was removed"),
        ("removes_the_record", "record.csv was removed"),
        ("empties_the_record", "record.csv was "),
        ("removes_the_note_of_what_it_does", "interventions.jsonl was removed"),
    ],
)
def test_planner_that_touches_the_evidence_is_named_at_once(judged, how, words):  # noqa: F811
    result, _ = judged("--arg", f"how:={how}", "--arg", "type:=cheating.py")
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/planner")
    assert words in result["reason"]


def test_proxy_that_is_killed_ends_the_run_at_once(judged):  # noqa: F811
    result, _ = judged("--arg", "how:=kills_its_proxy", "--arg", "type:=cheating.py")
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/deputy")
    assert "ended with exit code 0" in result["reason"]


def test_pace_outside_lockstep_is_not_the_planners_to_choose(judged):  # noqa: F811
    options = ("--arg", "how:=changes_the_pace", "--arg", "type:=cheating.py")
    result, _ = judged(*options, "--set", "lockstep=false", "--set", "real_time_factor=2")
    assert result["verdict"] == "disqualified"
    assert "set_physics_properties" in result["reason"]
