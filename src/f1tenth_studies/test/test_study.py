"""Studies: their scenarios, what they measure and judge, and the command; runs are made up."""

import dataclasses
import importlib
import json
import math
import types

import numpy as np
import pytest
from f1tenth_scenarios.batch import jobs
from f1tenth_scenarios.places import circuits
from f1tenth_scenarios.plan.planning import make_plan
from f1tenth_scenarios.record.record import CarTrack, Record
from f1tenth_scenarios.scenario.settings import parse_variation
from f1tenth_studies.studies import localization, passing, race_pace, safety, stability
from f1tenth_studies.study import Run
from f1tenth_studies.table import table

from f1tenth_scenarios import places
from f1tenth_studies import cli

# Leaves the result that is beside it, for every run; `seed=13` fails.
PROGRAM = """
import pathlib, sys
here, arguments = pathlib.Path(__file__).parent, sys.argv[1:]
folder = pathlib.Path(arguments[arguments.index("--results") + 1]) / pathlib.Path(arguments[-1]).stem
if "seed=13" in arguments:
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
    "criteria": [
        {"name": "localization_error", "actual": 0.04},
        {"name": "localization_yaw_error", "actual": math.radians(1.5)},
    ],
}


def run(tmp_path, values=None, **changes):
    return Run(values or {"world": "circuit1"}, {**RESULT, **changes}, tmp_path)


@pytest.fixture
def program(tmp_path, monkeypatch):
    """Stands in for the command `scenario`; gives a function that says what its runs come to."""
    (tmp_path / "program.py").write_text(PROGRAM, encoding="utf-8")
    monkeypatch.setattr(jobs, "PROGRAM", ("/usr/bin/python3", str(tmp_path / "program.py")))
    return lambda **changes: (tmp_path / "result.json").write_text(json.dumps({**RESULT, **changes}))


@pytest.mark.parametrize("name", cli.STUDIES)
@pytest.mark.parametrize("world", ["circuit1", "circuit5"])
def test_the_scenario_of_a_study_is_one_on_every_circuit(name, world):
    study = importlib.import_module(f"{cli.PACKAGE}.studies.{name}").STUDY
    file = places.package_path(cli.PACKAGE) / "scenarios" / f"{study.scenario}.yaml"
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
    monkeypatch.setattr(race_pace, "_optimum_in_sight", lambda world: 5.125)
    values = {"world": "circuit1", "place": "circuit1", "model": "single_track"}
    assert table(race_pace.STUDY, [run(tmp_path, values)]).splitlines()[-1] == (
        "| circuit1 | single_track | 5.000 | 5.125 | 2 | 5.000 | 5.500 | 1.10 | 0.120 | 0 |"
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


def test_localization_shows_the_worst_of_its_runs(tmp_path):
    worse = [
        {"name": "localization_error", "actual": 0.08},
        {"name": "localization_yaw_error", "actual": None},
    ]
    runs = [run(tmp_path), run(tmp_path, criteria=worse, minimum_clearance=None, contacts=[{}])]
    assert table(localization.STUDY, runs).splitlines()[-1] == (
        "| circuit1 | 2 | 3 | 7.000 | 0.080 | inf | 0.000 | 1 |"
    )


def test_localization_is_judged_by_the_criteria_of_its_scenario(tmp_path):
    assert localization.STUDY.problem(run(tmp_path)) == ""
    assert localization.STUDY.problem(run(tmp_path, passed=False, reason="0.2 m (RMS)")) == "0.2 m (RMS)"
    assert localization.STUDY.problem(run(tmp_path, contacts=[{}])) == "1 contacts, must be none"


def ring(count=200, radius=10.0):
    angles = np.linspace(0.0, 2.0 * math.pi, count, endpoint=False)
    return np.column_stack([radius * np.cos(angles), radius * np.sin(angles), np.ones(count), np.ones(count)])


def on_ring(start, speed, periods):
    """A car on a ring of 10 m: where it starts (rad) and how far it goes in a period (rad)."""
    angles = start + speed * np.arange(periods)
    none = np.zeros(periods)
    x, y = 10.0 * np.cos(angles), 10.0 * np.sin(angles)
    return CarTrack("car", none, x, y, none, none, none, none, none, none, ("",) * periods, none, (), ())


@pytest.mark.parametrize(
    ("speeds", "turns", "passes"),
    [
        ((0.02, 0.01), 0.95, 1),
        ((0.02, 0.001), 2.9, 3),
        ((0.01, 0.01), 2.0, 0),
        ((0.01, 0.0101), 0.5, 0),
    ],
)
@pytest.mark.parametrize("track", [ring(), ring()[::-1]], ids=["along", "against"])
def test_passes_are_counted_over_laps_whatever_the_direction_of_the_track(track, speeds, turns, passes):
    periods = round(turns * 2.0 * math.pi / max(speeds))
    behind, ahead = on_ring(0.0, speeds[0], periods), on_ring(0.25, speeds[1], periods)
    assert passing.count_passes(track, behind, ahead) == passes


@pytest.mark.parametrize(
    ("change", "speed", "passes", "problem"),
    [
        ({}, "1.5", 1, ""),
        ({"verdict": "timeout", "reason": "late"}, "1.5", 1, "late"),
        ({}, "1.5", 0, "the slower car was not passed"),
        ({}, "2", 0, ""),
    ],
)
def test_a_slower_car_must_be_passed(tmp_path, monkeypatch, change, speed, passes, problem):
    monkeypatch.setattr(passing, "_passes", lambda runs: passes)
    values = {"world": "circuit1", "cars.robot2.speed_max": speed}
    assert passing.STUDY.problem(run(tmp_path, values, **change)) == problem


@pytest.mark.parametrize(
    ("speeds", "stands_after", "problem"),
    [
        ([8.0] * 8 + [4.0, 2.0, 0.0] + [0.0] * 9, 1.5, ""),
        ([8.0] * 12 + [1.0] * 8, math.inf, "the car did not come to a stand"),
        ([8.0] * 14 + [0.0] * 6, math.inf, "the car did not come to a stand"),
    ],
)
def test_safety_wants_a_standstill_while_inputs_fail(tmp_path, monkeypatch, speeds, stands_after, problem):
    none = np.zeros(20)
    time = 0.5 * np.arange(20)
    track = CarTrack(
        "robot1", time, none, none, none, np.array(speeds), none, none, none, none, ("",) * 20, none, (), ()
    )
    monkeypatch.setattr(Run, "record", types.SimpleNamespace(tracks={"robot1": track}))
    one = run(tmp_path)
    assert safety.speed_at_begin(one) == 8.0
    assert safety.stop_after(one) == stands_after
    assert safety.STUDY.problem(one) == problem
    assert safety.STUDY.problem(run(tmp_path, contacts=[{}])) == "1 contacts, must be none"


def test_safety_shows_no_speed_of_a_car_whose_run_ends_before_the_fault(tmp_path, monkeypatch):
    track = dataclasses.replace(on_ring(0.0, 0.01, 4), time=0.5 * np.arange(4))
    monkeypatch.setattr(Run, "record", Record({"robot1": track}))
    values = {"cars.robot1.input_faults": "scan", "cars.robot1.speed_max": "8"}
    one = run(tmp_path, values, verdict="collision", reason="hit a wall")
    assert table(safety.STUDY, [one]).splitlines()[-1] == "| scan | 8 | nan | inf | 0.120 | 0 |"


def test_safety_lets_each_input_and_each_pair_fail():
    variation, speeds = (parse_variation(f"{key}={values}") for key, values in safety.STUDY.vary.items())
    assert len(variation) == 12
    assert len(speeds) == 3
    file = places.package_path(cli.PACKAGE) / "scenarios" / "safety.yaml"
    faults = [make_plan(str(file), settings=[str(each)]).scenario.cars[0].input_faults for each in variation]
    assert {len(fault.inputs) for (fault,) in faults} == {1, 2}
    assert {fault.delay for (fault,) in faults} == {None, safety.DELAY}
    assert {(fault.at, fault.until) for (fault,) in faults} == {(safety.BEGIN, safety.END)}


def test_a_study_is_swept_written_and_judged(program, tmp_path, capsys):
    program()
    file = tmp_path / "table.md"
    arguments = ["localization", "--vary", "world=circuit1,circuit2", "--vary", "seed=12:13"]
    arguments += ["--set", "laps=2", "--results", str(tmp_path / "r"), "--table", str(file), "--jobs", "1"]
    assert cli.study_main(arguments) == cli.NOT_PASSED
    text, (out, err) = file.read_text(encoding="utf-8"), capsys.readouterr()
    assert text == out[:-1]
    assert text.startswith("# Localization\n")
    assert "    rosrun f1tenth_studies study localization --vary world=circuit1,circuit2 --vary" in text
    assert [line.split(" | ")[:2] for line in text.splitlines()[-2:]] == [
        ["| circuit1", "1"],
        ["| circuit2", "1"],
    ]
    assert err.count("exit code 1, no result: bad luck") == 2


def study_one_run(results, *options):
    """The command `study` of a single run; its exit code."""
    arguments = ["localization", "--vary", "world=circuit1", "--vary", "seed=4", "--results", str(results)]
    return cli.study_main([*arguments, *options])


def test_what_stands_below_the_table_stays(program, tmp_path):
    program()
    file = tmp_path / "table.md"
    file.write_text("# Old\n\n| a |\n| --- |\n| 1 |\n\nWhat we saw: | was narrow.\n", encoding="utf-8")
    study_one_run(tmp_path / "r", "--table", str(file))
    head, _, below = file.read_text(encoding="utf-8").rpartition("|\n")
    assert head.startswith("# Localization\n")
    assert below == "\nWhat we saw: | was narrow.\n"


def test_a_table_that_cannot_be_read_is_bad_input(program, tmp_path, capsys):
    program()
    file = tmp_path / "table.md"
    file.write_bytes(b"\xff")
    assert study_one_run(tmp_path / "r", "--table", str(file)) == cli.BAD_INPUT
    assert f"study: {file}: cannot be read: 'utf-8' codec" in capsys.readouterr().err


def test_a_run_that_is_not_good_enough_is_named(program, tmp_path, capsys):
    program(verdict="aborted", reason="gave up")
    assert study_one_run(tmp_path) == cli.NOT_PASSED
    assert "study localization: circuit1, 4: gave up\n" in capsys.readouterr().err


def test_a_run_that_broke_down_is_named_and_in_no_table(program, tmp_path, capsys):
    program(verdict="error", reason="sim2d: died")
    file = tmp_path / "table.md"
    file.write_text("the last one that could be made", encoding="utf-8")
    arguments = ["passing", "--vary", "world=circuit1", "--vary", "cars.robot2.speed_max=1"]
    arguments += ["--results", str(tmp_path / "r"), "--table", str(file)]
    assert cli.study_main(arguments) == cli.NOT_PASSED
    assert capsys.readouterr() == ("", "study passing: circuit1, 1: sim2d: died\n")
    assert file.read_text(encoding="utf-8") == "the last one that could be made"


def test_a_bad_value_is_bad_input(tmp_path, capsys):
    arguments = ["race_pace", "--vary", "world=circuit1", "--set", "laps=0", "--results", str(tmp_path)]
    assert cli.study_main(arguments) == cli.BAD_INPUT
    assert "study: laps=0:1: laps is 0, must be at least 1\n" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["passing", "--jobs", "0"], "--jobs is 0, must be at least 1"),
        (["passing", "--jobs", "-1"], "--jobs is -1, must be at least 1"),
        (
            ["passing", "--vary", "seed=1:3"],
            "--vary seed=1:3: is not varied by this study, allowed: world, cars.robot2.speed_max",
        ),
        (
            ["encounters", "--vary", "world=circuit1"],
            "--vary world=circuit1: is not varied by this study, allowed: encounter",
        ),
        (
            ["localization", "--vary", "seed=1", "--vary", "seed=2"],
            "--vary seed=2: is varied more than once",
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


def oval(straight=20.0, radius=3.0):
    """Two straights along x, joined by half circles: points 0.25 m apart, from the begin of a straight on."""
    line = np.arange(0.0, straight, 0.25)
    arc = np.arange(0.0, math.pi, 0.25 / radius)
    x = [line, straight + radius * np.sin(arc), straight - line, -radius * np.sin(arc)]
    y = [0.0 * line, radius - radius * np.cos(arc), 2.0 * radius + 0.0 * line, radius + radius * np.cos(arc)]
    rows = np.column_stack([np.concatenate(x), np.concatenate(y)])
    return np.column_stack([rows, np.ones((len(rows), 2))])


def driving(road, yaw_rate, v_x=None):
    """A car that drives along a road at 10 m/s, with a yaw rate in each of its points."""
    time = 0.025 * np.arange(len(road))
    none = np.zeros(len(road))
    v_x = np.full(len(road), 10.0) if v_x is None else v_x
    return CarTrack(
        "robot1",
        time,
        road[:, 0],
        road[:, 1],
        none,
        v_x,
        none,
        yaw_rate,
        none,
        none,
        ("",) * len(road),
        none,
        (),
        (),
    )


def test_weaving_counts_on_straights_only():
    road = oval()
    time = 0.025 * np.arange(len(road))
    in_bend = np.abs(road[:, 1] - 3.0) < 2.9
    assert stability.changes_of_sign(driving(road, np.sin(2.0 * np.pi * 2.5 * time)), road) == pytest.approx(
        5.0, 0.15
    )
    assert stability.changes_of_sign(driving(road, np.where(in_bend, 3.3, 0.2)), road) == 0.0
    assert stability.changes_of_sign(driving(road, 0.04 * np.sin(30.0 * time)), road) == 0.0
    # Each straight is left in another direction than it was entered, and that is no weaving of the next one.
    assert stability.changes_of_sign(driving(road, np.where(road[:, 1] > 3.0, -1.0, 1.0)), road) == 0.0
    assert stability.changes_of_sign(driving(ring(), np.sin(30.0 * 0.025 * np.arange(200))), ring()) == 0.0


@pytest.mark.parametrize(
    ("yaw_rate", "speeds", "problem"),
    [
        (0.8, (10.0, 10.0), ""),
        (0.9, (10.0, 10.0), "9.00 m/s^2 to the side, must be at most 8.25"),
        (0.0, (10.0, 9.6), "8.00 m/s^2 along the car, must be at most 7.70"),
    ],
)
def test_stability_says_what_is_not_good_enough(tmp_path, monkeypatch, yaw_rate, speeds, problem):
    road = oval()
    v_x = np.where(np.arange(len(road)) < 100, *speeds)
    found = run(tmp_path)
    track = driving(road, np.full(len(road), yaw_rate), v_x)
    monkeypatch.setattr(type(found), "record", Record({"robot1": track}))
    assert stability.STUDY.problem(found) == problem


def test_stability_is_that_of_two_circuits_and_two_tracks(tmp_path, monkeypatch):
    (tmp_path / "tracks").mkdir()
    monkeypatch.setenv("F1TENTH_DATA", str(tmp_path))
    tracks = [f"{tmp_path}/tracks/{name}/{name}_map.yaml" for name in ("Oschersleben", "Spa")]
    study = stability.STUDY
    assert study.make(study.vary, tmp_path)["world"] == ",".join(["circuit1", "circuit4", *tracks])
    assert study.make({**study.vary, "world": "circuit3"}, tmp_path)["world"] == "circuit3"
