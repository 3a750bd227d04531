"""A run drawn for documents and messages."""

import dataclasses
import math

import numpy as np
import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.replay import Shape, write_replay
from f1tenth_judge.report.export import export
from PIL import Image
from report_samples import race_result, replay, result, write_race, write_run

BLUE, ORANGE = (47, 91, 234), (224, 88, 43)  # of the first and the second car
WALL = (70, 83, 106)


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    return write_run(tmp_path_factory.mktemp("export") / "run", result("run"))


def place_of(frame, colour):
    """The mean of the pixels of a colour, nearly; x and y, px."""
    pixels = np.asarray(frame.convert("RGB")).astype(int)
    rows, columns = np.nonzero(np.abs(pixels - colour).max(axis=2) < 40)
    return (columns.mean(), rows.mean()) if len(rows) else None


def test_gif_moves_as_the_car_did(run, tmp_path):
    export(run, tmp_path / "run.gif")
    with Image.open(tmp_path / "run.gif") as movie:
        assert movie.n_frames == 101
        assert movie.info["duration"] == 100
        movie.seek(0)
        x, _ = place_of(movie, BLUE)
        assert x > 0.7 * movie.width  # it begins on the right of its circle
        movie.seek(100)
        covered = place_of(movie, BLUE)
    assert math.dist(covered, (x, movie.height / 2)) > 50  # now its way is drawn, almost a whole circle


def test_two_cars_have_two_colours(tmp_path):
    race = write_race(tmp_path / "race", race_result("race"))
    export(race, tmp_path / "race.gif")
    with Image.open(tmp_path / "race.gif") as movie:
        movie.seek(50)
        assert place_of(movie, BLUE)
        assert place_of(movie, ORANGE)


def test_svg_of_a_race_names_the_planners(tmp_path):
    race = write_race(tmp_path / "race", race_result("race"))
    export(race, tmp_path / "race.svg")
    assert "robot1 (gap.py:Gap)" in (tmp_path / "race.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize("suffix", ["gif", "png"])
def test_road_in_a_map_of_one_wall_stays_free(tmp_path, suffix):
    folder = write_run(tmp_path / "run", result("run"), end=1.0)
    outer, inner = ([(-a, -a), (a, -a), (a, a), (-a, a)] for a in (6.0, 5.0))
    walls = Shape([outer, inner[::-1]])
    write_replay(folder / "replay.json.gz", dataclasses.replace(replay(1.0), walls=walls))
    export(folder, tmp_path / f"run.{suffix}")
    with Image.open(tmp_path / f"run.{suffix}") as picture:
        pixels = np.asarray(picture.convert("RGB")).astype(int)
    assert (np.abs(pixels - WALL).max(axis=2) < 12).mean() < 0.4


def test_svg_is_one_with_walls_and_title(run, tmp_path):
    export(run, tmp_path / "run.svg")
    text = (tmp_path / "run.svg").read_text(encoding="utf-8")
    assert text.startswith("<?xml")
    assert "#46536a" in text


def test_what_cannot_be_drawn_is_refused(run, tmp_path):
    with pytest.raises(ScenarioError, match=r"run\.webm: cannot be drawn; allowed: \.svg, \.png, "):
        export(run, tmp_path / "run.webm")
    (tmp_path / "nothing").mkdir()
    with pytest.raises(ScenarioError, match="no trajectory.csv with a run to draw"):
        export(tmp_path / "nothing", tmp_path / "run.gif")
