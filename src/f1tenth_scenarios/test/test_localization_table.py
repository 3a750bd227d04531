"""Laps with amcl and the table of them."""

import dataclasses
import json
import math
import subprocess

import pytest
import yaml
from f1tenth_scenarios.scenario.scenario import Localization, read_scenario
from f1tenth_scenarios.studies import localization_table as table
from f1tenth_scenarios.studies.localization_run import Run, describe, read_run
from f1tenth_scenarios.studies.race_pace import laps
from f1tenth_scenarios.studies.race_pace.cli import BAD_INPUT

GOOD = Run(True, "every goal was passed in order", (7.0, 6.2), 0.05, 0.02, 0.1, 0)


def result(error=0.05):
    return {
        "verdict": "success",
        "reason": "r",
        "cars": {"robot1": {"lap_times": [7.0, 6.0]}},
        "criteria": [
            {"name": "localization_error", "actual": error},
            {"name": "localization_yaw_error", "actual": 0.02},
        ],
        "minimum_clearance": 0.09,
        "contacts": [],
    }


def test_the_laps_are_a_scenario_with_amcl(tmp_path):
    path = tmp_path / "laps.yaml"
    path.write_text(yaml.safe_dump(describe("circuit3", 2, 5)))
    scenario = read_scenario(path)
    assert (scenario.laps, scenario.seed, scenario.localization) == (2, 5, Localization.AMCL)
    assert scenario.criteria.localization_error == 0.1


def test_a_result_is_read():
    assert read_run(result()) == Run(True, "r", (7.0, 6.0), 0.05, 0.02, 0.09, 0)


def test_an_amcl_that_was_not_heard_is_never_good_enough():
    assert read_run(result(error=None)).error == math.inf


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        ({}, ""),
        ({"success": False, "reason": "hit a wall"}, "hit a wall"),
        ({"contacts": 2}, "2 contacts, must be none"),
        ({"error": 0.11}, "error 0.110 m, must be at most 0.1 m"),
        ({"yaw_error": math.radians(3.5)}, "error 3.50 degrees, must be at most 3 degrees"),
    ],
)
def test_what_is_not_good_enough_is_said(change, problem):
    assert dataclasses.replace(GOOD, **change).problem() == problem


def test_a_row_holds_the_worst_of_its_runs():
    other = dataclasses.replace(GOOD, lap_times=(8.0,), error=0.06, contacts=1)
    assert table.make_table({"circuit1": [GOOD, other]}).splitlines()[-1] == (
        "| circuit1 | 2 | 1 | 8.000 | 0.060 | 1.15 | 0.100 | 1 |"
    )


@pytest.mark.parametrize(("error", "code"), [(0.05, table.GOOD), (0.2, table.NOT_GOOD)])
def test_laps_are_driven_written_and_judged(tmp_path, monkeypatch, capsys, error, code):
    def drive(command, **_):
        folder = tmp_path / command[4].split("/")[-1].removesuffix(".yaml")
        folder.mkdir()
        (folder / "result.json").write_text(json.dumps(result(error)))
        return subprocess.CompletedProcess(command, 0)

    monkeypatch.setattr(laps.subprocess, "run", drive)
    written = tmp_path / "table.md"
    arguments = ["circuit2", "--runs", "2", "--results", str(tmp_path), "--table", str(written)]
    assert table.main(arguments) == code
    assert "| circuit2 | 2 | 2 | 7.000 |" in written.read_text()
    assert capsys.readouterr().err.count("localization_laps: circuit2: error 0.200 m") == 2 * code


def test_a_table_that_cannot_be_written_is_bad_input(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(table, "drive", lambda *_: GOOD)
    arguments = ["circuit1", "--results", str(tmp_path), "--table", "/nowhere/table.md"]
    assert table.main(arguments) == BAD_INPUT
    assert capsys.readouterr().err == (
        "localization_laps: /nowhere/table.md: cannot be written: No such file or directory\n"
    )


def test_a_number_of_laps_that_is_none_is_refused(capsys):
    with pytest.raises(SystemExit):
        table.main(["--laps", "0"])
    assert "argument --laps: found '0', must be a whole number, at least 1" in capsys.readouterr().err
