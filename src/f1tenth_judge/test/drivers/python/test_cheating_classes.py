"""Whatever a class does to files and processes of its run: no lap is bought, and nothing hangs."""

import subprocess
import sys
from pathlib import Path

import psutil
import pytest
from f1tenth_judge.drivers.starting import start_drivers
from f1tenth_judge.plan.race import Race, plan_race
from f1tenth_judge.run.execute import execute
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.stop_request import StopRequest
from patience import PATIENCE
from result_schema import valid_result

CLASSES = Path(__file__).with_name("cheating_classes.py")


@pytest.fixture
def race(tmp_path):
    """Lets a planner drive for a second, and gives what is in result.json."""

    def run(name):
        folder = tmp_path / "results"
        plan = plan_race(
            Race("circuit1", 1, [Driver(python=f"{CLASSES}:{name}")]), folder, ("limits.timeout=1",)
        )
        done = execute(plan, start_drivers, StopRequest())
        assert not [each for each in psutil.process_iter() if "f1tenth_daemon" in each.cmdline()]
        assert done.judgement.decision.verdict.value != "success"
        return valid_result(folder / "result.json")

    return run


@pytest.mark.parametrize(
    ("name", "what"),
    [
        ("ReplacesTheRecord", "replaced"),
        ("OverwritesTheRecord", "overwritten"),
        ("AddsToTheRecord", "overwritten"),
        ("RemovesTheRecord", "removed"),
        ("RemovesAllFiles", "removed"),
        ("PutsAPipeThere", "removed"),
        ("PutsADeviceThere", "removed"),
        ("PutsAFolderThere", "removed"),
        ("LeavesADaemon", "overwritten"),
    ],
)
def test_class_that_touches_the_record_is_named(race, tmp_path, name, what):
    result = race(name)
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/planner")
    assert f"{tmp_path}/results/log/record.csv was {what} while the run went on" in result["reason"]


@pytest.mark.parametrize("name", ["WritesTheResult", "LinksTheResults", "PatchesItsOwnModules"])
def test_class_that_touches_what_does_not_decide_is_judged_by_the_record(race, tmp_path, name):
    (tmp_path / "victim").write_text("precious")
    result = race(name)
    assert (result["verdict"], result["culprit"]) == ("timeout", None)
    assert result["reason"].startswith("not finished after 1 s of simulated time; robot1 drove ")
    assert (tmp_path / "victim").read_text() == "precious"


def test_log_that_was_made_a_pipe_is_not_waited_for(race):
    result = race("LogsIntoAPipe")
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/planner")
    assert "ended with exit code 5" in result["reason"]


@pytest.mark.parametrize(("name", "code"), [("KillsTheJudge", -9), ("PutsAFileInPlaceOfTheFolder", 2)])
def test_run_that_ends_without_a_verdict_is_no_success(tmp_path, name, code):
    planner, results = f"{CLASSES}:{name}", str(tmp_path / "results")
    options = ["--planner", planner, "--set", "limits.timeout=1", "--results", results]
    done = subprocess.run(
        [sys.executable, "-m", "f1tenth_judge", "race", "circuit1", *options],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )
    assert done.returncode == code
    assert "Traceback" not in done.stderr
    assert not [*tmp_path.rglob("result.json")]
