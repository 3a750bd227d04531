"""Maps: what is driven, drives from start to verdict, and the command, for which drives are made up."""

import os
import signal
import subprocess
import sys
import time
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
from f1tenth_gazebo.errors import MapError
from f1tenth_gazebo.maps.map_alignment import Alignment
from f1tenth_gazebo.maps.map_check import MapCheck
from f1tenth_scenarios.cli.exit_codes import BAD_INPUT, NOT_PASSED, PASSED
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.places import circuits
from f1tenth_studies.drives.drive import Drive
from f1tenth_studies.drives.places import circuit_drives, road_drives, track_drives
from f1tenth_studies.mapping import command
from f1tenth_studies.mapping.document import document
from f1tenth_studies.mapping.drive import Mapped, map_drive

from f1tenth_scenarios import places

SCRIPT = Path(__file__).resolve().parents[1] / "scripts" / "maps"
needs_mapper = pytest.mark.skipif(not find_spec("gmapping_core"), reason="gmapping is the original here")
DATA = Path(os.environ.get("F1TENTH_DATA", places.workspace_root().parent / "shared" / "data"))
CLEAR, DOUBLED = MapCheck(1.0, 0.99, 0.1, 0.1), MapCheck(0.99, 0.96, 0.4, 0.1)
TURNED = Alignment(0.0, 0.0, -0.0013)


def mapped(place, seed, check=CLEAR, shape=CLEAR):
    drive = Drive(place, Path(place), place, seed)
    return Mapped(drive, 101.3, check, TURNED, shape, np.array([0.03, 0.04]))


def _leave_a_file(drive):
    if drive.place == "nowhere":
        raise ScenarioError(str(drive.world))
    time.sleep(0.5)  # as a drive does, it takes longer than hearing of the one before
    drive.world.touch()


def _killed(drive):
    os.kill(os.getpid(), signal.SIGKILL)


@pytest.fixture
def drives(monkeypatch):
    """In the place of drives: those that end well, all but seed 13."""

    def made_up(drives, jobs):
        return [mapped(each.place, each.seed, DOUBLED if each.seed == 13 else CLEAR) for each in drives]

    monkeypatch.setattr(command, "_mapped", made_up)


@needs_mapper
def test_a_lap_of_a_circuit_makes_a_good_map_the_same_every_time():
    first, second = (map_drive(next(circuit_drives("4"))) for _ in range(2))
    assert first.drive.place == "circuit1"
    assert first.drive.seed == 4
    assert first.passed
    assert first.lap == pytest.approx(30.4, abs=0.5)
    assert first.error < 0.03
    assert np.array_equal(first.errors, second.errors)
    assert (first.check, first.shape) == (second.check, second.shape)
    assert abs(first.lies.turn) < 0.002
    assert first.has_shape


@needs_mapper
def test_a_drive_without_a_lap_is_a_bad_map(monkeypatch):
    monkeypatch.setattr("f1tenth_studies.mapping.drive._TIME_LIMIT", 3.0)
    result = map_drive(next(circuit_drives("0")))
    assert not result.passed
    assert result.problem.startswith("no lap is complete after 3 s")


@needs_mapper
@pytest.mark.skipif(not DATA.is_dir(), reason=f"no {DATA}")
def test_a_drive_may_begin_in_any_direction(tmp_path, monkeypatch):
    monkeypatch.setenv("F1TENTH_DATA", str(DATA))
    monkeypatch.setattr("f1tenth_studies.mapping.drive._TIME_LIMIT", 3.0)
    drive = next(each for each in track_drives("0", tmp_path) if each.place == "Spa")
    assert map_drive(drive).error < 0.05


@needs_mapper
def test_a_map_with_nothing_to_compare_names_its_drive(monkeypatch):
    def refuse(*_):
        raise MapError("the map has no wall cell")

    monkeypatch.setattr("f1tenth_studies.mapping.drive.check_map", refuse)
    monkeypatch.setattr("f1tenth_studies.mapping.drive._TIME_LIMIT", 3.0)
    with pytest.raises(ScenarioError, match="^circuit1, seed 0: the map has no wall cell$"):
        map_drive(next(circuit_drives("0")))


@needs_mapper
def test_parameters_that_the_module_does_not_know_are_refused(tmp_path, monkeypatch):
    monkeypatch.setattr("f1tenth_scenarios.places.package_path", lambda package: tmp_path)
    (tmp_path / "config").mkdir()
    (tmp_path / "config" / "slam_gmapping.yaml").write_text("particles: 3")
    with pytest.raises(ScenarioError, match="particles: the mapper's Python module does not know it"):
        map_drive(Drive("nowhere", tmp_path, "circuit1", 0))


def test_the_original_mapper_is_one_line(monkeypatch):
    monkeypatch.setitem(sys.modules, "gmapping_core", None)
    with pytest.raises(ScenarioError, match="gmapping is the original here"):
        map_drive(Drive("circuit1", Path("circuit1.world"), "circuit1", 0))


def test_every_circuit_is_driven_with_every_seed():
    found = [(each.place, each.seed) for each in circuit_drives("0:1")]
    assert found == [(name, seed) for name in circuits() for seed in (0, 1)]


@pytest.mark.skipif(not DATA.is_dir(), reason=f"no {DATA}")
def test_tracks_are_driven_in_both_directions(tmp_path, monkeypatch):
    monkeypatch.setenv("F1TENTH_DATA", str(DATA))
    found = [each for each in track_drives("7", tmp_path) if "Spa" in each.place]
    assert [each.place for each in found] == ["Spa", "Spa_reverse"]
    assert {each.seed for each in found} == {7}
    assert all(each.world.parent == tmp_path for each in found)


def test_a_road_is_driven_with_its_own_seed(tmp_path):
    (drive,) = road_drives("3", tmp_path)
    assert (drive.place, drive.seed) == ("road 3", 3)
    assert drive.world.is_file()
    assert Path(drive.centreline).is_file()


def test_a_seed_must_be_a_number(tmp_path):
    with pytest.raises(ScenarioError, match="roads=many: must be a seed, a whole number"):
        list(road_drives("many", tmp_path))


def test_the_document_has_the_worst_of_each_place():
    drives = [mapped("circuit1", 0), mapped("circuit1", 1, DOUBLED), mapped("Spa", 0, DOUBLED, DOUBLED)]
    text = document(drives, "Made by me\n")
    assert "1 of 3 drives are good enough, 2 in their shape." in text
    assert "| circuit1 | 101 | 2 | 1 | 99.0 | 96.0 | 0.035 | 1 | 1.3 | 2 | 100.0 | 99.0 |" in text
    assert "| Spa | 101 | 1 | 0 | 99.0 | 96.0 | 0.035 | 0 | 1.3 | 0 | 99.0 | 96.0 |" in text


def test_the_command_writes_the_table_and_keeps_what_is_below(tmp_path, drives, capsys):
    table = tmp_path / "maps.md"
    table.write_text("an earlier one\n| a |\n\nA remark.\n")
    arguments = ["--circuits", "0", "--tracks", "", "--roads", "", "--results", str(tmp_path)]
    assert command.main([*arguments, "--table", str(table)]) == PASSED
    text = table.read_text()
    assert "rosrun f1tenth_studies maps --circuits 0 --tracks '' --roads ''" in text
    assert "| circuit1 |" in text
    assert text.endswith("\n\nA remark.\n")
    assert "an earlier one" not in text
    assert "| circuit1 |" in capsys.readouterr().out


def test_a_bad_map_is_an_exit_code(tmp_path, drives):
    arguments = ["--circuits", "13", "--tracks", "", "--roads", "", "--results", str(tmp_path)]
    assert command.main(arguments) == NOT_PASSED


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--circuits", "", "--tracks", "", "--roads", ""], "no seeds given: nothing to drive"),
        (["--jobs", "0"], "--jobs is 0, must be at least 1"),
        (["--table", "/nowhere/maps.md"], "--table /nowhere/maps.md: there is no such folder"),
        (["--circuits", "x", "--tracks", "", "--roads", ""], "circuits=x: must be a seed, a whole number"),
    ],
)
def test_the_command_says_what_is_wrong(tmp_path, capsys, arguments, message):
    assert command.main([*arguments, "--results", str(tmp_path)]) == BAD_INPUT
    assert f"maps: {message}" in capsys.readouterr().err


def test_a_drive_whose_process_is_killed_is_one_line(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(command, "map_drive", _killed)
    arguments = ["--circuits", "0", "--tracks", "", "--roads", "", "--results", str(tmp_path)]
    assert command.main(arguments) == BAD_INPUT
    assert capsys.readouterr().err.startswith("maps: the process of a drive was killed")


@needs_mapper
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_the_command_at_once(tmp_path, number):
    arguments = ["--tracks", "", "--roads", "", "--results", str(tmp_path), "--jobs", "1"]
    with subprocess.Popen([sys.executable, SCRIPT, *arguments], stderr=subprocess.PIPE, text=True) as process:
        first = process.stderr.readline()
        process.send_signal(number)
        said = process.stderr.read()
    assert first.startswith("maps: circuit1, seed 0")
    assert process.returncode == 128 + number
    assert said == ""


def test_a_wrong_file_is_one_line_and_no_further_drive_is_begun(tmp_path, capsys, monkeypatch):
    lost = Drive("nowhere", tmp_path / "nowhere.world", "circuit1", 0)
    later = [Drive(f"later{i}", tmp_path / f"{i}", "circuit1", i) for i in range(9)]
    monkeypatch.setattr(command, "map_drive", _leave_a_file)
    monkeypatch.setattr(command, "circuit_drives", lambda values: [lost, *later])
    arguments = ["--tracks", "", "--roads", "", "--results", str(tmp_path), "--jobs", "1"]
    assert command.main(arguments) == BAD_INPUT
    assert "nowhere.world" in capsys.readouterr().err
    assert not (tmp_path / "8").exists()
