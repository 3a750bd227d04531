"""Whatever a planner does wrong: a verdict with the culprit and its last words, and exit code 1."""

import subprocess
import sys

import pytest
from f1tenth_judge.places import lookup
from patience import PATIENCE
from result_schema import valid_result

LAUNCH = lookup.package_path(lookup.PACKAGE) / "test" / "planners" / "nodes" / "misbehaving.launch"
IN_COMPANY = LAUNCH.with_name("in_company.launch")
SIMULATED = 25.0  # s, after which it is said at the latest


@pytest.fixture
def judged(tmp_path):
    """Lets a planner go wrong; returns what its result.json says, and what was printed."""

    def run(*options, planner=LAUNCH):
        command = [
            sys.executable,
            "-m",
            "f1tenth_judge",
            "race",
            "circuit1",
            "--planner",
            str(planner),
            *options,
        ]
        done = subprocess.run(
            [*command, "--results", str(tmp_path)],
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            cwd=tmp_path,
        )
        assert done.returncode == 1, done.stdout + done.stderr
        assert "Traceback" not in done.stderr
        result = valid_result(tmp_path / "race_circuit1" / "result.json")
        assert result["times"]["finish"] <= SIMULATED
        return result, done.stdout

    return run


@pytest.mark.parametrize(
    ("how", "reason", "last_words"),
    [
        ("ends_at_once", "ended with exit code 0", ""),
        (
            "dies_at_once",
            "ended with exit code 1; it raised ValueError: no model weights",
            "ValueError: no model weights in /models",
        ),
        (
            "raises_in_callback",
            "(limits.silence); it raised AttributeError: 'LaserScan' object has no attribute 'no_such_field'",
            "lambda scan: scan.no_such_field",
        ),
        (
            "sends_elsewhere",
            "AckermannDriveStamped on /nav, which nobody hears; hears /scan, which nobody",
            "",
        ),
        ("sends_twists", "; publishes geometry_msgs/Twist on /robot1/drive; the car takes ", ""),
        ("is_silent", "has sent no command at all for 10 s", "waiting for a joystick"),
        (
            "hears_another_type",
            "; hears /map as nav_msgs/Path, but it is nav_msgs/OccupancyGrid",
            "",
        ),
        ("says_nan", "sends only commands that the simulator refuses (at ", ""),
        ("floods", " commands per second of simulated time (at ", ""),
        ("hangs_in_callback", "has not come to rest within 6 s of wall time (limits.answer)", ""),
    ],
)
def test_planner_that_goes_wrong_is_named_with_its_last_words(judged, how, reason, last_words):
    result, said = judged("--arg", f"how:={how}", "--set", "limits.answer=6")
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/planner")
    assert reason in result["reason"]
    assert last_words in "\n".join(result["culprit"]["log_lines"])
    assert last_words in said


@pytest.mark.parametrize(
    ("executable", "culprit", "words"),
    [
        ("none.py", "f1tenth_scenarios/none.py", "Cannot locate node of type [none.py]"),
        ("missing_import.py", "robot1/planner", "ModuleNotFoundError: No module named 'no_such_package'"),
    ],
)
def test_planner_that_cannot_be_started_is_named(judged, executable, culprit, words):
    result, said = judged("--arg", f"type:={executable}")
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", culprit)
    assert words in said


def test_node_with_which_everything_ends_is_named(judged):
    result, _ = judged("--arg", "how:=ends_at_once", "--arg", "required:=true")
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/planner")
    assert result["reason"].endswith('ended with exit code 0, and is required="true" in its launch file')


def test_simulator_in_the_launch_file_of_a_planner_is_refused(judged):
    other = ("--arg", "package:=gazebo_ros", "--arg", "type:=gzserver")
    result, _ = judged(*other, planner=IN_COMPANY)
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/other")
    assert "the run has a simulator, a map and a car of its own" in result["reason"]


def test_what_only_shows_something_may_be_missing_and_that_is_said(judged):
    options = ("--arg", "package:=rqt_nothing", "--arg", "type:=view", "--set", "limits.timeout=1")
    result, _ = judged(*options, planner=IN_COMPANY)
    assert result["verdict"] == "timeout"
    assert result["note"] == (
        "without what is for people only: rqt_nothing/view cannot be started: there is no package rqt_nothing"
    )


def test_planner_that_goes_by_the_wall_clock_is_run_in_real_time_and_that_is_said(judged):
    result, said = judged("--arg", "how:=goes_by_the_wall_clock")
    assert (result["verdict"], result["lockstep"]) == ("collision", False)
    note = (
        "run in real time, as the driver of robot1 does not fit lockstep: it sends commands by the wall clock"
    )
    assert f"note:              {note}, while simulated time stands still\n" in said


def test_planner_that_computes_for_long_before_its_first_command_is_waited_for(judged):
    limits = ("--set", "limits.answer=3", "--set", "limits.silence=1", "--set", "limits.timeout=2")
    result, _ = judged("--arg", "how:=compiles_in_callback", *limits)
    assert (result["verdict"], result["lockstep"], result["note"]) == ("timeout", True, "")


def test_drivers_of_two_cars_that_hear_each_other_are_no_verdict_on_either(judged):
    result, _ = judged("--arg", "how:=hears_everybody", "--planner", str(LAUNCH))
    assert result["reason"] == (
        "robot1/planner: hears /nav of robot2/planner, which drives another car: the drivers of robot1 and"
        " robot2 share this topic; name it without the leading slash"
    )
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/planner")
    assert not result["note"]
