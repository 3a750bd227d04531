"""trajectory.csv: all cars, period by period, as the simulator wrote them."""

import csv

from f1tenth_judge.record.record import read_record
from f1tenth_judge.record.row import COLUMNS
from f1tenth_judge.results.result import write_trajectory
from scenario_samples import record, rows


def test_rows_stand_in_the_order_of_time_and_of_cars_in_a_period(tmp_path):
    made = record(tmp_path, rows(12.0, car="robot2", speed=2.0), rows(12.0, car="robot1"))
    file = tmp_path / "trajectory.csv"
    write_trajectory(file, made)
    with open(file, encoding="utf-8", newline="") as stream:
        header, *written = csv.reader(stream)
    assert tuple(header) == COLUMNS
    assert [row[1] for row in written] == ["robot2", "robot1"] * 480
    # By number, not by letter: 9.975 is before 10.
    stamps = [float(row[0]) for row in written]
    assert stamps == sorted(stamps)
    again = read_record(file)
    assert {car: track.rows for car, track in again.tracks.items()} == {
        car: track.rows for car, track in made.tracks.items()
    }


def test_what_is_cut_away_is_not_written(tmp_path):
    made = record(tmp_path, rows(3.0), rows(3.0, car="robot2"))
    write_trajectory(tmp_path / "trajectory.csv", made.until(1.0))
    assert read_record(tmp_path / "trajectory.csv").end == 1.0
    assert len((tmp_path / "trajectory.csv").read_text(encoding="utf-8").splitlines()) == 81
