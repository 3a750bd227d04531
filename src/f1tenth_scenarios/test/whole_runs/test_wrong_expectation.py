"""A real run of a scenario that expects everything wrong: each criterion is a failure of its own in JUnit."""

import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from f1tenth_scenarios.launch.private_master import private_master

WRONG = Path(__file__).parent / "wrong_expectation.yaml"
# Those of goals and culprits are for other verdicts; test_criteria.py has them.
NOT_FAILED = {"test_goals_in_order"}


def test_each_wrong_expectation_is_a_failure_in_junit(tmp_path, monkeypatch):
    monkeypatch.setenv("F1TENTH_RESULTS", str(tmp_path))
    junit = tmp_path / "junit.xml"
    with private_master():
        command = ["rosrun", "f1tenth_scenarios", "scenario_test", str(WRONG), f"--gtest_output=xml:{junit}"]
        subprocess.run(command, capture_output=True, timeout=300, check=False)
    cases = list(ElementTree.parse(junit).getroot().iter("testcase"))
    failed = {case.get("name") for case in cases if case.find("failure") is not None}
    assert failed == {case.get("name") for case in cases} - NOT_FAILED
    assert len(failed) == 13
    (verdict,) = (case for case in cases if case.get("name") == "test_verdict")
    assert "robot1 touched circuit1 at" in verdict.find("failure").text
