"""Being lost: what amcl is told, trials from start to verdict, and the command, whose trials are made up."""

import dataclasses
import math
import sys
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
from f1tenth_scenarios.cli.exit_codes import BAD_INPUT, NOT_PASSED, PASSED
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_studies.drives.drive import Drive
from f1tenth_studies.drives.places import circuit_drives
from f1tenth_studies.lost import command
from f1tenth_studies.lost.document import document
from f1tenth_studies.lost.trial import Found, Told, Trial, find, make_trial
from f1tenth_studies.optimum.track import load_track

from f1tenth_scenarios import places

needs_localizer = pytest.mark.skipif(not find_spec("amcl_core"), reason="amcl is the original here")
DRIVE = Drive("circuit3", Path("circuit3.world"), "circuit3", 4)


def found(place, seed, told=Told.NOTHING, after=3.0, error=0.02, deviation=0.03, alike=False):
    trial = Trial(Drive(place, Path(place), place, seed), told, 10.0)
    return Found(trial, after, np.full(4, error), np.full(4, deviation), alike)


def drive_on(place):
    return next(each for each in circuit_drives("4") if each.place == place)


@needs_localizer
def test_a_car_that_is_told_the_truth_is_never_lost_and_finds_the_same_every_time():
    first, second = (find(make_trial(drive_on("circuit1"), Told.TRUTH, 2.0)) for _ in range(2))
    assert first.passed
    assert first.after == 0.0
    assert len(first.errors) == 81
    assert np.array_equal(first.errors, second.errors)
    assert np.array_equal(first.deviations, second.deviations)


@needs_localizer
@pytest.mark.parametrize("told", [Told.NEAR, Told.FAR, Told.NOTHING])
def test_a_car_that_is_told_something_wrong_or_nothing_is_found(told):
    result = find(make_trial(drive_on("circuit3"), told, 5.0))
    assert result.passed
    assert result.errors.max() <= 0.3


@needs_localizer
def test_a_car_on_another_road_than_that_of_the_map_is_not_found(monkeypatch):
    trial = make_trial(drive_on("circuit3"), Told.NOTHING, 1.0)
    other = places.map_file(drive_on("circuit5").world)
    monkeypatch.setattr("f1tenth_scenarios.places.map_file", lambda world: other)
    result = find(trial)
    assert result.after == math.inf
    assert not result.alike
    assert not result.passed


@needs_localizer
def test_where_the_walls_look_the_same_turned_around_nothing_tells_where_the_car_is():
    trials = (
        make_trial(dataclasses.replace(drive_on("circuit1"), seed=seed), Told.NOTHING, 3.0)
        for seed in range(4)
    )
    late = [each for each in map(find, trials) if not each.in_time]
    assert late
    assert all(each.alike and each.passed for each in late)


def test_told_the_truth_amcl_may_not_be_surer_than_it_is_right():
    assert found("circuit1", 0, Told.TRUTH, after=0.0, error=0.06, deviation=0.03).passed
    assert not found("circuit1", 0, Told.TRUTH, after=0.0, error=0.08, deviation=0.03).passed
    assert not found("circuit1", 0, Told.TRUTH, after=0.1).passed


def test_drives_begin_anywhere_and_before_a_bend_if_amcl_is_told_something_wrong():
    assert make_trial(DRIVE, Told.NOTHING, 1.0) == make_trial(DRIVE, Told.NOTHING, 1.0)
    begins = {
        make_trial(Drive("", Path(), "circuit3", seed), Told.NOTHING, 1.0).drive.begin for seed in range(5)
    }
    assert len(begins) == 5
    track = load_track("circuit3")[:, :2]
    for seed in range(20):
        start = make_trial(dataclasses.replace(DRIVE, seed=seed), Told.NEAR, 1.0).drive.start
        nearest = int(np.argmin(np.hypot(*(track - start[:2]).T)))
        ahead = np.roll(track, -nearest - 24, axis=0)[:2]  # 6 m
        direction = math.atan2(*(ahead[1] - ahead[0])[::-1])
        assert abs(math.remainder(direction - start[2], math.tau)) >= 0.5


def test_the_original_amcl_is_one_line(monkeypatch):
    monkeypatch.setitem(sys.modules, "amcl_core", None)
    with pytest.raises(ScenarioError, match="amcl is the original here"):
        find(Trial(DRIVE, Told.TRUTH, 1.0))


@needs_localizer
def test_a_parameter_that_the_module_does_not_know_is_named(tmp_path, monkeypatch):
    (tmp_path / "config").mkdir()
    (tmp_path / "config" / "amcl.yaml").write_text(
        "{initial_cov_xx: 0.01, initial_cov_yy: 0.01, initial_cov_aa: 0.01, save_pose_rate: -1, laser_x: 1}"
    )
    drive = drive_on("circuit1")
    ours = places.package_path
    monkeypatch.setattr(
        "f1tenth_scenarios.places.package_path",
        lambda package: tmp_path if package == "f1tenth_navigation" else ours(package),
    )
    with pytest.raises(ScenarioError, match="amcl.yaml: laser_x: amcl's Python module does not know it"):
        find(Trial(drive, Told.TRUTH, 1.0))


def test_the_document_has_a_row_per_place_and_what_amcl_was_told():
    late = found("circuit1", 1, after=math.inf)
    untold = found("circuit1", 2, after=math.inf, alike=True)
    text = document(
        [found("circuit1", 0), late, untold, found("circuit1", 0, Told.TRUTH, 0.0)], "Made by me\n"
    )
    assert "In 2 of 4 drives the car was found in time; in 1 that was impossible." in text
    assert "| circuit1 | the truth | 1 | 10 | 1 | 0 | 0.00 | none | 0.020 | 0.030 |" in text
    assert "| circuit1 | nothing | 3 | 10 | 1 | 1 | 3.00 | 1 | 0.020 | 0.030 |" in text
    assert text.index("the truth | 1") < text.index("nothing | 3")


@pytest.mark.parametrize(("after", "code"), [(3.0, PASSED), (math.inf, NOT_PASSED)])
def test_the_command_writes_the_table_and_says_what_came_of_it(tmp_path, monkeypatch, capsys, after, code):
    monkeypatch.setattr(
        command,
        "outcomes",
        lambda function, trials, jobs: [found(t.drive.place, t.drive.seed, t.told, after) for t in trials],
    )
    monkeypatch.setattr(command, "_CIRCUIT_LIMITS", {Told.NOTHING: 10.0})
    table = tmp_path / "lost.md"
    table.write_text("an earlier one\n| a |\n\nA remark.\n")
    arguments = ["--circuits", "0", "--tracks", "", "--results", str(tmp_path), "--table", str(table)]
    assert command.main(arguments) == code
    text = table.read_text()
    assert "rosrun f1tenth_studies lost --circuits 0 --tracks ''" in text
    assert text.endswith("\n\nA remark.\n")
    assert f"lost: circuit1, seed 0, told nothing: found after {after:.2f} s" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--circuits", "", "--tracks", ""], "no seeds given: nothing to drive"),
        (["--jobs", "0"], "--jobs is 0, must be at least 1"),
        (["--table", "/nowhere/lost.md"], "--table /nowhere/lost.md: there is no such folder"),
        (["--circuits", "x", "--tracks", ""], "circuits=x: must be a seed, a whole number"),
    ],
)
def test_the_command_says_what_is_wrong(tmp_path, capsys, arguments, message):
    assert command.main([*arguments, "--results", str(tmp_path)]) == BAD_INPUT
    assert f"lost: {message}" in capsys.readouterr().err
