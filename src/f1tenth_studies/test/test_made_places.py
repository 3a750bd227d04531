"""Studies on places that they make: roads of seeds, and tracks of others in both directions."""

from pathlib import Path

import numpy as np
import pytest
from f1tenth_judge.places import lookup
from f1tenth_judge.places.course import Course, read_course
from f1tenth_judge.plan.planning import make_plan
from f1tenth_studies.studies import encounters, tracks
from PIL import Image

from f1tenth_studies import cli, made_places

SCENARIO = lookup.package_path(cli.PACKAGE) / "scenarios" / "unseen_road.yaml"
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
    assert tracks.STUDY.about({"world": against})["track"] == "Square_reverse"
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


@pytest.mark.parametrize("seed", ["x", "1.5"])
def test_a_road_of_no_seed_is_bad_input(tmp_path, seed, capsys):
    assert cli.study_main(["roads", "--vary", f"road={seed}", "--results", str(tmp_path)]) == cli.BAD_INPUT
    assert f"study: road={seed}: must be a seed, a whole number" in capsys.readouterr().err


def test_a_folder_whose_path_divides_values_is_refused(tmp_path, capsys):
    results = tmp_path / "seeds_1,2"
    assert cli.study_main(["roads", "--vary", "road=1", "--results", str(results)]) == cli.BAD_INPUT
    assert f"study: --results: {results}/places/roads is among values, must be" in capsys.readouterr().err
    assert not results.exists()


def test_a_road_never_seen_is_driven(tmp_path, capsys):
    arguments = ["roads", "--vary", "road=3", "--vary", "model=single_track_drift"]
    arguments += ["--results", str(tmp_path)]
    assert cli.study_main(arguments) == cli.PASSED
    rows = [line.split(" | ") for line in capsys.readouterr().out.splitlines() if line.startswith("| ")][2:]
    assert sum(int(row[3]) for row in rows) == 1
    assert {row[8].strip(" |") for row in rows} == {"0"}


@pytest.mark.parametrize("manner", ["middle", "side", "weaves", "brakes", "stands"])
def test_the_other_of_an_encounter_drives_as_its_manner_says(manner):
    encounter = encounters.Encounter("Square", 0.0, manner, speed=2.0, aside=-0.4, brakes_after=10.0)
    x = np.arange(0.0, 40.0, 0.25)
    road = Course(x, np.zeros_like(x), np.ones_like(x), np.ones_like(x))
    line = encounters.line_of(encounter, road)
    far = x > 10.0
    assert np.allclose(line[x <= 6.0, 1], 0.0)
    aside = {"side": (-0.4, -0.4), "weaves": (-0.3, 0.3)}.get(manner, (0.0, 0.0))
    assert (line[far, 1].min(), line[far, 1].max()) == pytest.approx(aside, abs=1e-3)
    assert set(line[x > 16.0, 2]) == {0.0 if manner in ("brakes", "stands") else 2.0}
    assert set(line[x < 16.0, 2]) == {0.0 if manner == "stands" else 2.0}


def test_encounters_begin_where_their_seed_says(data, tmp_path):
    vary = encounters.STUDY.make({"encounter": "0,2"}, tmp_path)
    worlds = vary["world"].split(",")
    assert [encounters.STUDY.about({"world": world})["place"] for world in worlds] == ["Square", "Square"]
    scenario = lookup.package_path(cli.PACKAGE) / "scenarios" / "encounters.yaml"
    for world in worlds:
        cars = make_plan(str(scenario), settings=[f"world={world}"]).cars
        start, other = cars["robot1"].start, cars["robot2"].start
        assert 2.0 < np.hypot(other.x - start.x, other.y - start.y) < 6.001
        assert cars["robot2"].line == Path(world.replace("_map.yaml", "_raceline.csv"))
    starts = [make_plan(str(scenario), settings=[f"world={world}"]).cars["robot1"].start for world in worlds]
    assert starts[0] != starts[1]


def test_among_furniture_neither_goals_nor_the_other_touch_it():
    made = [encounters.make_encounter(seed) for seed in range(1, 200, 2)]
    among = [each for each in made if each.place == "circuit_detailed"]
    assert {each.begin for each in among} == {0.0}
    assert {each.manner for each in among} == {"stands"}
    others = [each for each in made if each.place != "circuit_detailed"]
    assert min(each.begin for each in others) > 0.0
    assert {each.manner for each in others} == {"middle", "side", "weaves", "brakes", "stands"}
    assert max(each.speed for each in others) > 3.5


def test_others_are_met_without_a_touch(tmp_path, monkeypatch, capsys):
    monkeypatch.delenv("F1TENTH_DATA", raising=False)
    arguments = ["encounters", "--vary", "encounter=1", "--results", str(tmp_path)]
    assert cli.study_main(arguments) == cli.PASSED
    rows = [line.split(" | ") for line in capsys.readouterr().out.splitlines() if line.startswith("| ")][2:]
    assert [(row[4], row[7].strip(" |")) for row in rows] == [("success", "0")]
