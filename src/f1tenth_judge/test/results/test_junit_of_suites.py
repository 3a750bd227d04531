"""The JUnit file of a suite has a case for each run, and says why one has failed."""

import xml.etree.ElementTree as ElementTree

from f1tenth_judge.results.junit import junit_of_cases, write_junit

GOOD = {"case": "road_1", "verdict": "success", "passed": True, "reason": "every lap was driven"}
BAD = {"case": "road_2", "verdict": "collision", "passed": False, "reason": "robot1 touched <Wall_1>"}


def test_each_run_is_a_case(tmp_path):
    write_junit(tmp_path / "junit.xml", junit_of_cases("roads", [GOOD, BAD]))
    suite = ElementTree.parse(tmp_path / "junit.xml").getroot()
    assert [suite.get(name) for name in ("tests", "failures", "errors", "skipped")] == ["2", "1", "0", "0"]
    good, bad = suite.iter("testcase")
    assert (good.get("name"), bad.get("name")) == ("test_road_1", "test_road_2")
    assert suite.get("name") == good.get("classname") == "f1tenth_scenarios.roads"
    assert good.find("failure") is None
    assert bad.find("failure").text == "verdict collision: robot1 touched <Wall_1>"
