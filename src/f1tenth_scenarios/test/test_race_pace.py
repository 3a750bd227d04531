"""The reference lap and the comparison with it."""

import dataclasses
import json
import math
import subprocess

import numpy as np
import pytest
import yaml
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.results.reference_laps import reference_laps_file
from f1tenth_scenarios.scenario.scenario import read_scenario
from f1tenth_scenarios.studies.race_pace import cli, laps
from f1tenth_scenarios.studies.race_pace.laps import Laps
from f1tenth_scenarios.studies.race_pace.limits import GRAVITY, Limits, read_limits
from f1tenth_scenarios.studies.race_pace.reference import compute_reference, write_raceline
from f1tenth_scenarios.studies.race_pace.table import Comparison, make_table
from f1tenth_scenarios.studies.race_pace.track import SPACING, load_track

LIMITS = Limits(
    friction=1.0, max_acceleration=9.0, switch_speed=7.0, max_speed=20.0, max_curvature=1.3, mass=3.7
)
GOOD = Laps("circuit1", True, "every goal was passed in order", (6.0, 6.2), 0.1, 0)


def ring(radius=5.0, half_width=0.5, count=120):
    """A circular track, counter-clockwise."""
    angle = np.arange(count) * 2 * np.pi / count
    room = np.full(count, half_width)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), room, room])


def test_the_fastest_lap_of_a_ring_is_its_inner_circle_at_the_limit_of_grip():
    lap = compute_reference(ring(), LIMITS)
    radius = 5.0 - 0.5 + LIMITS.width / 2 + LIMITS.clearance
    assert 1 / np.abs(lap.curvature) == pytest.approx(radius, rel=0.03)
    assert lap.lap_time == pytest.approx(2 * math.pi * math.sqrt(radius / GRAVITY), rel=0.02)
    assert np.all(lap.curvature > 0)
    assert math.cos(lap.yaw[0] - math.atan2(lap.y[1] - lap.y[0], lap.x[1] - lap.x[0])) > 0.99


def test_grip_is_shared_between_bends_and_braking():
    lap = compute_reference(load_track("circuit1"), LIMITS)
    across = lap.speed**2 * lap.curvature / (LIMITS.friction * GRAVITY)
    along = lap.acceleration / LIMITS.max_acceleration
    assert np.hypot(across, along).max() < 1.05
    assert np.abs(across).max() > 0.95
    assert along.min() < -0.9
    assert np.abs(lap.curvature).max() < LIMITS.max_curvature * 1.02


def test_the_laps_that_races_are_compared_with_are_those_of_today():
    shipped = yaml.safe_load(reference_laps_file().read_text(encoding="utf-8"))
    assert tuple(shipped) == (*cli.CIRCUITS, "circuit_detailed")
    # The others take a minute.
    for name in ("circuit1", "circuit_detailed"):
        lap = compute_reference(load_track(name), read_limits()).lap_time
        assert lap == pytest.approx(shipped[name], abs=0.01)


def test_lap_times_are_written(tmp_path):
    file = tmp_path / "laps.yaml"
    assert cli.reference_main(["circuit1", "--laps", str(file)]) == cli.GOOD
    assert yaml.safe_load(file.read_text(encoding="utf-8")) == {"circuit1": pytest.approx(4.497, abs=0.01)}


def test_a_road_too_narrow_is_refused():
    with pytest.raises(
        ScenarioError, match="no line keeps 0.05 m beside a car of 0.31 m: Problem not solvable"
    ):
        compute_reference(ring(half_width=0.18), LIMITS)


def test_the_limits_are_those_of_the_simulators_car():
    limits = read_limits(clearance=0.2)
    assert limits.friction == pytest.approx(1.0489)
    assert limits.max_curvature == pytest.approx(math.tan(0.4189) / 0.3302)
    assert limits.clearance == 0.2


def test_a_circuit_is_sampled_evenly_with_its_width():
    track = load_track("circuit1")
    steps = np.hypot(*np.diff(track[:, :2], axis=0, append=track[:1, :2]).T)
    assert steps == pytest.approx(SPACING, rel=0.1)
    assert track[:, 2:] == pytest.approx(1.0)


def test_an_unknown_circuit_is_answered_with_those_there_are():
    with pytest.raises(ScenarioError, match="no circuit 'monza'; there are: circuit1, circuit2"):
        load_track("monza")


def test_a_centreline_is_read_and_its_race_line_written(tmp_path):
    path = tmp_path / "ring_centerline.csv"
    np.savetxt(path, ring(), delimiter=",", header="x_m, y_m, w_tr_right_m, w_tr_left_m")
    assert cli.reference_main([str(path), "-o", str(tmp_path)]) == cli.GOOD
    written = np.loadtxt(tmp_path / "ring_raceline.csv", delimiter=";")
    assert written.shape[1] == 7
    assert np.hypot(written[:, 1], written[:, 2]) == pytest.approx(4.705, abs=0.05)
    lines = (tmp_path / "ring_raceline.csv").read_text().splitlines()
    assert lines[2] == "# s_m; x_m; y_m; psi_rad; kappa_radpm; vx_mps; ax_mps2"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (
            "1,2,3\n4,5,6\n",
            "2 rows of 3 numbers, must be at least 4 rows of x_m, y_m, w_tr_right_m, w_tr_left_m",
        ),
        ("", "0 rows of"),
        ("1,2,3,x\n", "could not convert string 'x'"),
    ],
)
def test_a_wrong_centreline_is_refused(tmp_path, content, message):
    path = tmp_path / "wrong_centerline.csv"
    path.write_text(content)
    with pytest.raises(ScenarioError, match=message):
        load_track(str(path))


def test_a_missing_centreline_is_one_line_and_bad_input(capsys):
    assert cli.reference_main(["/nowhere/x_centerline.csv"]) == cli.BAD_INPUT
    error = capsys.readouterr().err
    assert error.startswith("race_reference: /nowhere/x_centerline.csv: ")
    assert error.count("\n") == 1


def test_a_race_line_that_cannot_be_written_is_an_error():
    with pytest.raises(ScenarioError, match="/nowhere/x.csv: cannot be written: No such file"):
        write_raceline("/nowhere/x.csv", compute_reference(ring(), LIMITS), LIMITS)


def test_the_scenario_of_flying_laps_is_one(tmp_path):
    path = tmp_path / "laps.yaml"
    path.write_text(yaml.safe_dump(laps.describe("circuit3", 20)))
    scenario = read_scenario(path)
    assert scenario.laps == 21
    assert scenario.lockstep


def test_laps_are_read_without_the_one_from_the_standing_start():
    result = {
        "verdict": "success",
        "reason": "r",
        "cars": {"robot1": {"lap_times": [7.0, 6.0, 6.1]}},
        "minimum_clearance": 0.09,
        "contacts": [],
    }
    assert laps.read_laps("circuit1", result) == Laps("circuit1", True, "r", (6.0, 6.1), 0.09, 0)


def test_a_run_without_a_result_names_the_command(tmp_path, monkeypatch):
    monkeypatch.setattr(laps.subprocess, "run", lambda *_, **__: subprocess.CompletedProcess([], 7))
    with pytest.raises(ScenarioError, match="circuit1: no result; `rosrun .* ended with exit code 7"):
        laps.drive("circuit1", 2, tmp_path)


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        ({}, ""),
        ({"flying": (6.0,)}, "circuit1: 1 of 2 flying laps: every goal"),
        ({"success": False, "reason": "hit a wall"}, "circuit1: 2 of 2 flying laps: hit a wall"),
        ({"contacts": 3}, "circuit1: 3 contacts, must be none"),
        ({"flying": (6.0, 7.0)}, "circuit1: 1.400 times the reference, must be at most 1.35"),
        ({"clearance": 0.04}, "circuit1: clearance 0.040 m, must be at least 0.05 m"),
    ],
)
def test_what_is_not_good_enough_is_said(change, problem):
    comparison = Comparison(dataclasses.replace(GOOD, **change), 5.0)
    assert comparison.problem(2).startswith(problem)
    assert bool(comparison.problem(2)) == bool(problem)


def test_the_table_has_a_row_a_circuit():
    table = make_table([Comparison(GOOD, 5.0), Comparison(dataclasses.replace(GOOD, flying=()), 5.0)], LIMITS)
    rows = table.splitlines()[-2:]
    assert rows[0] == "| circuit1 | 5.000 | 2 | 6.000 | 6.200 | 1.24 | 0.100 | 0 |"
    assert "| 0 | none | none | inf |" in rows[1]


def test_the_pace_is_written_and_judged(tmp_path, monkeypatch, capsys):
    def drive(command, **_):
        result = {
            "verdict": "success",
            "reason": "r",
            "cars": {"robot1": {"lap_times": [7.0, 60.0]}},
            "minimum_clearance": 0.09,
            "contacts": [],
        }
        folder = tmp_path / "race_pace_circuit1"
        folder.mkdir()
        (folder / "result.json").write_text(json.dumps(result))
        return subprocess.CompletedProcess(command, 0)

    monkeypatch.setattr(laps.subprocess, "run", drive)
    table = tmp_path / "table.md"
    arguments = ["circuit1", "--laps", "1", "--results", str(tmp_path), "--table", str(table)]
    assert cli.pace_main(arguments) == cli.TOO_SLOW
    captured = capsys.readouterr()
    assert "| circuit1 |" in captured.out
    assert "times the reference, must be at most 1.35" in captured.err
    assert table.read_text() in captured.out


def test_no_laps_are_refused(capsys):
    with pytest.raises(SystemExit) as ended:
        cli.pace_main(["--laps", "0"])
    assert ended.value.code == cli.BAD_INPUT
    assert "--laps: found 0, must be at least 1" in capsys.readouterr().err
