"""Files that grow while they are read."""

from f1tenth_judge.record.row import COLUMNS
from f1tenth_judge.run.so_far import SoFar
from f1tenth_scenarios.run.file_tail import LineTail, RecordTail
from scenario_samples import rows, sample_plan, scenario, write_record

HEADER = ",".join(COLUMNS) + "\n"
ROW = "0.025,robot1,1,0,0,1,0,0,0,0.5,,0,abc\n"


def test_tail_follows_a_growing_record(tmp_path):
    path = tmp_path / "record.csv"
    so_far = SoFar(sample_plan(tmp_path, scenario()))
    tail = RecordTail(path, so_far)
    tail.poll()
    assert (so_far.time, so_far.touches) == (None, 0)
    path.write_text(HEADER + ROW + ROW.replace("0.025", "0.050")[:9], encoding="utf-8")
    tail.poll()
    assert (so_far.time, so_far.touches) == (0.025, 0)
    path.write_text(HEADER + ROW + ROW.replace("0.025", "0.050").replace(",,", ",Wall_1,"), encoding="utf-8")
    tail.poll()
    assert (so_far.time, so_far.touches) == (0.05, 1)


def test_tail_agrees_with_the_reader(tmp_path):
    path = write_record(tmp_path / "record.csv", rows(2.0, contacts={1.0: "Wall_1"}))
    so_far = SoFar(sample_plan(tmp_path, scenario()))
    tail = RecordTail(path, so_far)
    tail.poll()
    assert (so_far.time, so_far.touches) == (2.0, 1)


def test_damaged_row_is_left_out(tmp_path):
    path = tmp_path / "record.csv"
    so_far = SoFar(sample_plan(tmp_path, scenario()))
    tail = RecordTail(path, so_far)
    path.write_text(HEADER + ROW, encoding="utf-8")
    tail.poll()
    # Somebody has emptied it, and the simulator writes on where it was.
    path.write_text("\0" * (len(HEADER + ROW) + 3) + ROW.replace("0.025", "0.050"), encoding="utf-8")
    tail.poll()
    assert so_far.time == 0.025


def test_lines_are_handed_out_once(tmp_path):
    path = tmp_path / "log"
    path.write_text("one\ntw", encoding="utf-8")
    tail = LineTail(path)
    assert tail.new_lines() == ["one"]
    with open(path, "a", encoding="utf-8") as stream:
        stream.write("o\n")
    assert tail.new_lines() == ["two"]
    assert tail.new_lines() == []
