"""Laps past a slower car and the table of them."""

import csv
import dataclasses
import json
import math
import subprocess

import numpy as np
import pytest
import yaml
from f1tenth_scenarios.record.record import COLUMNS, read_record
from f1tenth_scenarios.scenario.course import Course
from f1tenth_scenarios.scenario.scenario import Driver, read_scenario
from f1tenth_scenarios.studies import passing_table as table
from f1tenth_scenarios.studies.passing_run import Run, count_passes, describe
from f1tenth_scenarios.studies.race_pace import laps
from f1tenth_scenarios.studies.race_pace.cli import BAD_INPUT

GOOD = Run(1.5, True, "every goal was passed in order", (7.0, 6.2), 2, 0.12, 0)
ANGLES = np.linspace(0.0, 2.0 * math.pi, 100, endpoint=False)
RING = Course(10.0 * np.cos(ANGLES), 10.0 * np.sin(ANGLES), np.ones(100), np.ones(100))


def write_record(path, speeds, turns=1.0):
    """Cars on a ring of 10 m: robot1 starts at the angle 0, robot2 0.25 rad ahead; speeds in rad a period."""
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        for period in range(round(turns * 2.0 * math.pi / max(speeds))):
            for car, start, speed in (("robot1", 0.0, speeds[0]), ("robot2", 0.25, speeds[1])):
                angle = start + speed * period
                x, y = 10.0 * math.cos(angle), 10.0 * math.sin(angle)
                writer.writerow([0.025 * period, car, x, y, 0, 0, 0, 0, 0, 0.12, "", "00"])


def result(verdict="success"):
    return {
        "verdict": verdict,
        "reason": "r",
        "cars": {"robot1": {"lap_times": [7.0, 6.0]}},
        "contacts": [],
    }


def test_the_laps_are_a_scenario_of_two_cars(tmp_path):
    path = tmp_path / "laps.yaml"
    path.write_text(yaml.safe_dump(describe("circuit3", 1.25, 2)))
    scenario = read_scenario(path)
    assert scenario.laps == 2
    assert (scenario.cars[1].driver, scenario.cars[1].speed_max) == (Driver.PURSUIT, 1.25)


@pytest.mark.parametrize(
    ("speeds", "turns", "passes"),
    [
        ((0.02, 0.01), 0.95, 1),
        ((0.02, 0.001), 2.9, 3),
        ((0.01, 0.01), 2.0, 0),
        ((0.01, 0.0101), 0.5, 0),
    ],
)
def test_passes_are_counted_over_laps(tmp_path, speeds, turns, passes):
    write_record(tmp_path / "record.csv", speeds, turns)
    tracks = read_record(tmp_path / "record.csv").tracks
    assert count_passes(RING, tracks["robot1"], tracks["robot2"]) == passes


def test_the_direction_of_the_course_does_not_matter(tmp_path):
    write_record(tmp_path / "record.csv", (0.02, 0.001), 2.9)
    tracks = read_record(tmp_path / "record.csv").tracks
    backwards = Course(RING.x[::-1], RING.y[::-1], RING.left, RING.right)
    assert count_passes(backwards, tracks["robot1"], tracks["robot2"]) == 3


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        ({}, ""),
        ({"success": False, "reason": "hit a wall"}, "hit a wall"),
        ({"contacts": 2}, "2 contacts, must be none"),
        ({"passes": 0}, "the slower car was not passed"),
        ({"passes": 0, "speed": 2.0}, ""),
    ],
)
def test_what_is_not_good_enough_is_said(change, problem):
    assert dataclasses.replace(GOOD, **change).problem() == problem


def test_a_row_is_a_run():
    assert table.make_table({"circuit1": [GOOD]}).splitlines()[-1] == (
        "| circuit1 | 1.5 | 2 | 7.000 | 2 | 0.120 | 0 |"
    )


@pytest.mark.parametrize(("verdict", "code"), [("success", table.GOOD), ("collision", table.NOT_GOOD)])
def test_laps_are_driven_written_and_judged(tmp_path, monkeypatch, capsys, verdict, code):
    def drive(command, **_):
        folder = tmp_path / command[4].split("/")[-1].removesuffix(".yaml")
        folder.mkdir()
        (folder / "result.json").write_text(json.dumps(result(verdict)))
        write_record(folder / "trajectory.csv", (0.02, 0.01))
        return subprocess.CompletedProcess(command, 0)

    monkeypatch.setattr(laps.subprocess, "run", drive)
    written = tmp_path / "table.md"
    arguments = ["circuit2", "--speeds", "2,2.5", "--results", str(tmp_path), "--table", str(written)]
    assert table.main(arguments) == code
    assert "| circuit2 | 2.5 | 2 | 7.000 |" in written.read_text()
    assert capsys.readouterr().err.count("passing_laps: circuit2, 2.5 m/s: r\n") == code


def test_a_record_of_one_car_is_bad_input(tmp_path, monkeypatch, capsys):
    def drive(command, **_):
        folder = tmp_path / "passing_circuit2_2"
        folder.mkdir()
        (folder / "result.json").write_text(json.dumps(result()))
        return subprocess.CompletedProcess(command, 0)

    monkeypatch.setattr(laps.subprocess, "run", drive)
    assert table.main(["circuit2", "--speeds", "2", "--results", str(tmp_path)]) == BAD_INPUT
    assert capsys.readouterr().err == (
        "passing_laps: passing_circuit2_2: trajectory.csv does not tell of both cars\n"
    )


def test_a_table_that_cannot_be_written_is_bad_input(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(table, "drive", lambda *_: GOOD)
    arguments = ["circuit1", "--results", str(tmp_path), "--table", "/nowhere/table.md"]
    assert table.main(arguments) == BAD_INPUT
    assert capsys.readouterr().err == (
        "passing_laps: /nowhere/table.md: cannot be written: No such file or directory\n"
    )


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--laps", "0"], "argument --laps: found '0', must be a whole number, at least 1"),
        (["--speeds", "1,x"], "argument --speeds: found '1,x', must be speeds above 0 and at most 20 m/s"),
        (["--speeds", "0"], "argument --speeds: found '0', must be speeds above 0 and at most 20 m/s"),
    ],
)
def test_options_that_cannot_be_are_refused(capsys, arguments, message):
    with pytest.raises(SystemExit):
        table.main(arguments)
    assert message in capsys.readouterr().err
