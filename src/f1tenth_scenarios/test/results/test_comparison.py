"""What has become worse between two results folders, and how `scenario compare` says so."""

import xml.etree.ElementTree as ElementTree

import pytest
from f1tenth_judge.results.result_file import write_result
from report_samples import result

from f1tenth_judge import cli

CRITERION = {"name": "collision", "status": "passed", "reason": "nothing touched"}


@pytest.fixture
def results(tmp_path):
    """Writes results into a folder: what differs from a good one, by scenario."""

    def write(name, **scenarios):
        for scenario, changes in scenarios.items():
            good = {"times": {"lap_time": 10.0}, "minimum_clearance": 0.25, "criteria": [CRITERION]}
            folder = tmp_path / name / scenario
            folder.mkdir(parents=True)
            write_result(folder / "result.json", result(scenario, **good | changes))
        return str(tmp_path / name)

    return write


def lap(seconds):
    return {"times": {"lap_time": seconds}}


def failed(**others):
    return {"verdict": "collision", "passed": False, "reason": "robot1 touched Wall_1", **others}


@pytest.mark.parametrize(
    ("base", "head", "options", "said"),
    [
        ({}, {}, (), None),
        ({}, failed(), (), "did not pass: robot1 touched Wall_1"),
        (failed(), failed(verdict="error"), (), "verdict error instead of collision"),
        (failed(), {}, (), None),
        (
            {},
            {"criteria": [{**CRITERION, "status": "failed"}]},
            (),
            "criterion collision failed: nothing touched",
        ),
        ({}, lap(10.3), (), None),
        ({}, lap(10.2), ("--lap-time", "+2%"), None),
        ({}, lap(10.3), ("--lap-time", "+2%"), "lap time 10.300 s, +3.0 %, may be +2.0 %"),
        ({}, lap(None), ("--lap-time", "+2%"), "no lap was completed"),
        (lap(None), lap(9.0), ("--lap-time", "+2%"), None),
        ({}, {"minimum_clearance": 0.231}, ("--clearance", "-0.02"), None),
        (
            {},
            {"minimum_clearance": 0.22},
            ("--clearance", "-0.02"),
            "clearance 0.220 m, -0.030 m, may be -0.020 m",
        ),
    ],
)
def test_what_became_worse_is_said_and_is_the_exit_code(results, capsys, base, head, options, said):
    code = cli.main(["compare", results("base", lap_1=base), results("head", lap_1=head), *options])
    out = capsys.readouterr().out
    assert code == (1 if said else 0)
    assert (said or "as good") in out
    assert out.endswith(f"{1 if said else 0} of 1 scenarios became worse\n")


def test_scenario_that_was_not_run_is_worse_and_a_new_one_is_not(results, capsys):
    assert cli.main(["compare", results("base", old={}), results("head", new={})]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines[1:3]] == ["new", "old"]
    assert ("not run -> success" in lines[1], lines[1].endswith("as good")) == (True, True)
    assert ("success -> not run" in lines[2], lines[2].endswith("was not run")) == (True, True)


def test_junit_has_a_case_for_each_scenario(results, tmp_path, capsys):
    base, head = results("base", one={}, two={}), results("head", one={}, two=failed())
    assert cli.main(["compare", base, head, "--junit", str(tmp_path / "compare.xml")]) == 1
    suite = ElementTree.parse(tmp_path / "compare.xml").getroot()
    assert (suite.get("tests"), suite.get("failures")) == ("2", "1")
    assert [case.get("name") for case in suite if case.find("failure") is not None] == ["two"]


def test_a_junit_file_that_cannot_be_written_is_bad_input(results, tmp_path, capsys):
    base, file = results("base", one={}), tmp_path / "none" / "compare.xml"
    assert cli.main(["compare", base, base, "--junit", str(file)]) == 2
    assert capsys.readouterr().err == f"f1tenth: {file}: cannot be written: No such file or directory\n"


@pytest.mark.parametrize(
    ("options", "answer"),
    [
        (("--lap-time", "2"), "--lap-time 2: must be +N%, as in +2%"),
        (("--clearance", "+1"), "--clearance +1: must be -M, as in -0.02"),
    ],
)
def test_tolerance_that_is_none_is_answered(results, capsys, options, answer):
    folder = results("base", one={})
    assert cli.main(["compare", folder, folder, *options]) == 2
    assert capsys.readouterr().err == f"f1tenth: {answer}\n"


def test_folder_without_results_is_answered(results, tmp_path, capsys):
    assert cli.main(["compare", results("base", one={}), str(tmp_path)]) == 2
    assert "no results there: no folder with a result.json" in capsys.readouterr().err


def test_broken_result_is_named(results, tmp_path, capsys):
    folder = results("base", one={})
    (tmp_path / "base" / "one" / "result.json").write_text("{", encoding="utf-8")
    assert cli.main(["compare", folder, folder]) == 2
    assert "one/result.json: not a result that can be read: " in capsys.readouterr().err
