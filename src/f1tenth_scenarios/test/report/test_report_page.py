"""The report as a file: complete, self-contained, with an answer to bad input."""

import base64
import json
import re
import urllib.parse
import zlib

import pytest
from f1tenth_judge.report.page import write_report
from report_samples import result, write_long_run, write_run

from f1tenth_judge import cli


def overview(path):
    text = path.read_text(encoding="utf-8")
    (found,) = re.findall(r'<script type="text/plain" id="overview">(.*?)</script>', text)
    return json.loads(zlib.decompress(base64.b64decode(found)))["runs"]


@pytest.fixture
def results(tmp_path):
    folder = tmp_path / "results"
    write_run(folder / "one", result("one"))
    write_run(folder / "two", result("two", passed=False))
    write_run(folder / "two" / "previous", result("two", commit="ba9876543210"), speed=1.0)
    return folder


def test_all_runs_are_in_it(results, tmp_path):
    assert write_report(results, tmp_path / "report.html") == []
    one, two = overview(tmp_path / "report.html")
    assert (one["scenario"], one["passed"], one["previous"]) == ("one", True, None)
    assert (two["scenario"], two["passed"], two["previous"]["passed"]) == ("two", False, True)
    assert len(one["thumbnail"][0]) == 50


def test_nothing_is_fetched_and_no_text_ends_a_script(results, tmp_path):
    write_report(results, tmp_path / "report.html")
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert not re.search(r"\bsrc=|https?://(?!www\.w3\.org/2000/svg)|@import|url\(", text)
    assert text.count("<script") == text.count("</script>") == 6
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
        capsys.readouterr().err == f"f1tenth: {tmp_path}: no results; a run writes NAME/result.json there\n"
    )


@pytest.mark.parametrize(
    ("content", "problem"),
    [("{", "not a result that can be read: "), ("[]", "not a result that can be read: its format is None")],
)
def test_broken_result_is_shown_as_such_beside_the_others(results, tmp_path, capsys, content, problem):
    (results / "one" / "result.json").write_text(content, encoding="utf-8")
    assert cli.main(["report", "--results", str(results)]) == 1
    assert f"f1tenth: {results}/one/result.json: {problem}" in capsys.readouterr().err
    one, two = overview(results / "report.html")
    assert (one["scenario"], one["verdict"], one["passed"]) == ("one", "unknown", False)
    assert one["reason"] == "result.json cannot be read"
    assert one["problems"][0].startswith(f"{results}/one/result.json: {problem}")
    assert two["problems"] == []


@pytest.mark.parametrize(
    "name", ["trajectory.csv", "replay.json.gz", "previous/result.json", "previous/trajectory.csv"]
)
def test_anything_else_that_is_broken_is_left_out_and_named(results, tmp_path, name):
    (results / "two" / name).write_text("nonsense\n", encoding="utf-8")
    (problem,) = write_report(results, tmp_path / "report.html")
    assert problem.startswith(f"{results}/two/{name}")
    _, two = overview(tmp_path / "report.html")
    assert (two["verdict"], two["problems"]) == ("collision", [problem])


def test_record_with_a_value_that_is_not_finite_is_left_out_and_named(results, capsys):
    record = results / "two" / "trajectory.csv"
    header, first, *others = record.read_text(encoding="utf-8").splitlines(keepends=True)
    columns = first.split(",")
    columns[2] = "nan"
    record.write_text(header + ",".join(columns) + "".join(others), encoding="utf-8")
    assert cli.main(["report", "--results", str(results)]) == 1
    assert f"f1tenth: {record}:2: x of robot1 at 0.025" in capsys.readouterr().err
    one, two = overview(results / "report.html")
    assert (one["problems"], two["verdict"], two["thumbnail"]) == ([], "collision", [])


def test_files_of_a_run_are_linked_from_where_the_report_is(results, tmp_path):
    (results / "one" / "log").mkdir()
    (results / "one" / "run.bag").touch()
    output = tmp_path / "else where" / "report.html"
    output.parent.mkdir()
    write_report(results, output)
    one, _ = overview(output)
    assert set(one["links"]) == {"log", "bag", "result", "trajectory"}
    assert one["links"]["bag"] == "../results/one/run.bag"
    write_report(results, tmp_path / "results" / "report.html")
    assert overview(tmp_path / "results" / "report.html")[0]["links"]["log"] == "one/log"


def test_links_can_hold_any_name(tmp_path):
    write_run(tmp_path / "results" / "a b#c", result("a b#c"))
    write_report(tmp_path / "results", tmp_path / "results" / "report.html")
    link = overview(tmp_path / "results" / "report.html")[0]["links"]["result"]
    assert (link, urllib.parse.unquote(link)) == ("a%20b%23c/result.json", "a b#c/result.json")


def test_a_hundred_runs_of_two_minutes_are_less_than_3_mb(tmp_path):
    sizes = {}
    for count in (1, 3):
        folder = tmp_path / str(count)
        for number in range(count):
            write_long_run(folder / f"run_{number}", result(f"run_{number}"), seed=number)
        write_report(folder, folder / "report.html")
        sizes[count] = (folder / "report.html").stat().st_size
    each = (sizes[3] - sizes[1]) / 2
    assert sizes[1] + 99 * each < 3e6


def test_walls_of_a_world_are_kept_once(results, tmp_path):
    write_report(results, tmp_path / "report.html")
    one, two = overview(tmp_path / "report.html")
    assert one["world_id"] == two["world_id"]
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert text.count(f'id="world-{one["world_id"]}"') == 1


@pytest.mark.parametrize(
    ("name", "reason"), [("none/report.html", "No such file or directory"), ("", "Is a directory")]
)
def test_report_that_cannot_be_written_is_named(results, tmp_path, capsys, name, reason):
    output = (tmp_path / name).resolve()
    assert cli.main(["report", "--results", str(results), "--output", str(output)]) == 2
    assert capsys.readouterr().err == f"f1tenth: {output}: cannot be written: {reason}\n"
