"""What is seen of the end of a command that was broken, and the table of it; commands are made up."""

import os
import signal
import subprocess
import sys

import pytest
from f1tenth_studies.faults import command
from f1tenth_studies.faults.catalogue import clock_of_its_own, faults
from f1tenth_studies.faults.command import BAD_INPUT, main
from f1tenth_studies.faults.interrupts import Interrupts
from f1tenth_studies.faults.table import document, problem
from f1tenth_studies.faults.victim import Ending, Victim

RESULT = {"verdict": "error", "culprit": {"culprit": "robot1/move_base"}}
# Starts a child with the name of a node that outlives it, unless it is told to wait for it.
PROGRAM = """
import json, os, pathlib, subprocess, sys
folder = pathlib.Path(sys.argv[1], "circuit1")
sleep = [sys.executable, "-c", "import time; time.sleep(60)", "__name:=move_base"]
child = subprocess.Popen(sleep, env={**os.environ, "ROS_NAMESPACE": "robot1"})
print("begun", flush=True)
if sys.argv[2] == "wait":
    child.wait()
folder.mkdir()
(folder / "result.json").write_text(json.dumps({"verdict": "error"}))
(folder / "junit.xml").touch()
(folder / "trajectory.csv").touch()
sys.exit(1)
"""


def ending(exit_code=1, seconds_after=1.5, seconds=4.0, result=RESULT, has_junit=True, said=""):
    return Ending(exit_code, seconds, seconds_after, result, has_junit, said)


@pytest.fixture
def start(tmp_path):
    (tmp_path / "program.py").write_text(PROGRAM, encoding="utf-8")
    (tmp_path / "results").mkdir()
    command = [sys.executable, str(tmp_path / "program.py"), str(tmp_path / "results")]
    return lambda how: Victim([*command, how], tmp_path / "results", tmp_path / "said")


def test_a_node_is_found_and_its_death_ends_the_command(start):
    with start("wait") as victim:
        node = victim.wait_for(lambda: victim.node("robot1/move_base"), 30.0)
        assert {victim.name_of(each) for each in victim.members()} == {"runner", "robot1/move_base"}
        node.kill()
        end = victim.end(30.0)
    assert (end.exit_code, end.result, end.has_junit, end.said) == (1, {"verdict": "error"}, True, "begun\n")
    assert end.seconds_after <= end.seconds
    assert problem(end) is None


def test_what_outlives_the_command_is_seen_and_ended(start):
    with start("leave") as victim:
        victim.process.wait()
        end = victim.end(0.2)
        assert end.seconds >= 0.2
        assert victim.members() == []


def test_a_command_can_be_given_a_clock_of_its_own(tmp_path):
    file = tmp_path / "set_back"
    program = """
import pathlib, sys, threading, time
before = time.time(), time.monotonic()
pathlib.Path(sys.argv[1]).touch()
threading.Event().wait(0.05)
print(time.time() - before[0], time.monotonic() - before[1])
"""
    command = [sys.executable, "-c", program, str(file)]
    environment = {**os.environ, **clock_of_its_own(file)}
    said = subprocess.run(command, env=environment, capture_output=True, check=True).stdout.split()
    assert float(said[0]) == pytest.approx(-3600.0, abs=30.0)
    assert 0.05 <= float(said[1]) < 30.0


def test_nothing_is_left_when_the_block_is_left(start):
    with start("wait") as victim:
        victim.wait_for(lambda: victim.node("robot1/move_base"), 30.0)
    assert victim.members() == []


def test_a_table_has_a_row_for_each_fault():
    endings = [
        ("move_base killed", ending()),
        (
            "read-only results",
            ending(
                result=None, has_junit=False, said="hello\nscenario: /tmp/x/circuit1: cannot be written\n"
            ),
        ),
        ("runner stopped", ending(exit_code=None, result={"verdict": "success"})),
    ]
    rows = document(endings, [], "faults").splitlines()[-3:]
    assert rows == [
        "| move_base killed | error | robot1/move_base | 1 | 2.5 | 1.5 | yes |",
        "| read-only results | none: cannot be written | – | 1 | 2.5 | 1.5 | no |",
        "| runner stopped | success | – | killed | 2.5 | 1.5 | yes |",
    ]


def test_a_table_of_interrupts_names_what_is_wrong():
    found = Interrupts("scenario run", [ending(exit_code=130), ending(seconds=6.2, said="Traceback")])
    assert document([], [found], "faults").splitlines()[-1] == (
        "| `scenario run` | 2 | 6.2 | a traceback, all gone only after 6.2 s, exit code 1 |"
    )


@pytest.mark.parametrize(
    ("changes", "what"),
    [
        ({}, None),
        ({"exit_code": None}, "had to be killed"),
        ({"seconds_after": 5.1}, "all gone only 5.1 s after the verdict"),
        ({"said": "Traceback (most recent call last)"}, "a traceback"),
    ],
)
def test_problems(changes, what):
    assert problem(ending(**changes)) == what


def test_every_node_is_killed_and_stopped():
    names = [each.name for each in faults(["sim2d", "robot1/move_base"])]
    assert names[:4] == [
        "sim2d killed",
        "sim2d stopped",
        "robot1/move_base killed",
        "robot1/move_base stopped",
    ]
    assert len(set(names)) == len(names)


@pytest.fixture
def broken(tmp_path, monkeypatch):
    """In the place of runs: what is broken, as it is named; `files` is the folder of all their files."""
    names = []
    files = tmp_path / "files"
    files.mkdir()

    def break_one(fault, moment, folder):
        names.append(fault.name)
        return ending()

    monkeypatch.setattr(command.tempfile, "tempdir", str(files))
    monkeypatch.setattr(command, "node_names", lambda folder: ["sim2d", "robot1/move_base"])
    monkeypatch.setattr(command, "_break", break_one)
    monkeypatch.setattr(
        command, "interrupt", lambda name, *_: names.append(name) or Interrupts(name, [ending(0)])
    )
    return names


@pytest.mark.parametrize(
    ("options", "chosen"),
    [
        (["--only", "move_base"], ["robot1/move_base killed", "robot1/move_base stopped"]),
        (["--only", "scenario r", "--moments", "2"], ["scenario run", "scenario race", "scenario report"]),
    ],
)
def test_faults_and_commands_are_chosen_by_their_names(broken, tmp_path, options, chosen):
    assert main(options) == command.PASSED
    assert broken == chosen
    assert list((tmp_path / "files").iterdir()) == []


@pytest.mark.parametrize(
    "options",
    [
        ["--only", "move_bse"],
        ["--only", "scenario run"],
        ["--only", "scenario run", "--moments", "2", "--random", "5"],
    ],
)
def test_a_choice_of_nothing_is_answered_with_what_there_is(broken, tmp_path, capsys, options):
    table = tmp_path / "faults.md"
    table.write_text("an older one", encoding="utf-8")
    assert main([*options, "--table", str(table)]) == BAD_INPUT
    error = capsys.readouterr().err
    assert error.startswith(
        f"faults: --only '{options[1]}': no fault has that in its name, there are: sim2d killed, "
    )
    assert error.endswith(
        "a subscriber that stops reading; --moments takes the commands:"
        " scenario run, scenario race, scenario sweep, scenario report\n"
    )
    assert broken == []
    assert table.read_text(encoding="utf-8") == "an older one"
    assert list((tmp_path / "files").iterdir()) == []


@pytest.mark.parametrize("option", ["--random", "--moments"])
def test_a_negative_number_is_refused(broken, capsys, option):
    assert main([option, "-1"]) == BAD_INPUT
    assert capsys.readouterr().err == f"faults: {option} is -1, must be at least 0\n"


def test_nothing_is_left_when_it_is_interrupted(broken, tmp_path, monkeypatch):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(command, "_break", interrupted)
    assert main([]) == 128 + signal.SIGINT
    assert list((tmp_path / "files").iterdir()) == []


def test_a_table_that_cannot_be_written_is_told_before_anything_is_broken(capsys):
    assert main(["--table", "/nowhere/faults.md"]) == BAD_INPUT
    assert capsys.readouterr().err == "faults: --table /nowhere/faults.md: there is no such folder\n"
