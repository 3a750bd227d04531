"""Runs in processes of their own."""

import json
import signal
import sys

import pytest
from f1tenth_judge.batch import jobs
from f1tenth_judge.batch.jobs import Job, run_job, run_jobs
from f1tenth_judge.stop_request import StopRequest

from f1tenth_judge import cli

# Says that it is there, and ends with its seed as exit code when the others are there too.
MEETING = """
import pathlib, sys, time
folder, needed = pathlib.Path(sys.argv[1]), int(sys.argv[2])
code = int(sys.argv[sys.argv.index("--set") + 1].partition("=")[2])
(folder / str(code)).touch()
while len(list(folder.iterdir())) < needed:
    time.sleep(0.01)
print("code", code)
sys.exit(code)
"""


def meet(monkeypatch, folder, needed, codes, at_once, stop=None):
    folder.mkdir()
    monkeypatch.setattr(jobs, "PROGRAM", (sys.executable, "-c", MEETING, str(folder), str(needed)))
    wanted = [Job("/x/a.yaml", (f"seed={code}",), str(folder / "r")) for code in codes]
    found = run_jobs(wanted, stop or StopRequest(), at_once)
    return sorted((each.exit_code, each.output) for each in found)


def test_jobs_run_at_the_same_time_and_their_output_is_kept_apart(tmp_path, monkeypatch):
    found = meet(monkeypatch, tmp_path / "m", 3, [0, 1, 7], at_once=3)
    assert found == [(0, "code 0\n"), (1, "code 1\n"), (7, "code 7\n")]


def test_signal_ends_those_that_run_and_starts_no_more(tmp_path, monkeypatch):
    folder = tmp_path / "m"
    with StopRequest().listening() as stop:
        raise_when_running(folder, 2)
        found = meet(monkeypatch, folder, 9, [0, 1, 2, 3], at_once=2, stop=stop)
    assert [code for code, _ in found] == [-signal.SIGTERM, -signal.SIGTERM]
    assert len(list(folder.iterdir())) == 2


def raise_when_running(folder, count):
    """A SIGTERM for this process as soon as so many jobs have said that they are there."""

    def look(_number, _frame):
        if not folder.exists() or len(list(folder.iterdir())) < count:
            signal.setitimer(signal.ITIMER_REAL, 0.05)
        else:
            signal.raise_signal(signal.SIGTERM)

    signal.signal(signal.SIGALRM, look)
    signal.setitimer(signal.ITIMER_REAL, 0.05)


def test_the_outcome_has_the_result_that_the_run_wrote(program, tmp_path):
    outcome = run_job(Job("/x/circuit1.yaml", ("mu=1", "seed=2"), str(tmp_path / "r")))
    assert outcome.exit_code == 1
    assert outcome.result["settings"] == ["mu=1", "seed=2"]
    assert outcome.output == "/x/circuit1.yaml ran\n"


@pytest.mark.parametrize("code", [0, 1, 2, 130])
def test_the_result_of_an_earlier_run_is_never_taken_for_that_of_this_one(program, tmp_path, code):
    job = Job("/x/circuit1.yaml", (), str(tmp_path / "r"))
    assert run_job(job).result
    program.falls_silent(code)
    outcome = run_job(job)
    assert outcome.result is None
    assert outcome.problem == f"{tmp_path}/r/circuit1: exit code {code}, no result: it said nothing"


def test_the_result_of_a_run_that_was_told_to_stop_does_not_count(program, tmp_path):
    program.path.write_text(program.path.read_text().replace("sys.exit(0 if", "sys.exit(130 if"))
    assert run_job(Job("/x/circuit1.yaml", (), str(tmp_path))).result is None


def test_a_broken_result_is_none(program, tmp_path):
    program.path.write_text(program.path.read_text().replace("json.dumps(result)", "json.dumps(result)[:20]"))
    assert run_job(Job("/x/circuit1.yaml", (), str(tmp_path))).result is None


def test_all_scenarios_are_counted_and_their_cost_is_summed_up(program, tmp_path, capsys):
    arguments = ["run", "circuit1", "circuit2", "--results", str(tmp_path), "--jobs", "2", "--set", "seed=1"]
    assert cli.main(arguments) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line[:11] for line in lines[:2]] == ["   1 of 2  ", "   2 of 2  "]
    ended = sorted(line[11:] for line in lines[:2])
    assert ended[0] == f"{'circuit1':32}passed  success        10.000 s   0.250 m"
    assert not any(line.endswith("ran") for line in lines)
    assert lines[-2].startswith("cost besides simulating: median 3.0 s, at most 3.0 s (circuit")
    assert lines[-1] == "2 of 2 scenarios passed"
    assert json.loads((tmp_path / "circuit2" / "result.json").read_text())["passed"]


def test_what_an_interruption_left_out_is_counted(program, tmp_path, capsys, monkeypatch):
    def interrupted(jobs, stop, _at_once):
        yield run_job(jobs[0])
        stop.signal = signal.SIGINT

    monkeypatch.setattr("f1tenth_judge.cli.run_command.run_jobs", interrupted)
    cli.main(["run", "circuit1", "circuit2", "--results", str(tmp_path), "--set", "seed=1"])
    assert capsys.readouterr().out.splitlines()[-1] == "1 of 2 scenarios passed, 1 not run"


def test_scenarios_that_did_not_pass_are_told_in_detail_at_the_end(program, tmp_path, capfd):
    assert cli.main(["run", "circuit1", "circuit2", "--results", str(tmp_path), "--set", "seed=2"]) == 1
    lines = capfd.readouterr().out.splitlines()
    assert [" FAILED " in line for line in lines[:2]] == [True, True]
    assert [line.endswith("ran") for line in lines[2:6]] == [False, True, False, True]
    assert lines[-1] == "0 of 2 scenarios passed"


def test_a_scenario_is_run_with_each_of_several_seeds(program, tmp_path, capsys):
    arguments = ["run", "circuit1", "--seeds", "1:3", "--jobs", "3", "--results", str(tmp_path)]
    assert cli.main(arguments) == 1
    assert capsys.readouterr().out.splitlines()[-1] == "2 of 3 runs passed"
    names = ["circuit1,seed=1", "circuit1,seed=2", "circuit1,seed=3"]
    assert sorted(program.runs()) == names
    assert json.loads((tmp_path / names[2] / "result.json").read_text())["settings"] == ["seed=3"]


def test_a_race_is_run_with_each_of_several_seeds(program, tmp_path):
    arguments = ["race", "circuit1", "--seeds", "4,5", "--set", "mu=2", "--results", str(tmp_path)]
    assert cli.main(arguments) == 0
    assert sorted(program.runs()) == ["race_circuit1,seed=4", "race_circuit1,seed=5"]


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["circuit1", "--jobs", "0"], "--jobs is 0, must be at least 1"),
        (["circuit1", "--seeds", "a"], "--seeds a: found 'a', must be a seed, a whole number"),
        (["circuit1", "--seeds", "1:2", "--repeat", "2"], "--seeds is not for --repeat"),
        ([], "run needs either names of scenarios or --all"),
        (["--all", "circuit1"], "run needs either names of scenarios or --all"),
    ],
)
def test_wrong_options_are_answered(arguments, answer, capsys):
    assert cli.main(["run", *arguments]) == 2
    assert capsys.readouterr().err == f"f1tenth: {answer}\n"
