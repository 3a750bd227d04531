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


def test_all_that_became_worse_stands_in_a_line_beside_what_is_as_good(results, capsys):
    base = results("base", one=driven_by("mine.py:A"), two=driven_by("mine.py:A"))
    worse = failed(criteria=[{**CRITERION, "status": "failed"}], **driven_by("mine.py:A"))
    head = results("head", one=worse, two=driven_by("theirs.py:B"))
    assert cli.main(["compare", base, head]) == 1
    one, two = capsys.readouterr().out.splitlines()[1:3]
    problems = "did not pass: robot1 touched Wall_1; criterion collision failed: nothing touched"
    assert one.split() == f"one success -> collision 10.000 s 0.250 m {problems}".split()
    named = "two (mine.py:A -> theirs.py:B) success 10.000 s 0.250 m as good"
    assert two.split() == named.split()


def test_scenario_that_was_not_run_is_worse_and_a_new_one_is_not(results, capsys):
    one = driven_by("gap.py:Gap")
    assert cli.main(["compare", results("base", old=one), results("head", new=one)]) == 1
    lines = capsys.readouterr().out.splitlines()
    new, old = (" ".join(line.split()) for line in lines[1:3])
    assert (new.startswith("new not run -> success "), new.endswith("as good")) == (True, True)
    assert (old.startswith("old success -> not run "), old.endswith("was not run")) == (True, True)


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


def driven_by(planner):
    return {"cars": {"robot1": {"planner": planner, "lap_times": [9.5], "goals_passed": []}}}


def test_any_two_runs_are_compared_and_their_planners_named(results, capsys):
    base = results("base", mine=driven_by("/robots/gap.py:Gap") | lap(10.0))
    head = results("head", theirs=driven_by("race") | lap(9.0))
    assert cli.main(["compare", f"{base}/mine", f"{head}/theirs"]) == 0
    line = capsys.readouterr().out.splitlines()[1]
    assert line.startswith("mine -> theirs (gap.py:Gap -> race)  success  10.000 s -> 9.000 s  ")


def seeds(count, changes=lambda seed: {}):
    return {f"seed={seed},mu=0.5": {"seed": seed, **changes(seed)} for seed in range(count)}


def failing(number):
    return lambda seed: failed() if seed < number else {}


@pytest.mark.parametrize(
    ("base", "head", "options", "said"),
    [
        (failing(0), failing(0), (), None),
        (failing(0), failing(2), (), None),
        (failing(0), failing(6), (), "passed 14 of 20 (70%; 95 % interval 48% to 85%) instead of 20 of 20 ("),
        (failing(6), failing(0), (), None),
        # A tenth of a second more in each pair, however much the laps of the seeds differ.
        (lambda seed: lap(10.0 + seed), lambda seed: lap(10.1 + seed), (), None),
        (lambda seed: lap(10.0 + seed), lambda seed: lap(10.1 + seed), ("--lap-time", "+2%"), None),
        (
            lambda seed: lap(10.0 + seed),
            lambda seed: lap(10.1 + seed),
            ("--lap-time", "+0%"),
            "lap time +0.100 s, 95 % interval +0.100 to +0.100 s, may be +0.000 s",
        ),
        # Slower on average, but no more than by chance.
        (lambda seed: lap(10.0), lambda seed: lap(10.1 + (-1) ** seed), ("--lap-time", "+0%"), None),
        (
            lambda seed: {},
            lambda seed: {"minimum_clearance": 0.2 + 0.001 * (seed % 2)},
            ("--clearance", "-0.02"),
            "clearance -0.049 m, 95 % interval -0.050 to -0.049 m, may be -0.020 m",
        ),
    ],
)
def test_runs_of_several_seeds_are_judged_by_intervals(results, capsys, base, head, options, said):
    before, after = results("base", **seeds(20, base)), results("head", **seeds(20, head))
    assert cli.main(["compare", before, after, *options]) == (1 if said else 0)
    out = capsys.readouterr().out
    assert out.splitlines()[1].startswith("mu=0.5  ")
    assert (said or "as good") in out
    assert out.endswith(f"{1 if said else 0} of 1 scenarios became worse\n")


def test_other_seeds_are_compared_as_independent_runs(results, capsys):
    others = {f"seed={seed}": {"seed": seed, **lap(10.0 + 0.1 * (seed % 3))} for seed in range(9)}
    slower = {f"seed={seed}": {"seed": seed, **lap(11.0 + 0.1 * (seed % 3))} for seed in range(50, 56)}
    assert (
        cli.main(["compare", results("base", **others), results("head", **slower), "--lap-time", "+5%"]) == 1
    )
    out = capsys.readouterr().out
    assert "all seeds" in out
    assert "lap time +1.000 s, 95 % interval +0.897 to +1.103 s, may be +0.505 s" in out


def test_one_run_beside_several_is_compared_by_its_rate_alone(results, capsys):
    assert (
        cli.main(["compare", results("base", **seeds(1)), results("head", **seeds(5)), "--lap-time", "+0%"])
        == 0
    )
    assert "1 of 1 (100%; 95 % interval 21% to 100%) -> 5 of 5 (100%; " in capsys.readouterr().out
