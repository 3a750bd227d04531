"""Reading what the simulator recorded, whole and while it grows."""

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.record import first_record, read_record
from f1tenth_judge.record.row import COLUMNS
from scenario_samples import record, rows

HEADER = ",".join(COLUMNS) + "\n"
ROW = "0.025,robot1,1,0,0,1,0,0,0,0.5,,0,abc\n"


def test_cars_are_told_apart(tmp_path):
    both = record(tmp_path, rows(1.0), rows(2.0, car="robot2"))
    assert set(both.tracks) == {"robot1", "robot2"}
    assert both.end == 2.0
    assert both.until(1.0).end == 1.0
    assert {name: track.car for name, track in both.until(1.0).tracks.items()} == {
        "robot1": "robot1",
        "robot2": "robot2",
    }


@pytest.mark.parametrize(
    ("ends", "last"), [((1.0, 0.05), "hash40"), ((0.05, 1.0), "hash40"), ((0.025, 0.0), "hash1")]
)
def test_hash_at_the_end_is_that_of_the_last_period_of_all_cars(tmp_path, ends, last):
    cars = [rows(end, car=f"robot{number}") for number, end in enumerate(ends)]
    assert record(tmp_path, *cars).hash_at_end() == last


def test_unfinished_last_line_is_left_out(tmp_path):
    path = tmp_path / "record.csv"
    path.write_text(HEADER + ROW + "0.050,robot1,1,0", encoding="utf-8")
    assert read_record(path).end == 0.025


def test_record_that_was_never_begun_is_empty(tmp_path):
    assert read_record(tmp_path / "record.csv").end is None
    assert read_record(tmp_path / "record.csv").hash_at_end() is None


def test_header_alone_is_empty(tmp_path):
    (tmp_path / "record.csv").write_text(HEADER, encoding="utf-8")
    assert read_record(tmp_path / "record.csv").end is None


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        ("a,b\n1,2\n", f"FILE:1: not a record of the simulator: the columns must be {','.join(COLUMNS)}"),
        (HEADER + "1,2\n", "FILE:2: 2 values, must be 13"),
        (
            HEADER + ROW.replace("0.5", "near"),
            "FILE:2: clearance of robot1 at 0.025 is near, must be a finite number",
        ),
        (
            HEADER + ROW + ROW.replace("0.5", "nan"),
            "FILE:3: clearance of robot1 at 0.025 is nan, must be a finite number",
        ),
        (
            HEADER + ROW.replace("0.025", "inf"),
            "FILE:2: time of robot1 at inf is inf, must be a finite number",
        ),
        (
            HEADER + ROW.replace("abc", "\xe4"),
            "FILE: not a record of the simulator: 'utf-8' codec can't decode byte",
        ),
    ],
)
def test_what_is_no_record_is_refused(tmp_path, text, answer):
    path = tmp_path / "record.csv"
    path.write_text(text, encoding="latin-1")
    with pytest.raises(ScenarioError) as caught:
        read_record(path)
    assert str(caught.value).replace(str(path), "FILE").startswith(answer)


def test_empty_file_is_an_empty_record(tmp_path):
    (tmp_path / "record.csv").touch()
    assert read_record(tmp_path / "record.csv").end is None


def test_first_record_is_the_one_before_a_reset(tmp_path):
    path, kept = tmp_path / "record.csv", tmp_path / "record.csv.before_reset_1"
    path.touch()
    assert first_record(path) == path
    kept.touch()
    assert first_record(path) == kept


def test_what_cannot_be_read_is_named(tmp_path):
    with pytest.raises(ScenarioError, match="cannot be read: Is a directory"):
        read_record(tmp_path)


def test_contacts_in_neighbouring_periods_are_one(tmp_path):
    touching = {1.0: "Wall_1", 1.025: "Wall_1", 1.05: "Wall_1;Wall_2", 1.5: "Wall_1"}
    contacts = record(tmp_path, rows(2.0, contacts=touching)).tracks["robot1"].contact_list()
    assert [(each.start, each.end, each.touched) for each in contacts] == [
        (1.0, 1.025, ("Wall_1",)),
        (1.05, 1.05, ("Wall_1", "Wall_2")),
        (1.5, 1.5, ("Wall_1",)),
    ]
    assert (contacts[0].x, contacts[0].speed) == (1.0, 1.0)
