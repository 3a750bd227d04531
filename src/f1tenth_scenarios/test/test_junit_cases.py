"""JUnit shows the verdict and each criterion apart, and there is always a file."""

import subprocess
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from f1tenth_scenarios.results.junit_cases import case_of_error, cases_of
from f1tenth_scenarios.scenario.scenario import Verdict
from fake_run import FakeRun
from scenario_samples import aborted, finished, racing, scenario, with_clearance

SCENARIO_TEST = Path(__file__).parent.parent / "scripts" / "scenario_test"


def run_cases(case):
    result = unittest.TestResult()
    unittest.TestLoader().loadTestsFromTestCase(case).run(result)
    return result


def names(entries):
    return sorted(test.id().rpartition(".")[2] for test, _ in entries)


def test_each_criterion_is_a_case(tmp_path):
    run = FakeRun(tmp_path, with_clearance(0.1)).records(4.0).hears(racing(), finished(3.0))
    case = cases_of(run.execute(), run.plan)
    assert (case.__module__, case.__name__) == ("f1tenth_scenarios", "sample")
    assert sorted(name for name in vars(case) if name.startswith("test_")) == [
        "test_collision", "test_goals_in_order", "test_minimum_clearance", "test_timeout", "test_verdict",
    ]  # fmt: skip
    assert run_cases(case).wasSuccessful()


def test_failed_criterion_fails_its_case_and_says_all(tmp_path):
    run = FakeRun(tmp_path).records(4.0).hears(racing(), aborted(2.0))
    result = run_cases(cases_of(run.execute(), run.plan))
    assert names(result.failures) == ["test_goals_in_order", "test_verdict"]
    (text,) = [text for test, text in result.failures if test.id().endswith("test_verdict")]
    assert "verdict: aborted, limit success: robot1 gave up at 2.000 s: goal 2 of 3 aborted" in text
    assert "trajectory.png" in text


def test_what_is_not_judged_is_skipped(tmp_path):
    run = FakeRun(tmp_path, scenario(Verdict.ABORTED)).records(4.0).hears(racing(), aborted(2.0))
    result = run_cases(cases_of(run.execute(), run.plan))
    assert names(result.skipped) == ["test_goals_in_order"]
    assert result.wasSuccessful()


def test_run_that_could_not_begin_fails_the_verdict():
    result = run_cases(case_of_error("sample", "no such world"))
    ((_, text),) = result.failures
    assert "verdict error: no such world" in text


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
