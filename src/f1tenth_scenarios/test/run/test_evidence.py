"""Whoever removes, replaces or cuts what the simulator records is noticed."""

import shutil

import pytest
from f1tenth_scenarios.run.evidence import Evidence


@pytest.fixture
def record(tmp_path):
    path = tmp_path / "record.csv"
    path.write_text("time\n1\n2\n", encoding="utf-8")
    return path


def appended(path, text):
    with open(path, "a", encoding="utf-8") as stream:
        stream.write(text)


def test_file_that_grows_is_as_it_should_be(tmp_path):
    evidence = Evidence(tmp_path / "record.csv", tmp_path / "never_written")
    assert evidence.problem() == ""
    for line in "abc":
        appended(tmp_path / "record.csv", line)
        assert evidence.problem() == ""


def test_record_that_the_simulator_begins_anew_is_as_it_should_be(record):
    evidence = Evidence(record)
    assert evidence.problem() == ""
    record.rename(f"{record}.before_reset_1")
    record.write_text("time\n", encoding="utf-8")
    assert evidence.problem() == ""
    appended(record, "1\n")
    assert evidence.problem() == ""


def removed(path):
    path.unlink()


def replaced(path):
    shutil.copy(path, f"{path}.new")
    path.with_name(f"{path.name}.new").rename(path)


def cut(path):
    path.write_text("time\n", encoding="utf-8")


def overwritten(path):
    """Cut, and written to since as by somebody who knows how long it was."""
    path.write_text("time\n\0\0\0\n3\n4\n", encoding="utf-8")


@pytest.mark.parametrize(
    ("change", "words"), [(removed, "was removed"), (replaced, "was replaced"), (cut, "was cut short")]
)
@pytest.mark.parametrize("is_second", [False, True])
def test_change_is_told_with_the_file(record, tmp_path, change, words, is_second):
    other = tmp_path / "other"
    other.write_text("x", encoding="utf-8")
    evidence = Evidence(other, record) if is_second else Evidence(record, other)
    assert evidence.problem() == ""
    change(record)
    assert evidence.problem() == f"{record} {words} while the run went on"


def test_file_that_has_grown_again_since_it_was_cut_is_noticed_at_the_end(record):
    evidence = Evidence(record)
    assert evidence.problem() == ""
    overwritten(record)
    assert evidence.problem() == ""
    assert evidence.problem_at_end() == f"{record} was overwritten while the run went on"


def test_nothing_is_missed_of_what_was_left_alone(record, tmp_path):
    evidence = Evidence(record, tmp_path / "never_written")
    assert evidence.problem() == ""
    appended(record, "3\n")
    assert evidence.problem_at_end() == ""


def test_record_that_is_cut_after_a_reset_is_noticed_too(record):
    evidence = Evidence(record)
    assert evidence.problem() == ""
    kept = record.rename(f"{record}.before_reset_1")
    record.write_text("time\n", encoding="utf-8")
    assert evidence.problem() == ""
    cut(kept)
    assert "was cut short" in evidence.problem()
