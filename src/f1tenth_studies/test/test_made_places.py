"""Studies on places that they make: roads of seeds, and tracks of others in both directions."""

from pathlib import Path

import numpy as np
import pytest
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.plan.planning import make_plan
from f1tenth_scenarios.road.course import read_course
from PIL import Image

from f1tenth_scenarios import places
from f1tenth_studies import cli, made_places, tracks

SCENARIO = places.package_path(cli.PACKAGE) / "scenarios" / "unseen_road.yaml"
SQUARE = np.array([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)])


@pytest.fixture
def data(tmp_path, monkeypatch):
    """A folder of tracks with one track, a square that leaves 1 m to the right and 2 m to the left."""
    folder = tmp_path / "data" / "tracks" / "Square"
    folder.mkdir(parents=True)
    np.savetxt(
        folder / "Square_centerline.csv", np.column_stack([SQUARE, [1.0] * 4, [2.0] * 4]), delimiter=", "
    )
    (folder / "Square_map.yaml").write_text(
        "image: Square_map.png\nresolution: 0.1\norigin: [-5.0, -5.0, 0.0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.2\n"
    )
    Image.new("L", (140, 140), 255).save(folder / "Square_map.png")
    monkeypatch.setenv("F1TENTH_DATA", str(tmp_path / "data"))
    return folder


def test_a_track_is_driven_in_both_directions_from_the_same_start(data, tmp_path):
    vary = tracks.STUDY.make({"track": "", "laps": "3"}, tmp_path)
    assert vary["laps"] == "3"
    along, against = vary["world"].split(",")
    assert tracks.STUDY.about({"world": against}) == {"track": "Square_reverse"}
    plans = [make_plan(str(SCENARIO), settings=[f"world={world}"]) for world in (along, against)]
    starts = [plan.cars["robot1"].start for plan in plans]
    assert [(start.x, start.y) for start in starts] == [(0.0, 0.0), (0.0, 0.0)]
    assert [start.yaw for start in starts] == pytest.approx([0.0, np.pi / 2])
    course = read_course(Path(against.replace("_map.yaml", "_centerline.csv")))
    assert course.y.tolist() == [0.0, 4.0, 4.0, 0.0]
    assert (course.right[0], course.left[0]) == (2.0, 1.0)


def test_tracks_without_data_are_bad_input(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("F1TENTH_DATA", str(tmp_path))
    assert cli.study_main(["tracks", "--results", str(tmp_path)]) == cli.BAD_INPUT
    assert f"study: {tmp_path}/tracks: not found; F1TENTH_DATA must name" in capsys.readouterr().err


def test_a_track_that_is_not_there_is_bad_input(data, tmp_path, capsys):
    assert cli.study_main(["tracks", "--vary", "track=Circle", "--results", str(tmp_path)]) == cli.BAD_INPUT
    assert "Circle_centerline.csv" in capsys.readouterr().err


def test_a_line_for_others_is_written_beside_the_place(data, tmp_path):
    line = np.column_stack([SQUARE, [1.0, 2.0, 3.0, 4.0]])
    course = read_course(data / "Square_centerline.csv")
    world = made_places.write_place(tmp_path / "made", data / "Square_map.yaml", course, line)
    rows = np.loadtxt(tmp_path / "made_raceline.csv", delimiter=";")
    assert rows[:, [1, 2, 5]].tolist() == line.tolist()
    assert make_plan(str(SCENARIO), settings=[f"world={world}"]).cars


def test_a_place_that_cannot_be_written_is_an_error(data):
    course = read_course(data / "Square_centerline.csv")
    with pytest.raises(ScenarioError, match="/nowhere/x_map.yaml: No such file"):
        made_places.write_place(Path("/nowhere/x"), data / "Square_map.yaml", course)


@pytest.mark.parametrize("seed", ["x", "1.5"])
def test_a_road_of_no_seed_is_bad_input(tmp_path, seed, capsys):
    assert cli.study_main(["roads", "--vary", f"road={seed}", "--results", str(tmp_path)]) == cli.BAD_INPUT
    assert f"study: road={seed}: must be a seed, a whole number" in capsys.readouterr().err


def test_a_folder_for_places_that_cannot_be_made_is_bad_input(tmp_path, capsys):
    (tmp_path / "places").write_text("")
    assert cli.study_main(["roads", "--vary", "road=1", "--results", str(tmp_path)]) == cli.BAD_INPUT
    assert f"study: {tmp_path}/places/roads: cannot be made: " in capsys.readouterr().err


def test_five_roads_never_seen_are_driven(tmp_path, capsys):
    arguments = ["roads", "--vary", "road=3,11,18,24,25", "--results", str(tmp_path)]
    assert cli.study_main(arguments) == cli.GOOD
    rows = [line.split(" | ") for line in capsys.readouterr().out.splitlines() if line.startswith("| ")][2:]
    assert sum(int(row[2]) for row in rows) == 5
    assert {row[7].strip(" |") for row in rows} == {"0"}
