"""Whatever a planner does to the world: it is out, and the reason says what it did."""

import itertools

import pytest
from test_misbehaving_planners import LAUNCH, judged  # noqa: F401

CHEATING = LAUNCH.with_name("cheating.launch")
# Who does it, by the arguments of the launch file: the node that drives, one beside it, one of nobody.
CALLERS = {
    "/robot1/planner": (),
    "/robot1/helper": ("--arg", "who:=helper"),
    "/helper": ("--arg", "who:=helper", "--arg", "ns:=/"),
}
CHEATS = {
    "places_itself": "set_model_state for robot1",
    "places_itself_by_the_topic": "set_model_state for robot1",
    "moves_the_walls": "set_model_state for ",
    "stops_time_meanwhile": "pause_physics",
    "resets_the_world": "reset_world",
    "resets_everything": "reset_simulation",
    "deletes_its_car": "delete_model for robot1",
    "deletes_the_walls": "delete_model for ",
    "answers_for_another": "sim2d/done for robot1/proxy_driver",
    "puts_something_in_the_way": "spawn_urdf_model for box",
    "puts_another_thing_in_the_way": "spawn_sdf_model for box",
}


@pytest.mark.parametrize(("how", "caller"), zip(CHEATS, itertools.cycle(CALLERS)))
def test_planner_that_changes_the_world_is_disqualified(judged, how, caller):  # noqa: F811
    result, said = judged("--arg", f"how:={how}", *CALLERS[caller], planner=CHEATING)
    assert (result["verdict"], result["passed"]) == ("disqualified", False)
    assert result["reason"].startswith(f"robot1 is out: {caller} called {CHEATS[how]}")
    assert result["reason"] in said
    assert result["interventions"][0]["caller"] == caller


@pytest.mark.parametrize("caller", CALLERS)
def test_what_is_not_so_is_not_believed(judged, caller):  # noqa: F811
    lies = ("--arg", "how:=tells_lies", *CALLERS[caller], "--set", "limits.timeout=8")
    result, _ = judged(*lies, planner=CHEATING)
    assert (result["verdict"], result["culprit"]) == ("timeout", None)
    assert result["reason"].startswith("not finished after 8 s of simulated time; robot1 drove ")
    assert (result["interventions"], result["contacts"]) == ([], [])


@pytest.mark.parametrize(
    ("how", "words"),
    [
        ("removes_the_logs", "record.csv was removed"),
        ("removes_the_record", "record.csv was removed"),
        ("empties_the_record", "record.csv was "),
        ("replaces_the_record", "record.csv was replaced"),
        ("pretends_a_reset", "record.csv was replaced"),
        ("makes_the_record_a_pipe", "record.csv was removed"),
        ("makes_the_notes_a_pipe", "interventions.jsonl was removed"),
        ("makes_the_logs_pipes", "ended with exit code 6"),
        ("removes_the_note_of_what_it_does", "interventions.jsonl was removed"),
    ],
)
def test_planner_that_touches_the_evidence_is_named_at_once(judged, how, words):  # noqa: F811
    result, _ = judged("--arg", f"how:={how}", planner=CHEATING)
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/planner")
    assert words in result["reason"]


@pytest.mark.parametrize(
    ("how", "caller", "least"),
    [
        ("asks_everybody", "/robot1/planner", 20),
        ("asks_everybody", "/helper", 20),
        ("tells_everybody", "/robot1/helper", 20),
        ("tells_everybody", "/helper", 20),
        ("changes_parameters", "/robot1/helper", 10),
        ("turns_the_clock_on", "/helper", 0),
        ("writes_the_result", "/robot1/planner", 0),
        ("links_the_results", "/robot1/helper", 0),
        ("leaves_a_daemon", "/helper", 0),
        ("tells_the_time_by_another_type", "/robot1/planner", 0),
        ("tells_what_the_simulator_did", "/robot1/helper", 0),
        ("ends_the_map", "/helper", 0),
        ("ends_the_referee", "/robot1/planner", 0),
    ],
)
def test_nothing_that_anybody_may_do_buys_a_lap(judged, tmp_path, how, caller, least):  # noqa: F811
    (tmp_path / "victim").write_text("precious")
    tries = ("--arg", f"how:={how}", *CALLERS[caller], "--set", "limits.timeout=8")
    result, _ = judged(*tries, planner=CHEATING)
    assert (tmp_path / "victim").read_text() == "precious"
    assert (result["verdict"], result["passed"], result["contacts"]) == ("timeout", False, [])
    assert result["reason"].startswith("not finished after 8 s of simulated time; robot1 drove ")
    said = "".join(path.read_text() for path in (tmp_path / "race_circuit1" / "log").rglob("*stdout.log"))
    assert said.count("tries /") >= least


@pytest.mark.parametrize(
    ("how", "caller", "culprit"),
    [
        ("adds_to_the_record", "/robot1/planner", "robot1/planner"),
        ("ends_the_simulator", "/robot1/helper", "sim2d"),
        ("kills_the_simulator", "/helper", "sim2d"),
        ("stops_the_simulator", "/robot1/planner", "sim2d"),
        ("takes_the_name_of_the_simulator", "/robot1/helper", "sim2d"),
        ("takes_the_name_of_the_proxy", "/robot1/planner", "robot1/proxy_driver"),
    ],
)
def test_planner_that_harms_a_node_of_the_run_wins_nothing(judged, how, caller, culprit):  # noqa: F811
    limits = ("--set", "limits.timeout=8", "--set", "limits.wall=110")
    tries = ("--arg", f"how:={how}", *CALLERS[caller], *limits)
    result, _ = judged(*tries, planner=CHEATING)
    assert (result["verdict"], result["passed"]) == ("error", False)
    assert result["culprit"]["culprit"] == culprit


@pytest.mark.parametrize("caller", ["/robot1/planner", "/helper"])
def test_note_that_the_simulator_did_not_write_wins_nothing(judged, caller):  # noqa: F811
    result, _ = judged("--arg", "how:=adds_a_reset_that_never_was", *CALLERS[caller], planner=CHEATING)
    assert result["verdict"] in ("disqualified", "error")


def test_launch_file_that_changes_the_simulator_before_it_starts_changes_nothing(judged, tmp_path):  # noqa: F811
    """By commands, which roslaunch runs before it sets the parameters of the run."""
    sets = "rosparam set /sim2d/physics_step 0.0125; rosparam set /sim2d/seed 77; echo 1"
    text = CHEATING.read_text(encoding="utf-8").replace(
        "<launch>", f"<launch><param name='x' command='sh -c \"{sets}\"'/>"
    )
    (tmp_path / "sets.launch").write_text(text, encoding="utf-8")
    options = ("--arg", "how:=drives_on", "--set", "limits.timeout=1")
    result, _ = judged(*options, planner=tmp_path / "sets.launch")
    assert (result["verdict"], result["judged"]["physics_step"]) == ("timeout", 0.001)


def test_planner_that_moves_the_start_is_named(judged):  # noqa: F811
    """There is a countdown because the other driver waits for it."""
    result, _ = judged("--arg", "how:=starts_the_race", "--planner", "race", planner=CHEATING)
    assert result["verdict"] == "error"
    assert result["reason"].endswith("/planner: publishes /time_to_start, which is the race_starter's")


def test_planner_that_commands_the_other_car_is_named(judged):  # noqa: F811
    options = ("--arg", "how:=stops_the_other_car", "--planner", str(CHEATING))
    result, _ = judged(*options, planner=CHEATING)
    assert result["verdict"] == "error"
    car = result["culprit"]["culprit"].removesuffix("/planner")
    other = {"robot1": "robot2", "robot2": "robot1"}[car]
    assert result["reason"] == f"{car}/planner: publishes /{other}/drive, and drives another car"


def test_proxy_that_is_killed_ends_the_run_at_once(judged):  # noqa: F811
    result, _ = judged("--arg", "how:=kills_its_proxy", planner=CHEATING)
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/proxy_driver")
    assert "ended with exit code 0" in result["reason"]


def test_pace_outside_lockstep_is_not_the_planners_to_choose(judged):  # noqa: F811
    options = ("--set", "lockstep=false", "--set", "real_time_factor=2")
    result, _ = judged("--arg", "how:=changes_the_pace", *options, planner=CHEATING)
    assert result["verdict"] == "disqualified"
    assert "set_physics_properties" in result["reason"]
