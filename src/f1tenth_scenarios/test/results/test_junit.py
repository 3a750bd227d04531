"""JUnit shows the verdict and each criterion apart, and there is always a file."""

import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from f1tenth_judge.results.junit import junit_of_error, write_junit
from f1tenth_judge.scenario.scenario import Verdict
from fake_run import FakeRun
from scenario_samples import aborted, finished, racing, scenario, with_clearance

SCENARIO_TEST = Path(__file__).parents[2] / "scripts" / "scenario_test"


def suite_of(run):
    run.execute()
    return ElementTree.parse(run.plan.folder / "junit.xml").getroot()


def names(suite, tag):
    return sorted(case.get("name") for case in suite.iter("testcase") if case.find(tag) is not None)


def counts(suite):
    return {name: int(suite.get(name)) for name in ("tests", "failures", "errors", "skipped")}


def test_each_criterion_is_a_case(tmp_path):
    suite = suite_of(FakeRun(tmp_path, with_clearance(0.1)).records(4.0).hears(racing(), finished(3.0)))
    assert {case.get("classname") for case in suite} == {"f1tenth_scenarios.sample"}
    assert [case.get("name") for case in suite] == [
        "test_verdict", "test_goals_in_order", "test_collision", "test_timeout", "test_minimum_clearance",
    ]  # fmt: skip
    assert counts(suite) == {"tests": 5, "failures": 0, "errors": 0, "skipped": 0}
    assert float(suite.get("time")) == float(suite[0].get("time")) > 0.0


def test_failed_criterion_fails_its_case_and_says_all(tmp_path):
    suite = suite_of(FakeRun(tmp_path).records(4.0).hears(racing(), aborted(2.0)))
    assert names(suite, "failure") == ["test_goals_in_order", "test_verdict"]
    assert counts(suite) == {"tests": 4, "failures": 2, "errors": 0, "skipped": 0}
    failure = suite[0].find("failure")
    text = "verdict: aborted, limit success: robot1 gave up at 2.000 s: goal 2 of 3 aborted: Failed to find a"
    assert failure.get("message").startswith(text)
    assert text in failure.text
    assert "trajectory.png" in failure.text
    text = "goals_in_order: 2 goals, limit 3 goals: not all goals passed by robot1"
    assert suite[1].find("failure").text == text  # all is said once


def test_what_is_not_judged_is_skipped(tmp_path):
    suite = suite_of(FakeRun(tmp_path, scenario(Verdict.ABORTED)).records(4.0).hears(racing(), aborted(2.0)))
    assert names(suite, "skipped") == ["test_goals_in_order"]
    assert counts(suite) == {"tests": 4, "failures": 0, "errors": 0, "skipped": 1}


def test_last_words_that_xml_cannot_hold_are_written_without_their_control_characters(tmp_path):
    run = FakeRun(tmp_path).records(4.0).hears(racing(), aborted(2.0, reason="a\x07\x1b[31mred"))
    assert "a[31mred" in suite_of(run)[0].find("failure").text


def test_run_that_could_not_begin_fails_the_verdict(tmp_path):
    write_junit(tmp_path / "junit.xml", junit_of_error("sample", "no such world"))
    suite = ElementTree.parse(tmp_path / "junit.xml").getroot()
    assert names(suite, "failure") == ["test_verdict"]
    assert suite[0].find("failure").get("message") == "verdict error: no such world"


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("nowhere", "no scenario 'nowhere'; there are: "),
        ("/nowhere.yaml", "/nowhere.yaml: cannot be read"),
    ],
)
def test_test_node_writes_junit_for_a_scenario_that_cannot_be_read(tmp_path, name, message):
    junit = tmp_path / "junit.xml"
    done = subprocess.run(
        [SCENARIO_TEST, name, f"--gtest_output=xml:{junit}"], capture_output=True, timeout=60
    )
    assert done.returncode == 1
    (case,) = ElementTree.parse(junit).getroot().iter("testcase")
    assert case.get("name") == "test_verdict"
    assert message in case.find("failure").text


def test_test_node_without_a_name_says_how_to_use_it():
    done = subprocess.run([SCENARIO_TEST], capture_output=True, text=True, timeout=60)
    assert done.returncode == 1
    assert done.stderr == "usage: scenario_test NAME [--gtest_output=xml:FILE] [--text]\n"
