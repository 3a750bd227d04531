"""The plug-in of pytest, with a program in the place of real runs."""

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from scenario_samples import SCENARIO_TEXT

pytest_plugins = ["pytester"]

PLANNER = Path(__file__).parents[1] / "drivers" / "python" / "classes.py"


@pytest.fixture
def project(pytester, program, monkeypatch):
    """A folder with scenarios."""
    monkeypatch.delenv("F1TENTH_RESULTS", raising=False)
    pytester.makeini("[pytest]\nf1tenth_scenarios = scenarios/\naddopts = -p no:cacheprovider")
    folder = pytester.mkdir("scenarios")
    (folder / "good.yaml").write_text(SCENARIO_TEXT + "tags: [fast, lap]\n")
    (folder / "other.yaml").write_text(SCENARIO_TEXT)
    (folder / "notes.txt").touch()
    return pytester


def test_every_scenario_is_a_test(project, program):
    result = project.runpytest_inprocess("-v")
    result.assert_outcomes(passed=2)
    result.stdout.fnmatch_lines(["scenarios/good.yaml::good PASSED*", "scenarios/other.yaml::other PASSED*"])
    assert (project.path / "results" / "good" / "result.json").is_file()
    result.stdout.fnmatch_lines([f"f1tenth report: {project.path}/results/report.html"])


def test_tags_are_markers_and_names_can_be_chosen(project):
    project.runpytest_inprocess("-m", "fast", "--strict-markers").assert_outcomes(passed=1, deselected=1)
    project.runpytest_inprocess("-k", "other").assert_outcomes(passed=1, deselected=1)


def test_a_scenario_in_a_folder_of_folders_has_results_of_its_own(project):
    deeper = project.path / "scenarios" / "wet"
    deeper.mkdir()
    (deeper / "good.yaml").write_text(SCENARIO_TEXT)
    project.runpytest_inprocess().assert_outcomes(passed=3)
    assert (project.path / "results" / "wet_good" / "result.json").is_file()


def test_a_scenario_that_does_not_pass_is_told_with_reason_picture_and_report(project, program):
    program.path.write_text(program.path.read_text().replace('values.get("seed") != "2"', "False"))
    result = project.runpytest_inprocess("-k", "good", "--junitxml=junit.xml")
    result.assert_outcomes(failed=1, deselected=1)
    folder = project.path / "results"
    result.stdout.fnmatch_lines(
        [
            "ok",
            "verdict: success",
            "reason:  ok",
            f"picture: {folder}/good/trajectory.png",
            f"report:  {folder.as_uri()}/report.html#sample?t=0.000",
        ]
    )
    assert "Traceback" not in result.stdout.str()
    (case,) = ElementTree.parse(project.path / "junit.xml").iter("testcase")
    assert [each.get("value") for each in case.iter("property")] == [str(folder / "good")]


def test_what_is_no_scenario_is_an_error_in_one_line(project):
    (project.path / "scenarios" / "other.yaml").write_text("colour: red\n")
    result = project.runpytest_inprocess()
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(["*other.yaml:1: unknown key 'colour'; allowed: *"])
    assert "Traceback" not in result.stdout.str()


def test_a_run_without_result_is_a_failure_of_one_line(project, program):
    program.falls_silent(2)
    result = project.runpytest_inprocess("-k", "good")
    result.assert_outcomes(failed=1, deselected=1)
    result.stdout.fnmatch_lines(["*/results/good: exit code 2, no result: it said nothing"])
    assert "Traceback" not in result.stdout.str()


def test_a_planner_that_a_scenario_says_nothing_about_skips_it(project):
    (project.path / "scenarios" / "other.yaml").write_text(SCENARIO_TEXT.replace("success", "timeout"))
    result = project.runpytest_inprocess("-rs", "--planner", f"{PLANNER}:Follower")
    result.assert_outcomes(passed=1, skipped=1)
    result.stdout.fnmatch_lines(["SKIPPED*it expects 'timeout', which says nothing about another planner*"])


def test_a_planner_that_is_not_there_is_named(project):
    result = project.runpytest_inprocess("--planner", "none.py:A")
    result.assert_outcomes(failed=2)
    result.stdout.fnmatch_lines([f"none.py:A: no such file: {project.path}/none.py; allowed: *"])


TESTS = f"""
import pytest

@pytest.mark.parametrize("seed", [1, 3])
def test_laps(f1tenth, seed):
    run = f1tenth.race("circuit1", planner="{PLANNER}:Follower", laps=2, seed=seed)
    assert run.verdict == "success"
    assert f1tenth.run("circuit1").lap_times == [10.0]
    assert run.folder.name == f"test_laps_{{seed}}"

def test_too_slow(f1tenth):
    assert max(f1tenth.race("circuit1", settings=["mu=0.5"]).lap_times) < 10.2
"""


def test_the_fixture_gives_runs_with_results_named_after_the_test(project):
    project.makepyfile(TESTS)
    result = project.runpytest_inprocess("-k", "test_")
    result.assert_outcomes(passed=2, failed=1, deselected=2)
    result.stdout.fnmatch_lines(
        ["*assert 10.5 < 10.2*", "reason:  ok", "picture: */test_too_slow/trajectory.png"]
    )
    folders = {each.name for each in (project.path / "results").iterdir() if each.is_dir()}
    laps = {f"test_laps_{name}" for name in ("1", "1_2", "3", "3_2")}
    assert folders == {"races", "test_too_slow", *laps}


def test_processes_of_xdist_share_the_work_and_one_report_is_written(project):
    pytest.importorskip("xdist")
    scenarios = project.path / "scenarios"
    for name in ("good", "other"):
        driver = f"    driver: {{python: '{PLANNER}:Follower'}}\n    laps: 1"
        text = SCENARIO_TEXT.replace("    goals: circuit1", driver)
        text = text.replace("timeout: 10.0", "timeout: 0.5")
        (scenarios / f"{name}.yaml").write_text(text)
    result = project.runpytest_inprocess("-n", "2")
    result.assert_outcomes(failed=2)
    result.stdout.fnmatch_lines([f"f1tenth report: {project.path}/results/report.html"])
