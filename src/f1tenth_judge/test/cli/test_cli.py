"""The command `scenario`."""

import argparse
import io
import os
import re
import subprocess
import sys

import pytest
from f1tenth_judge.cli.parser import make_parser
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.results.console import ProgressLine, cost_of_all
from f1tenth_judge.scenario.describe import describe_keys
from f1tenth_judge.scenario.scenario import Scenario
from patience import PATIENCE
from scenario_samples import SCENARIO_TEXT

from f1tenth_judge import cli


class Terminal(io.StringIO):
    def isatty(self):
        return True


def test_list_names_every_scenario_with_verdict_and_description(capsys):
    assert cli.main(["list"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == lookup.scenario_names()
    (line,) = (line for line in lines if line.startswith("into_the_wall"))
    assert re.fullmatch(r"into_the_wall +collision +A car that is driven into a wall .*", line)


def test_keys_prints_the_schema(capsys):
    assert cli.main(["keys"]) == 0
    assert capsys.readouterr().out == describe_keys(Scenario) + "\n"


def test_check_of_a_good_file(capsys):
    assert cli.main(["check", "circuit1"]) == 0
    assert capsys.readouterr().out == "circuit1: ok\n"


def test_a_file_may_end_with_yml(capsys, tmp_path):
    file = tmp_path / "sample.yml"
    file.write_text(SCENARIO_TEXT, encoding="utf-8")
    assert cli.main(["check", str(file)]) == 0
    assert capsys.readouterr().out == "sample: ok\n"


def test_check_answers_every_bad_file(capsys, tmp_path):
    colour, world = tmp_path / "colour.yaml", tmp_path / "world.yaml"
    colour.write_text(SCENARIO_TEXT + "colour: red\n", encoding="utf-8")
    world.write_text(SCENARIO_TEXT.replace("world: circuit1", "world: circuit9"), encoding="utf-8")
    assert cli.main(["check", str(colour), "circuit1", str(world)]) == 2
    out, err = capsys.readouterr()
    assert out == "circuit1: ok\n"
    first, second = err.splitlines()
    assert first.startswith(f"{colour}:10: unknown key 'colour'; allowed: description, world, ")
    assert re.fullmatch(rf"{world}: no world 'circuit9'; there are: circuit1, circuit2, .*", second)


@pytest.mark.parametrize("command", ["run", "check"])
def test_unknown_scenario_is_answered_with_the_known_ones(capsys, command):
    assert cli.main([command, "nowhere"]) == 2
    err = capsys.readouterr().err
    names = "blocked_road, boxes_on_the_road, circuit1, circuit1_drift, circuit1_three_laps"
    assert f"no scenario 'nowhere'; there are: {names}" in err


def test_nothing_runs_if_one_of_several_is_unknown(capsys):
    assert cli.main(["run", "circuit1", "nowhere"]) == 2
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize(
    ("old", "new", "answer"),
    [
        ("world: circuit1", "world: there/my.world", "no such file: {folder}/there/my.world"),
        ("goals: circuit1", "goals: ./my.txt", "no such file: {folder}/my.txt"),
        ("goals: circuit1", "goals: bad.txt", "{folder}/bad.txt:1: "),
        (
            "world: circuit1",
            "world: my.world",
            "robot1: the driver 'race' needs a map, and there is none beside the world or in ../maps",
        ),
    ],
)
def test_files_beside_the_scenario_are_looked_up(tmp_path, old, new, answer):
    (tmp_path / "my.world").write_text("<sdf/>", encoding="utf-8")
    (tmp_path / "bad.txt").write_text("1 2\n", encoding="utf-8")
    path = tmp_path / "sample.yaml"
    path.write_text(SCENARIO_TEXT.replace(old, new), encoding="utf-8")
    with pytest.raises(ScenarioError, match=re.escape(f"{path}: " + answer.format(folder=tmp_path))):
        make_plan(str(path))


def test_results_go_where_the_environment_says(monkeypatch, tmp_path):
    (tmp_path / "here").mkdir()
    monkeypatch.setenv("F1TENTH_RESULTS", str(tmp_path))
    assert make_plan("circuit1").folder == tmp_path / "circuit1"
    monkeypatch.delenv("F1TENTH_RESULTS")
    monkeypatch.chdir(tmp_path / "here")
    assert make_plan("circuit1").folder == tmp_path / "here" / "results" / "circuit1"


def test_costs_of_many_runs_are_summed_up():
    costs = {"circuit1": 2.96, "two_cars": 3.94, "goal_ahead": 2.5}
    assert cost_of_all(costs) == "cost besides simulating: median 3.0 s, at most 3.9 s (two_cars)"


def test_progress_is_drawn_on_a_terminal():
    terminal = Terminal()
    line = ProgressLine("sample", terminal)
    line.update(None, 1.0)
    line.clear()
    assert terminal.getvalue() == "\r\033[Ksample  starting  1 s\r\033[K"


def test_progress_shows_the_real_time_factor_since_the_first_period(monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr("f1tenth_judge.results.console._REDRAW_INTERVAL", 0.0)
    line = ProgressLine("sample", terminal)
    line.update(1.0, 5.0)
    line.update(21.0, 6.0)
    assert terminal.getvalue().endswith("sample  21.0 s simulated  20.0x real time")


def test_progress_is_silent_elsewhere():
    stream = io.StringIO()
    line = ProgressLine("sample", stream)
    line.update(1.0, 1.0)
    line.clear()
    assert stream.getvalue() == ""


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["race", "circuit1", "--laps", "0"], "LAPS is 0, must be at least 1"),
        (["run", "circuit1", "--interface", "f1tenth"], "INTERFACE is for a PLANNER"),
        (["race", "circuit1", "--planner", "my.launch"], "PLANNER=my.launch: no such file"),
    ],
)
def test_who_typed_make_is_answered_in_its_words(monkeypatch, capsys, arguments, answer):
    monkeypatch.setenv("F1TENTH_TYPED", "make")
    assert cli.main(arguments) == 2
    assert answer in capsys.readouterr().err


def test_watch_is_the_option_of_the_command_that_follows(capsys):
    assert cli.main(["watch", "run", "circuit1", "--repeat", "2"]) == 2
    assert "--watch is not for --repeat" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["sweep", "circuit1", "--vary", "seed=1:2", "--workers", "0"], "--jobs is 0, must be at least 1"),
        (
            ["sweep", "circuit1", "--vary", "seed=1:2", "--scheduler", "here"],
            "--scheduler here: must be an address, as in tcp://host:8786",
        ),
        (["report", "--against", "{folder}/none"], "--against {folder}/none: no such folder"),
        (["run", "circuit1", "--arg", "speed:=1"], "--arg is for a --planner"),
        (["race", "circuit1", "--arg", "speed:=1"], "--arg is for a --planner"),
        (["run", "circuit1", "--interface", "f1tenth"], "--interface is for a --planner"),
        (["race", "circuit1", "--interface", "f1tenth"], "--interface is for a --planner"),
        (
            ["race", "circuit1", "--ros2", "x", "--interface", "f1tenth"],
            "--interface is for a --planner; with --ros2 the topics are those of f1tenth_gym_ros",
        ),
        (
            ["run", "circuit1", "--ros2", "x", "--planner", "race"],
            "--ros2 is given beside --planner; one planner drives in all scenarios",
        ),
        (["run", "circuit1", "--repeat", "2", "--report"], "--report is not for --repeat"),
        (
            ["run", "circuit1", "circuit2", "circuit1"],
            "'circuit1' and 'circuit1' would both be written to {folder}/circuit1",
        ),
        (
            ["run", "{folder}/a/own.yaml", "{folder}/b/own.yml"],
            "'{folder}/a/own.yaml' and '{folder}/b/own.yml' would both be written to {folder}/own",
        ),
        (["race", "circuit1", "--timeout", "0"], "race:12: limits.timeout is 0, must be above 0 s"),
        (
            ["race", "circuit1", "--save", "{folder}/none/race.yaml"],
            "{folder}/none/race.yaml: cannot be written: No such file or directory",
        ),
    ],
)
def test_option_that_cannot_be_used_is_named(capsys, tmp_path, arguments, answer):
    texts = [each.format(folder=tmp_path) for each in arguments]
    assert cli.main([*texts, "--results", str(tmp_path)]) == 2
    assert capsys.readouterr().err == f"f1tenth: {answer.format(folder=tmp_path)}\n"


@pytest.mark.parametrize("arguments", [["--path", "{}/none", "list"], ["list", "--path", "{}/none"]])
def test_search_path_that_is_not_there_is_bad_input(capsys, tmp_path, arguments):
    with pytest.raises(SystemExit, match="2"):
        cli.main([each.format(tmp_path) for each in arguments])
    assert f"argument --path: {tmp_path}/none: no such folder\n" in capsys.readouterr().err


@pytest.mark.parametrize(("error", "code"), [(KeyboardInterrupt, 130), (BrokenPipeError, 141)])
def test_end_from_outside_is_no_traceback(monkeypatch, error, code):
    def stop(_name):
        raise error

    monkeypatch.setattr("f1tenth_judge.cli.show_commands.read_scenario", stop)
    monkeypatch.setattr(os, "dup2", lambda *_: None)
    assert cli.main(["list"]) == code


def test_who_is_told_to_stop_waits_for_nothing_that_still_goes_on():
    program = """
import threading, time
from f1tenth_judge.cli.exit_codes import leave
threading.Thread(target=time.sleep, args=(1e5,)).start()
print("said")
leave(130)
"""
    ended = subprocess.run(
        [sys.executable, "-c", program], stdout=subprocess.PIPE, text=True, timeout=PATIENCE
    )
    assert (ended.returncode, ended.stdout) == (130, "said\n")


def subcommands():
    parser = make_parser("f1tenth")
    return next(each for each in parser._actions if isinstance(each, argparse._SubParsersAction)).choices


DRIVE = ("run", "race", "sweep", "suite", "league")
DRIVING = {
    "--planner": "LAUNCH", "--ros2": "COMMAND", "--interface": None, "--arg": "NAME:=VALUE",
    "--set": "KEY=VALUE", "--seeds": "A:B", "--repeat": "N", "--jobs": "N",
    "--bag": None, "--watch": None, "--results": "FOLDER",
}  # fmt: skip


def test_every_command_is_known_to_drive_or_not_to():
    watched = {"watch", "verify"}  # the words of another command; a run of a result again, as it was
    show = {"list", "keys", "check", "compare", "report", "export", "reference"}
    assert set(subcommands()) == {*DRIVE, *watched, *show}


@pytest.mark.parametrize("option", DRIVING)
@pytest.mark.parametrize("command", DRIVE)
def test_options_of_driving_are_the_same_in_every_command(command, option):
    action = subcommands()[command]._option_string_actions[option]
    assert action.metavar == DRIVING[option]
    others = {subcommands()[each]._option_string_actions[option].dest for each in DRIVE}
    assert others == {action.dest}


@pytest.mark.parametrize("option", ["--set", "--seeds", "--repeat", "--bag", "--watch"])
def test_the_same_is_said_of_an_option_everywhere(option):
    assert len({subcommands()[each]._option_string_actions[option].help for each in DRIVE}) == 1


@pytest.mark.parametrize("command", [each for each in DRIVE if each != "league"])
@pytest.mark.parametrize(
    ("options", "answer"),
    [
        (["--jobs", "0"], "--jobs is 0, must be at least 1"),
        (["--repeat", "1"], "at least 2"),
        (["--planner", "none.launch"], "--planner none.launch: no such file: "),
        (["--seeds", "a"], "--seeds a: found 'a', must be a seed, a whole number"),
        (["--set", "colour=red"], "unknown key 'colour'"),
        (["--arg", "a:=1"], "--arg is for a --planner"),
    ],
)
def test_an_option_that_is_wrong_is_answered_by_every_command(capsys, tmp_path, command, options, answer):
    what = {"sweep": ["circuit3", "--vary", "mu=1"], "suite": ["pace", "--cases", "circuit1"]}
    arguments = [command, *what.get(command, ["circuit3"]), *options, "--results", str(tmp_path)]
    assert cli.main(arguments) == 2
    assert answer in capsys.readouterr().err
