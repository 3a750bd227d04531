"""Studies: their scenarios, what they measure and judge, and the command; runs are made up."""

import importlib
import json
import math

import numpy as np
import pytest
from f1tenth_judge.places import lookup
from f1tenth_judge.places.lookup import circuits
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.record.record import CarTrack, Record
from f1tenth_judge.scenario.settings import parse_variation
from f1tenth_scenarios.batch import jobs
from f1tenth_studies.studies import race_pace, safety
from f1tenth_studies.study import Run
from f1tenth_studies.table import table

from f1tenth_studies import cli

# Leaves the result that is beside it, for every run; those with tyres that slide fail.
PROGRAM = """
import pathlib, sys
here, arguments = pathlib.Path(__file__).parent, sys.argv[1:]
folder = pathlib.Path(arguments[arguments.index("--results") + 1]) / pathlib.Path(arguments[-1]).stem
if "model=single_track_drift" in arguments:
    sys.exit("bad luck")
folder.mkdir(parents=True)
(folder / "result.json").write_text((here / "result.json").read_text())
"""
RESULT = {
    "verdict": "success",
    "passed": True,
    "reason": "every goal was passed in order",
    "cars": {"robot1": {"lap_times": [7.0, 5.0, 5.5]}},
    "minimum_clearance": 0.12,
    "contacts": [],
}


def run(tmp_path, values=None, **changes):
    return Run(values or {"world": "circuit1"}, {**RESULT, **changes}, tmp_path)


@pytest.fixture
def program(tmp_path, monkeypatch):
    """Stands in for the command `scenario`; gives a function that says what its runs come to."""
    (tmp_path / "program.py").write_text(PROGRAM, encoding="utf-8")
    monkeypatch.setattr(jobs, "PROGRAM", ("/usr/bin/python3", str(tmp_path / "program.py")))
    monkeypatch.setattr(race_pace, "_optimum", lambda world: 4.497)
    return lambda **changes: (tmp_path / "result.json").write_text(json.dumps({**RESULT, **changes}))


@pytest.mark.parametrize("name", cli.STUDIES)
@pytest.mark.parametrize("world", ["circuit1", "circuit5"])
def test_the_scenario_of_a_study_is_one_on_every_circuit(name, world):
    study = importlib.import_module(f"{cli.PACKAGE}.studies.{name}").STUDY
    file = lookup.package_path(cli.PACKAGE) / "scenarios" / f"{study.scenario}.yaml"
    plan = make_plan(str(file), settings=[f"world={world}"])
    assert plan.goals_file("robot1").stem == world
    assert all(car.line.stem == world for car in plan.cars.values() if car.line)


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        ({}, ""),
        ({"cars": {"robot1": {"lap_times": [7.0]}}}, "no flying lap"),
        ({"verdict": "collision", "reason": "hit a wall"}, "hit a wall"),
        ({"contacts": [{}, {}]}, "2 contacts, must be none"),
        (
            {"cars": {"robot1": {"lap_times": [7.0, 5.0, 6.296]}}},
            "1.400 times the optimum, must be at most 1.35",
        ),
        ({"minimum_clearance": 0.04}, "clearance 0.040 m, must be at least 0.05 m"),
    ],
)
def test_race_pace_says_what_is_not_good_enough(tmp_path, monkeypatch, change, problem):
    monkeypatch.setattr(race_pace, "_optimum", lambda world: 4.497)
    assert race_pace.STUDY.problem(run(tmp_path, **change)) == problem


def test_race_pace_counts_laps_but_the_standing_one(tmp_path, monkeypatch):
    monkeypatch.setattr(race_pace, "_optimum", lambda world: 5.0)
    values = {"world": "circuit1", "place": "circuit1", "model": "single_track"}
    assert table(race_pace.STUDY, [run(tmp_path, values)]).splitlines()[-1] == (
        "| circuit1 | single_track | 5.000 | 2 | 5.000 | 5.500 | 1.10 | 0.120 | 0 |"
    )
    none = run(tmp_path, values, cars={"robot1": {"lap_times": []}})
    assert "| 0 | inf | inf | inf |" in table(race_pace.STUDY, [none])


def test_race_pace_is_that_of_circuits_and_of_others_tracks(tmp_path, monkeypatch):
    spa = tmp_path / "tracks" / "Spa" / "Spa_map.yaml"
    spa.parent.mkdir(parents=True)
    spa.touch()
    monkeypatch.setenv("F1TENTH_DATA", str(tmp_path))
    study = race_pace.STUDY
    worlds = study.make(study.vary, tmp_path)["world"].split(",")
    assert worlds == [*circuits(), str(spa)]
    assert [study.about({"world": world})["place"] for world in worlds] == [*circuits(), "Spa"]
    assert study.make({**study.vary, "world": "circuit3"}, tmp_path)["world"] == "circuit3"


def track_of(speeds):
    """A car's record, half a second per entry."""
    none = np.zeros(len(speeds))
    time, v_x = 0.5 * np.arange(len(speeds)), np.array(speeds)
    return CarTrack(
        "robot1", time, none, none, none, v_x, none, none, none, none, ("",) * len(speeds), none, (), ()
    )


@pytest.mark.parametrize(
    ("speeds", "stands_after", "problem"),
    [
        ([8.0] * 8 + [4.0, 2.0, 0.0] + [0.0] * 9, 1.5, ""),
        ([8.0] * 12 + [1.0] * 8, math.inf, "the car did not come to a stand"),
        ([8.0] * 14 + [0.0] * 6, math.inf, "the car did not come to a stand"),
    ],
)
def test_safety_wants_a_standstill_while_inputs_fail(tmp_path, monkeypatch, speeds, stands_after, problem):
    monkeypatch.setattr(Run, "record", Record({"robot1": track_of(speeds)}))
    one = run(tmp_path)
    assert safety.speed_at_begin(one) == 8.0
    assert safety.stop_after(one) == stands_after
    assert safety.STUDY.problem(one) == problem
    assert safety.STUDY.problem(run(tmp_path, contacts=[{}])) == "1 contacts, must be none"


def test_safety_shows_no_speed_of_a_car_whose_run_ends_before_the_fault(tmp_path, monkeypatch):
    monkeypatch.setattr(Run, "record", Record({"robot1": track_of([8.0] * 4)}))
    values = {"cars.robot1.input_faults": "scan", "cars.robot1.speed_max": "8"}
    one = run(tmp_path, values, verdict="collision", reason="hit a wall")
    assert table(safety.STUDY, [one]).splitlines()[-1] == "| scan | 8 | nan | inf | 0.120 | 0 |"


def test_safety_lets_each_input_and_each_pair_fail():
    variation, speeds = (parse_variation(f"{key}={values}") for key, values in safety.STUDY.vary.items())
    assert len(variation) == 12
    assert len(speeds) == 3
    file = lookup.package_path(cli.PACKAGE) / "scenarios" / "safety.yaml"
    faults = [make_plan(str(file), settings=[str(each)]).scenario.cars[0].input_faults for each in variation]
    assert {len(fault.inputs) for (fault,) in faults} == {1, 2}
    assert {fault.delay for (fault,) in faults} == {None, safety.DELAY}
    assert {(fault.at, fault.until) for (fault,) in faults} == {(safety.BEGIN, safety.END)}


def test_a_study_is_swept_written_and_judged(program, tmp_path, capsys):
    program()
    file = tmp_path / "table.md"
    arguments = ["race_pace", "--vary", "world=circuit1", "--set", "laps=2", "--jobs", "1"]
    arguments += ["--results", str(tmp_path / "r"), "--table", str(file)]
    assert cli.study_main(arguments) == cli.NOT_PASSED
    text, (out, err) = file.read_text(encoding="utf-8"), capsys.readouterr()
    assert text == out[:-1]
    assert text.startswith("# Race pace\n")
    assert "    rosrun f1tenth_studies study race_pace --vary world=circuit1 --set laps=2 --table" in text
    assert text.splitlines()[-1].startswith("| circuit1 | single_track | 4.497 | 2 |")
    assert err.count("exit code 1, no result: bad luck") == 1


def study_one_run(results, *options):
    """The command `study` of a single run; its exit code."""
    arguments = ["race_pace", "--vary", "world=circuit1", "--vary", "model=single_track"]
    return cli.study_main([*arguments, "--results", str(results), *options])


def test_a_run_that_is_not_good_enough_is_named(program, tmp_path, capsys):
    program(verdict="aborted", reason="gave up")
    assert study_one_run(tmp_path) == cli.NOT_PASSED
    assert "study race_pace: circuit1, single_track: gave up\n" in capsys.readouterr().err


def test_a_run_that_broke_down_is_named_and_in_no_table(program, tmp_path, capsys):
    program(verdict="error", reason="sim2d: died")
    file = tmp_path / "table.md"
    file.write_text("the last one that could be made", encoding="utf-8")
    assert study_one_run(tmp_path / "r", "--table", str(file)) == cli.NOT_PASSED
    assert capsys.readouterr() == ("", "study race_pace: circuit1, single_track: sim2d: died\n")
    assert file.read_text(encoding="utf-8") == "the last one that could be made"


def test_a_bad_value_is_bad_input(tmp_path, capsys):
    arguments = ["race_pace", "--vary", "world=circuit1", "--set", "laps=0", "--results", str(tmp_path)]
    assert cli.study_main(arguments) == cli.BAD_INPUT
    assert "study: laps=0:1: laps is 0, must be at least 1\n" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["race_pace", "--jobs", "0"], "--jobs is 0, must be at least 1"),
        (
            ["race_pace", "--vary", "seed=1:3"],
            "--vary seed=1:3: is not varied by this study, allowed: world, model",
        ),
        (
            ["encounters", "--vary", "world=circuit1"],
            "--vary world=circuit1: is not varied by this study, allowed: encounter",
        ),
        (
            ["race_pace", "--vary", "model=a", "--vary", "model=b"],
            "--vary model=b: is varied more than once",
        ),
        (["tracks", "--set", "laps=1"], "--set laps=1: is what this study varies, by track, laps, model"),
        (
            ["tracks", "--set", "world=circuit1"],
            "--set world=circuit1: is what this study varies, by track, laps, model",
        ),
        (["tracks", "--vary", "track"], "'track' must be KEY=VALUE, as in mu=0.3"),
    ],
)
def test_an_option_that_cannot_be_followed_is_refused_before_anything_runs(
    program, tmp_path, capsys, arguments, problem
):
    program()
    assert cli.study_main([*arguments, "--results", str(tmp_path / "r")]) == cli.BAD_INPUT
    assert capsys.readouterr().err == f"study: {problem}\n"
    assert not (tmp_path / "r").exists()


def test_a_table_that_cannot_be_written_is_bad_input(program, tmp_path, capsys):
    program()
    assert study_one_run(tmp_path, "--table", "/nowhere/t.md") == cli.BAD_INPUT
    assert "study: --table /nowhere/t.md: there is no such folder" in capsys.readouterr().err
    assert study_one_run(tmp_path, "--table", str(tmp_path)) == cli.BAD_INPUT
    assert f"study: {tmp_path}: cannot be written: Is a directory" in capsys.readouterr().err
