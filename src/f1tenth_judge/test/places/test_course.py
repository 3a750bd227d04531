"""The road, from a circuit and from a centreline of others."""

import math

import numpy as np
import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.places.course import read_course

SQUARE = "# x_m, y_m, w_tr_right_m, w_tr_left_m\n0, 0, 1, 0.5\n10, 0, 1, 0.5\n10, 10, 1, 0.5\n0, 10, 1, 0.5\n"


def circle(count):
    """Points on a circle of 5 m."""
    return [(5 * math.cos(k * math.tau / count), 5 * math.sin(k * math.tau / count)) for k in range(count)]


def rows(values):
    return "".join(", ".join(f"{value:.9g}" for value in row) + "\n" for row in values)


def test_road_may_run_either_way_and_name_its_first_point_again(tmp_path):
    path, line = tmp_path / "c.csv", [(x, y, 1.0, 0.5) for x, y in circle(40)]
    for each in (line, line[::-1], [*line, line[0]], [*line[:-1]]):
        path.write_text(rows(each), encoding="utf-8")
        assert read_course(path).length == pytest.approx(31.4, abs=0.1)


@pytest.fixture
def square(tmp_path):
    path = tmp_path / "square_centerline.csv"
    path.write_text(SQUARE, encoding="utf-8")
    return read_course(path)


@pytest.mark.parametrize(
    ("x", "y", "excess"),
    [(5, 0, 0), (5, -0.9, 0), (5, -1.25, 0.25), (5, 0.4, 0), (5, 0.75, 0.25), (-1.5, 5, 0.5), (5, 5, 4.5)],
)
def test_excess_is_measured_from_the_edge_of_the_road(square, x, y, excess):
    assert square.excess(np.array([x]), np.array([y])) == pytest.approx([excess])


@pytest.mark.parametrize(
    ("pose", "way", "ahead"),
    [
        ((1.0, 0.3, 0.1), 4.0, (5.0, 0.0, 0.0)),
        ((1.0, 0.3, 0.1), 12.0, (10.0, 3.0, np.pi / 2)),
        ((1.0, 0.3, 3.0), 4.0, (0.0, 3.0, np.pi / 2)),
        ((0.2, 4.0, -1.5), 44.0, (0.0, 0.0, 0.0)),
    ],
)
def test_what_is_ahead_lies_on_the_centreline_in_the_direction_of_the_pose(square, pose, way, ahead):
    assert square.ahead_of(*pose, way) == pytest.approx(ahead, abs=1e-9)


def test_circuit_of_the_workspace_is_one():
    course = read_course(lookup.course_file("circuit1", lookup.package_path(lookup.PACKAGE)))
    assert course.excess(np.array([0.0, 0.0]), np.array([0.0, 5.5])) == pytest.approx([0.0, 0.0], abs=1e-6)
    assert course.excess(np.array([0.0]), np.array([2.5]))[0] > 1.0


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("1, 2, 3\n", ":1: found '1, 2, 3', allowed is x_m, y_m, w_tr_right_m, w_tr_left_m"),
        ("# c\n1, 2, 3, x\n", ":2: found '1, 2, 3, x', allowed is"),
        ("1, 2, 3, -4\n", ":1: found '1, 2, 3, -4', allowed is"),
        (
            "1, 2, 3, 4\n3, 2, 3, 4\n",
            ": found 2 different points of 4 numbers, must be at least 3: x_m, y_m, w",
        ),
        ("1, 2\n3, 2\n3, 4\n", ": found 3 different points of 2 numbers, must be at least 3: x_m, y_m, w_tr"),
        ("0, 1, 2, 1, 1\n1, 9, 2, 1, 1\n", ":1: found '0, 1, 2, 1, 1', allowed is x_m, y_m, w_tr_right_m"),
        (
            rows([(48.1 + x / 1e5, 11.5 + y / 1e5, 1.5, 1.5) for x, y in circle(40)]),
            ": is 0.000314 m long for a road 3 m wide; all numbers must be in m",
        ),
        (
            rows([(x, y, 1.0, 1.0) for x, y in circle(40)[:20]]),
            ": its ends are 9.97 m apart, other points at most 0.785 m; it must be closed",
        ),
    ],
)
def test_what_is_no_centreline_is_refused(tmp_path, text, problem):
    path = tmp_path / "bad.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        read_course(path)
    assert str(caught.value).startswith(f"{path}{problem}")


def test_bad_circuit_and_missing_file_are_named(tmp_path):
    path = tmp_path / "bad.yaml"
    path.write_text("corners: 1\n", encoding="utf-8")
    with pytest.raises(ScenarioError, match="bad"):
        read_course(path)
    with pytest.raises(ScenarioError, match="none.csv: no such file"):
        read_course(tmp_path / "none.csv")


@pytest.mark.parametrize("name", ["Monza_map.png", "Monza_centerline.csv", "."])
def test_another_file_of_a_track_or_its_folder_is_answered_with_its_map(tmp_path, name):
    for each in ("Monza_map.png", "Monza_centerline.csv", "Monza_map.yaml"):
        (tmp_path / each).touch()
    answer = f"is no world; name the YAML file of its map: {tmp_path}/Monza_map.yaml"
    with pytest.raises(ScenarioError, match=answer):
        lookup.world_file(name, tmp_path)


def test_a_folder_without_a_map_is_no_world(tmp_path):
    with pytest.raises(ScenarioError, match="is no world; there is no X_map.yaml in"):
        lookup.world_file(".", tmp_path)
