"""The same run many times."""

import pytest
from f1tenth_judge.batch.repeat import is_steady, repeat, spread
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.stop_request import StopRequest

from f1tenth_judge import cli


@pytest.mark.parametrize("at_once", [1, 2])
def test_repeat_says_that_all_were_the_same(program, tmp_path, capsys, at_once):
    assert repeat("circuit1", 3, tmp_path, ["mu=1"], StopRequest(), at_once)
    assert sorted(program.runs()) == ["001", "002", "003"]
    lines = capsys.readouterr().out.splitlines()
    assert "trajectories:      all the same, bit for bit" in lines
    assert "lap time:          11.000 s" in lines


def test_repeat_finds_a_difference(program, tmp_path, capsys):
    program.drifts()
    assert not repeat("circuit1", 2, tmp_path, [], StopRequest())
    assert (
        "trajectories:      2 different ones: does the planner ask the wall clock" in capsys.readouterr().out
    )


@pytest.mark.parametrize("code", [1, 2])
def test_runs_that_leave_nothing_are_no_repetitions_of_earlier_ones(program, tmp_path, code):
    assert repeat("circuit1", 2, tmp_path, [], StopRequest())
    program.falls_silent(code)
    with pytest.raises(ScenarioError, match=f"001/circuit1: exit code {code}, no result: it said nothing"):
        repeat("circuit1", 2, tmp_path, [], StopRequest())


def test_repeat_needs_one_scenario_and_two_runs(capsys):
    assert cli.main(["run", "circuit1", "--repeat", "1"]) == 2
    assert cli.main(["run", "circuit1", "circuit2", "--repeat", "3"]) == 2
    assert "--repeat is for one scenario, and at least 2 times" in capsys.readouterr().err


def test_steady_means_passed_and_the_same():
    one = {"verdict": "success", "passed": True, "trajectory_hash": "a"}
    other = {**one, "trajectory_hash": "b"}
    assert is_steady([one, one])
    assert not is_steady([one, other])
    paced = [{**each, "lockstep": False} for each in (one, other)]
    assert is_steady(paced)
    assert not is_steady([paced[0], {**paced[0], "passed": False}])
    assert not is_steady([paced[0], {**paced[0], "verdict": "collision"}])


def test_spread_says_why_runs_were_not_in_lockstep():
    result = {"verdict": "error", "passed": False, "trajectory_hash": None, "note": "run in real time, as …"}
    lines = spread([{**result, "times": {"lap_time": None}, "minimum_clearance": None}] * 2)
    assert lines.count(("note", "run in real time, as …")) == 1


def test_spread_of_no_runs_blames_nobody():
    assert dict(spread([])) == {
        "runs": "0", "verdicts": "none", "passed": "0 of 0", "trajectories": "none", "lap time": "none",
        "minimum clearance": "none",
    }  # fmt: skip


def test_spread_of_runs_without_laps():
    result = {"verdict": "error", "passed": False, "trajectory_hash": None}
    lines = dict(spread([{**result, "times": {"lap_time": None}, "minimum_clearance": None}]))
    assert (lines["verdicts"], lines["lap time"]) == ("1 error", "none")
    assert lines["minimum clearance"] == "none"


@pytest.mark.parametrize(
    ("lockstep", "why"),
    [(False, ""), (True, ": does the planner ask the wall clock, or draw random numbers without a seed?")],
)
def test_spread_says_from_where_to_where(lockstep, why):
    results = [
        {"verdict": verdict, "passed": passed, "trajectory_hash": verdict, "times": {"lap_time": lap}}
        | {"minimum_clearance": lap / 100}
        for verdict, passed, lap in (
            ("success", True, 9.0),
            ("collision", False, 7.5),
            ("success", True, 8.0),
        )
    ]
    results = [each | {"lockstep": lockstep} for each in results]
    assert spread(results) == [
        ("runs", "3"),
        ("verdicts", "2 success, 1 collision"),
        ("passed", "2 of 3"),
        ("trajectories", f"2 different ones{why}"),
        ("lap time", "7.500 to 9.000 s"),
        ("minimum clearance", "0.075 to 0.090 m"),
    ]


def test_bags_of_all_runs_are_kept_if_that_is_wanted(tmp_path, monkeypatch):
    jobs = []
    monkeypatch.setattr("f1tenth_judge.batch.repeat.run_jobs", lambda wanted, *_: jobs.extend(wanted) or [])
    repeat("circuit1", 2, tmp_path, [], StopRequest(), bag=True)
    assert [job.options for job in jobs] == [("--bag",)] * 2
