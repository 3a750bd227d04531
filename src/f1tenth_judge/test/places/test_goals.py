"""Goals files are read as race_mgr reads them."""

import math

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places.goals import goals_text, read_goals
from f1tenth_judge.scenario.car import Pose


def test_both_forms_of_goals_are_read(tmp_path):
    path = tmp_path / "goals.txt"
    text = "\ufeffframe_id: map\n# remark\n\n1 +2 0.5 # here\n1e0 -2 0 0 0 0.70711 0.70711\n"
    path.write_text(text, encoding="utf-8")
    first, second = read_goals(path)
    assert first == Pose(1.0, 2.0, 0.5)
    assert (second.x, second.y, second.yaw) == (1.0, -2.0, pytest.approx(math.pi / 2, abs=1e-4))


def test_what_is_written_is_read(tmp_path):
    goals = [Pose(0.1, 1 / 3, -0.5), Pose(2.0, 3.0, 3.0)]
    (tmp_path / "goals.txt").write_text(goals_text(goals), encoding="utf-8")
    assert read_goals(tmp_path / "goals.txt") == goals


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("# nothing\n", ': no goals in the file; expected lines of "x y yaw" or "x y z qx qy qz qw"'),
        ("1 2\n", ":1: too few numbers: 2, expected 3 or 7: "),
        ("1 2 3 4\n", ":1: wrong count of numbers: 4, expected 3 or 7: "),
        ("1 2 3 4 5 6 7 8\n", ":1: too many numbers: 8, expected 3 or 7: "),
        ("1 2 3\n1 b 3\n", ':2: y is not a number: "b"'),
        ("1 2 nan\n", ":1: yaw is not finite: nan"),
        (
            "1 2 0 0 0 0 2\n",
            ":1: qx qy qz qw is not a unit quaternion: its length is 2, ",
        ),
        ("frame_id: odom\n", ':1: unknown frame "odom", expected one of: map'),
        ("1 2 3\nframe_id: map\n", ":2: frame_id must stand before everything else, and once"),
    ],
)
def test_what_is_no_goals_file_is_refused(tmp_path, text, problem):
    path = tmp_path / "goals.txt"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        read_goals(path)
    assert str(caught.value).startswith(f"{path}{problem}")


def test_a_file_that_cannot_be_read_is_named(tmp_path):
    with pytest.raises(ScenarioError, match="cannot be read"):
        read_goals(tmp_path)
