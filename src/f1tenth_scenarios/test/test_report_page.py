"""The report as a file: complete, self-contained, with an answer to bad input."""

import json
import re

import pytest
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.report.page import write_report
from report_samples import result, write_run

from f1tenth_scenarios import cli


def overview(path):
    text = path.read_text(encoding="utf-8")
    (found,) = re.findall(r'<script type="application/json" id="overview">(.*?)</script>', text)
    return json.loads(found)["runs"]


@pytest.fixture
def results(tmp_path):
    folder = tmp_path / "results"
    write_run(folder / "one", result("one"))
    write_run(folder / "two", result("two", passed=False))
    write_run(folder / "two" / "previous", result("two", commit="ba9876543210"), speed=1.0)
    return folder


def test_all_runs_are_in_it(results, tmp_path):
    assert write_report(results, tmp_path / "report.html") == 2
    one, two = overview(tmp_path / "report.html")
    assert (one["scenario"], one["passed"], one["previous"]) == ("one", True, None)
    assert (two["scenario"], two["passed"], two["previous"]["passed"]) == ("two", False, True)
    assert len(one["thumbnail"][0]) == 70


def test_nothing_is_fetched_and_no_text_ends_a_script(results, tmp_path):
    write_report(results, tmp_path / "report.html")
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert not re.search(r"\bsrc=|https?://(?!www\.w3\.org/2000/svg)|@import|url\(", text)
    assert text.count("<script") == text.count("</script>") == 5
    assert "<!--" not in text


def test_other_results_to_compare_with_can_be_named(results, tmp_path):
    write_run(tmp_path / "old" / "one", result("one", commit="older"))
    write_report(results, tmp_path / "report.html", tmp_path / "old")
    one, two = overview(tmp_path / "report.html")
    assert (one["previous"]["versions"]["commit"], two["previous"]) == ("older", None)


def test_run_without_a_recording_is_shown_all_the_same(tmp_path):
    folder = write_run(tmp_path / "results" / "one", result("one"))
    (folder / "replay.json.gz").unlink()
    (folder / "trajectory.csv").unlink()
    write_report(tmp_path / "results", tmp_path / "report.html")
    assert overview(tmp_path / "report.html")[0]["thumbnail"] == []


def test_command_says_where_the_report_is(results, capsys):
    assert cli.main(["report", "--results", str(results)]) == 0
    assert capsys.readouterr().out == f"report:            {results}/report.html\n"
    assert (results / "report.html").is_file()


def test_command_needs_results(tmp_path, capsys):
    assert cli.main(["report", "--results", str(tmp_path)]) == 2
    assert (
        capsys.readouterr().err == f"scenario: {tmp_path}: no results; a run writes NAME/result.json there\n"
    )


@pytest.mark.parametrize(
    ("content", "problem"), [("{", "not a result: "), ("[]", "not a result: it has no verdict")]
)
def test_broken_result_is_named(results, tmp_path, content, problem):
    (results / "one" / "result.json").write_text(content, encoding="utf-8")
    with pytest.raises(ScenarioError, match=f"{results}/one/result.json: {problem}"):
        write_report(results, tmp_path / "report.html")
    assert not (tmp_path / "report.html").exists()


@pytest.mark.parametrize(
    ("name", "reason"), [("none/report.html", "No such file or directory"), ("", "Is a directory")]
)
def test_report_that_cannot_be_written_is_named(results, tmp_path, capsys, name, reason):
    output = (tmp_path / name).resolve()
    assert cli.main(["report", "--results", str(results), "--output", str(output)]) == 2
    assert capsys.readouterr().err == f"scenario: {output}: cannot be written: {reason}\n"
