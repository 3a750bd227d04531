"""Planners that are classes are raced, judged and caught without ROS."""

import zlib
from pathlib import Path

import psutil
import pytest
from f1tenth_judge.drivers.starting import start_drivers
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.plan.race import Race, plan_race
from f1tenth_judge.record.replay import Drawing, read_replay
from f1tenth_judge.run.execute import execute
from f1tenth_judge.run.stage import DriveCommand, Stage
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.stop_request import StopRequest
from result_schema import valid_result

CLASSES = Path(__file__).with_name("classes.py")


@pytest.fixture
def race(tmp_path):
    """Races planners around circuit1, and gives what is in result.json."""

    def run(*names, settings=("limits.timeout=40",), arguments=None):
        planners = [Driver(python=f"{CLASSES}:{name}", arguments=arguments or {}) for name in names]
        plan = plan_race(Race("circuit1", 1, planners), tmp_path, settings)
        execute(plan, start_drivers, StopRequest())
        assert not [each for each in psutil.process_iter() if _is_of(each, tmp_path)]
        return valid_result(tmp_path / "result.json")

    return run


def _is_of(process, folder):
    try:
        return str(CLASSES) in " ".join(process.cmdline()) and process.cwd() == str(folder)
    except psutil.Error:
        return False


@pytest.mark.parametrize("name", ["Follower", "Pursuer"])
def test_a_class_drives_a_lap_and_does_it_again(race, tmp_path, name):
    result = race(name)
    assert (result["verdict"], result["lockstep"]) == ("success", True)
    assert result["times"]["lap_time"] > 5.0
    assert all((tmp_path / name).is_file() for name in ("trajectory.csv", "trajectory.png", "replay.json.gz"))
    assert race(name)["trajectory_hash"] == result["trajectory_hash"]


def test_a_record_that_cannot_be_written_is_told_and_earlier_results_stay(race, tmp_path, monkeypatch):
    before = race("Follower", settings=["limits.timeout=0.1"])
    monkeypatch.setattr(Plan, "record_file", Path("/dev/full"))
    with pytest.raises(ScenarioError, match="/dev/full: cannot be written: No space left on device"):
        race("Follower", settings=["limits.timeout=0.1"])
    assert valid_result(tmp_path / "result.json") == before


def test_two_classes_race_each_other(race):
    result = race("Follower", "Pursuer", settings=["limits.timeout=1"])
    assert (result["verdict"], set(result["cars"])) == ("timeout", {"robot1", "robot2"})


def test_a_class_is_told_what_a_driver_is_told_and_sees_what_the_car_senses(race, tmp_path):
    race("Telling", settings=["limits.timeout=0.1"], arguments={"word": "hello"})
    assert (tmp_path / "log" / "robot1.log").read_text().splitlines() == [
        "robot1 2 hello perfect",
        "0.025 0 0 (0.0, 0.0, 0.0) (5, 3)",
        "(1081,) float32 10",
    ]


def test_a_class_sees_through_the_cameras_of_its_car_what_the_simulation_draws(race, tmp_path):
    race("Looker", settings=["limits.timeout=0.1"])
    stage = Stage(plan_race(Race("circuit1", 1, [Driver(python=f"{CLASSES}:Looker")]), tmp_path / "again"))
    for _ in range(2):
        stage.advance()
        stage.command("robot1", DriveCommand(1.0, 0.2))
    left, right = (stage.look("robot1", eye) for eye in stage.eyes("robot1"))
    assert (tmp_path / "log" / "robot1.log").read_text().splitlines() == [
        "[('stereo_camera', 'left', 672, 376), ('stereo_camera', 'right', 672, 376)]",
        f"(376, 672, 3) uint8 {zlib.crc32(left.colour)}",
        f"(376, 672) float32 {zlib.crc32(left.depth)}",
        f"{zlib.crc32(right.depth)}",
    ]


def test_what_a_class_notes_is_in_the_replay_and_its_numbers_in_the_result(race, tmp_path):
    result = race("Noting", settings=["limits.timeout=0.5"])
    (channel,) = result["cars"]["robot1"]["channels"].items()
    assert channel == ("/robot1/turn", {"least": 0.0, "greatest": 0.5, "last": 0.5})
    drawn = read_replay(tmp_path / "replay.json.gz").drawings
    assert {topic: each.values[0] for topic, each in drawn.items()} == {
        "/robot1/target": [Drawing("", [], [[1.0, 0.0, 0.05]], [[1.0, 0.0, "target"]])],
        "/robot1/way": [Drawing("", [[[0.0, 0.0], [1.0, 0.0]]], [], [[1.0, 0.0, "way"]])],
    }
    assert drawn["/robot1/way"].stamps == [0.025, 0.225, 0.425]


def test_what_a_class_has_looked_at_is_in_the_replay(race, tmp_path):
    race("Looker", settings=["limits.timeout=0.1"])
    pictures = read_replay(tmp_path / "replay.json.gz").pictures
    assert {topic: each.stamps for topic, each in pictures.items()} == {
        "/robot1/stereo_camera/left": [0.05],
        "/robot1/stereo_camera/right": [0.05],
    }


@pytest.mark.parametrize(("name", "eyes"), [("Follower", []), ("Looker", ["left", "right"])])
def test_nothing_is_drawn_that_a_class_does_not_look_at(race, monkeypatch, name, eyes):
    drawn = []
    look = Stage.look
    monkeypatch.setattr(
        Stage, "look", lambda stage, car, eye: drawn.append(eye.name) or look(stage, car, eye)
    )
    race(name, settings=["limits.timeout=0.1"])
    assert drawn == eyes


WRONG = {
    "DiesAtOnce": "ended with exit code 1; it raised ValueError: no model weights in /models",
    "Raises": "ended with exit code 1; it raised AttributeError: 'Scan' object has no attribute 'range'",
    "Exits": "ended with exit code 3",
    "Ends": "ended with exit code 1",
    "ReturnsNothing": "it raised TypeError: plan() returned None, must be Command(speed, steering_angle)",
    "SaysNan": "sends only commands that the simulator refuses (at 2 s): robot1: commanded speed (m/s) is ",
    "NeverReturns": "has not answered within 0.5 s of wall time (limits.answer)",
    "NeverIsReady": "has not answered within 1 s of wall time (limits.load)",
    "ForksAndExits": "ended with exit code 4",
    "NotesWords": "it raised TypeError: notes are {'state': 'braking'}, each must be a number, a point",
    "LooksElsewhere": "the car has no camera roof, there are: stereo_camera left, stereo_camera right",
    "LooksBack": "it raised LookupError: plan() has returned",
    "Absent": "it raised AttributeError: module 'f1tenth_planner' has no attribute 'Absent'",
}


@pytest.mark.parametrize(("name", "reason"), WRONG.items(), ids=list(WRONG))
def test_a_class_that_goes_wrong_is_named_with_the_reason(race, name, reason):
    # Short only where it is waited for: a busy machine needs its time for all others.
    patience = {"NeverReturns": ["limits.answer=0.5"], "NeverIsReady": ["limits.load=1"]}.get(name, [])
    result = race(name, settings=[*patience, "limits.timeout=5"])
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/planner")
    assert reason in result["reason"]


@pytest.mark.parametrize(
    ("planner", "settings", "problem"),
    [
        ("/nowhere/a.py:A", (), "no such file: /nowhere/a.py"),
        (
            f"{CLASSES}:Follower",
            ("localization=amcl",),
            "'localization: amcl' is for planners that are",
        ),
    ],
)
def test_what_cannot_be_run_is_refused_before_the_start(tmp_path, planner, settings, problem):
    with pytest.raises(ScenarioError, match=problem):
        plan_race(Race("circuit1", 1, [Driver(python=planner)]), tmp_path, settings)
