"""The picture shows the whole run, with and without a map, and never half a file."""

import numpy as np
import pytest
from f1tenth_judge.places.map_file import Grid, load_map
from f1tenth_judge.record.record import Record
from f1tenth_judge.results.picture import free_place, make_figure, write_picture
from f1tenth_judge.scenario.car import Pose
from PIL import Image
from scenario_samples import GOALS, record, rows

WHITE, RED = (255, 255, 255), (214, 39, 40)


def write_map(folder, negate=0):
    pixels = np.full((40, 80), 254, dtype=np.uint8)
    pixels[[0, -1], :] = 0
    Image.fromarray(255 - pixels if negate else pixels).save(folder / "track.pgm")
    path = folder / "track.yaml"
    path.write_text(
        f"image: track.pgm\nresolution: 0.1\norigin: [-1.0, -2.0, 0.0]\nnegate: {negate}\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
        encoding="utf-8",
    )
    return path


def colours(path):
    with Image.open(path) as picture:
        return {colour[:3] for _, colour in picture.convert("RGB").getcolors(1 << 24)}


def draw(path, run, track_map=None, goals=GOALS, title="sample"):
    write_picture(
        path, title, ("success: every goal was passed in order", "lap time 3 s"), run, goals, track_map
    )
    return path


@pytest.mark.parametrize("negate", [0, 1])
def test_map_covers_the_rectangle_that_its_description_says(tmp_path, negate):
    track_map = load_map(write_map(tmp_path, negate))
    assert track_map.extent == pytest.approx((-1.0, 7.0, -2.0, 2.0))
    assert (track_map.pixels[0, 0], track_map.pixels[20, 40]) == (0, 254)


def test_contact_is_marked(tmp_path):
    run = record(tmp_path, rows(3.0, contacts={2.0: "Wall_1"}))
    assert RED in colours(draw(tmp_path / "picture.png", run, load_map(write_map(tmp_path))))


def test_run_without_contact_has_no_mark(tmp_path):
    assert RED not in colours(draw(tmp_path / "picture.png", record(tmp_path, rows(3.0))))


@pytest.mark.parametrize("run_length", [0.0, 0.025, 3.0])
def test_every_length_of_run_can_be_drawn(tmp_path, run_length):
    with Image.open(draw(tmp_path / "picture.png", record(tmp_path, rows(run_length)))) as picture:
        assert min(picture.size) > 400


def test_nothing_at_all_can_be_drawn(tmp_path):
    free = Grid(np.full((4, 4), 254, dtype=np.uint8), 0.0, 0.0, resolution=0.25)
    assert WHITE in colours(draw(tmp_path / "picture.png", Record({}), free, goals={}))


def test_two_cars_have_two_colours_and_a_legend(tmp_path):
    run = record(tmp_path, rows(3.0), rows(3.0, car="robot2", y=1.0, speed=2.0))
    names = {"robot1": "robot1 (race)", "robot2": "robot2 (gap.py:Gap)"}
    (axes,) = make_figure("sample", ("success",), run, {}, None, names).axes
    paths = [line for line in axes.lines if line.get_linestyle() == "-"]
    assert len({line.get_color() for line in paths}) == 2
    assert [text.get_text() for text in axes.get_legend().texts] == list(names.values())


def test_one_car_is_coloured_by_its_speed(tmp_path):
    axes, scale = make_figure("sample", ("success",), record(tmp_path, rows(3.0, speed=2.0)), {}, None).axes
    limits = {(paths.norm.vmin, paths.norm.vmax) for paths in axes.collections if paths.norm.scaled()}
    assert limits == {(0.0, 2.0)}
    assert scale.get_ylabel() == "speed (m/s)"


def test_walls_are_dark_and_what_is_unknown_is_nearly_as_light_as_the_road():
    grid = Grid(np.array([[0, 100, 205, 254]], dtype=np.uint8), 0.0, 0.0)
    (shown,) = make_figure("sample", ("success",), Record({}), {}, grid).axes[0].images
    assert shown.get_array().tolist() == [[0.25, 0.93, 0.93, 1.0]]


@pytest.mark.parametrize(("metres", "inches"), [((20, 8), (12.4, 5.3)), ((8, 20), (7.4, 11.9))])
def test_the_longer_side_of_what_is_drawn_is_eleven_inches(metres, inches):
    """With room for the scale beside it and the text above it."""
    width, height = (10 * side - 20 for side in metres)  # what is drawn has a margin of a metre
    grid = Grid(np.zeros((height, width), dtype=np.uint8), 0.0, 0.0, resolution=0.1)
    figure = make_figure("sample", ("success",), Record({}), {}, grid)
    assert tuple(figure.get_size_inches()) == pytest.approx(inches, abs=0.01)


def numbers_drawn(goals):
    (axes, *_) = make_figure("sample", ("success",), Record({}), {"robot1": goals}, None).axes
    return [int(text.get_text()) for text in axes.texts if text.get_text().isdigit()]


def test_goals_far_from_each_other_all_have_their_numbers():
    assert numbers_drawn([Pose(5.0 * i, 0.0) for i in range(6)]) == [1, 2, 3, 4, 5, 6]
    assert numbers_drawn([Pose(2.0, 1.0)]) == [1]


def test_goal_with_a_number_is_large_enough_for_it_and_the_others_are_smaller():
    goals = {"robot1": [Pose(4.0 * i, 0.0) for i in range(26)]}
    figure = make_figure("sample", ("success",), Record({}), goals, None)
    axes, renderer = figure.axes[0], figure.canvas.get_renderer()
    sizes = [each.get_markersize() for each in axes.lines]
    assert max(sizes) > 2 * min(sizes)
    (number,) = [each for each in axes.texts if each.get_text() == "5"]
    assert number.get_window_extent(renderer).height < max(sizes) * figure.dpi / 72.0


def test_of_goals_close_together_every_fifth_or_tenth_has_its_number():
    assert numbers_drawn([Pose(4.0 * i, 0.0) for i in range(26)]) == [5, 10, 15, 20, 25]
    assert numbers_drawn([Pose(1.0 * i, 0.0) for i in range(101)]) == list(range(10, 101, 10))


def test_the_name_of_a_car_lies_neither_on_a_path_nor_on_a_goal():
    start, straight = np.zeros(2), np.column_stack([np.linspace(-5.0, 5.0, 200), np.zeros(200)])
    goal = np.array([[0.0, 0.9]])
    place = free_place(start, 0.9, np.concatenate([straight, goal]))
    assert np.hypot(*(straight - place).T).min() > 0.7
    assert place[1] < 0.0


def test_no_text_lies_on_another_above_a_narrow_map(tmp_path):
    narrow = Grid(np.full((200, 20), 254, dtype=np.uint8), -1.0, -10.0, resolution=0.1)
    figure = make_figure("a_long_name_of_a_scenario", ("success: every goal was passed", "lap time 3 s"),
                         record(tmp_path, rows(1.0, contacts={0.5: "Wall_1"})), {}, narrow)  # fmt: skip
    axes = figure.axes[0]
    texts = [axes.get_legend(), *(each for each in axes.texts if "lap time" in each.get_text())]
    legend, lines = (each.get_window_extent(figure.canvas.get_renderer()) for each in texts)
    assert not legend.overlaps(lines)


def test_text_that_is_no_mathematics_is_drawn_as_it_is(tmp_path):
    draw(tmp_path / "picture.png", record(tmp_path, rows(1.0)), title="$\\nothing$")


@pytest.mark.filterwarnings("error")
def test_words_that_the_font_has_not_are_drawn_without_a_warning(tmp_path):
    draw(tmp_path / "picture.png", record(tmp_path, rows(1.0)), title="ValueError: \u6a21\u578b")


def test_picture_that_cannot_be_drawn_leaves_the_old_one(tmp_path):
    path = tmp_path / "picture.png"
    path.write_bytes(b"old")
    with pytest.raises(AttributeError):
        draw(path, None)
    assert [each.name for each in tmp_path.iterdir()] == ["picture.png"]
    assert path.read_bytes() == b"old"
