"""Many runs: resumed, counted, summed up; with a program in the place of real runs."""

import csv
import json
import math
import os
import shutil
import subprocess
import time

import pytest
from f1tenth_scenarios.batch import many
from f1tenth_scenarios.batch.batch import Job, read_finished, run_job
from f1tenth_scenarios.batch.repeat import is_steady, spread
from f1tenth_scenarios.batch.sweep_table import mean_interval, wilson_interval
from f1tenth_scenarios.batch.sweep_table_file import write_table
from f1tenth_scenarios.errors import ScenarioError

from f1tenth_scenarios import cli, places

# Writes what a run would write; `seed=13` is bad luck, and a file makes the first run kill its parent.
PROGRAM = """
import json, os, pathlib, signal, sys
arguments = sys.argv[1:]
folder = pathlib.Path(arguments[arguments.index("--results") + 1])
settings = [value for option, value in zip(arguments, arguments[1:]) if option == "--set"]
root = pathlib.Path(__file__).parent
with open(root / "log", "a") as log:
    log.write(folder.name + "\\n")
bomb = root / "bomb"
if bomb.exists():
    bomb.unlink()
    os.kill(os.getppid(), signal.SIGKILL)
if "seed=13" in settings:
    sys.exit("bad luck")
values = dict(each.split("=") for each in settings)
lap = 10.0 + float(values.get("mu", 0)) + len((root / "log").read_text()) * ("drift" in str(root))
result = {"verdict": "success", "passed": values.get("seed") != "2", "settings": settings, "culprit": None,
          "times": {"lap_time": lap}, "minimum_clearance": 0.25, "trajectory_hash": str(lap), "reason": "ok"}
target = folder / pathlib.Path(arguments[-1]).stem
target.mkdir(parents=True, exist_ok=True)
(target / "result.json").write_text(json.dumps(result))
"""


@pytest.fixture
def program(tmp_path):
    path = tmp_path / "program.py"
    path.write_text(PROGRAM, encoding="utf-8")
    return str(path)


def runs_of(program):
    with open(os.path.join(os.path.dirname(program), "log"), encoding="utf-8") as log:
        return log.read().split()


def sweep(program, results, *variations, workers=1):
    return many.sweep("circuit1", variations, results, program, workers)


def table(results):
    with open(results / "sweep" / "circuit1" / "sweep.csv", encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def test_sweep_writes_table_and_picture(program, tmp_path, capsys):
    assert sweep(program, tmp_path / "r", "mu=0.5,1", "seed=1:2")
    rows = table(tmp_path / "r")
    assert [(row["mu"], row["seed"], row["passed"], row["lap_time"]) for row in rows] == [
        ("0.5", "1", "True", "10.5"), ("0.5", "2", "False", "10.5"),
        ("1", "1", "True", "11.0"), ("1", "2", "False", "11.0"),
    ]  # fmt: skip
    assert (tmp_path / "r" / "sweep" / "circuit1" / "sweep.png").stat().st_size > 10_000
    assert "passed:            2 of 4" in capsys.readouterr().out


def test_sweep_gives_the_same_on_four_workers(program, tmp_path):
    for workers in (1, 4):
        assert sweep(program, tmp_path / str(workers), "mu=0.5:1.0:3", "seed=1:2", workers=workers)
    assert table(tmp_path / "1") == table(tmp_path / "4")


def test_sweep_does_not_repeat_what_is_finished(program, tmp_path):
    sweep(program, tmp_path, "seed=1:2")
    sweep(program, tmp_path, "seed=1:3")
    assert sorted(runs_of(program)) == ["seed=1", "seed=2", "seed=3"]
    assert [row["seed"] for row in table(tmp_path)] == ["1", "2", "3"]


def test_run_of_a_killed_worker_is_done_again(program, tmp_path):
    (tmp_path / "bomb").touch()
    assert sweep(program, tmp_path / "r", "seed=1:3", workers=1)
    assert len(table(tmp_path / "r")) == 3
    assert len(runs_of(program)) == 4


def test_run_without_result_is_named(program, tmp_path, capsys):
    assert not sweep(program, tmp_path, "seed=12:14")
    assert [row["seed"] for row in table(tmp_path)] == ["12", "14"]
    assert "seed=13: exit code 1, no result: bad luck" in capsys.readouterr().err


@pytest.fixture
def cluster(tmp_path):
    """A Dask scheduler and a worker, as people start them; its address."""
    file = tmp_path / "scheduler.json"
    common = ["--scheduler-file", str(file), "--dashboard-address", "127.0.0.1:0"]
    worker_options = ["--nthreads", "1", "--no-nanny", "--local-directory", str(tmp_path)]
    commands = [
        ["dask-scheduler", *common, "--host", "127.0.0.1", "--port", "0"],
        ["dask-worker", *common, *worker_options],
    ]
    processes = [subprocess.Popen(command, stderr=subprocess.DEVNULL) for command in commands]
    end = time.monotonic() + 60
    while not file.exists() or not file.read_text():
        assert time.monotonic() < end, "no scheduler"
        time.sleep(0.05)
    yield json.loads(file.read_text())["address"]
    for process in reversed(processes):
        process.terminate()
        process.wait()


def test_sweep_on_a_cluster_gives_the_same_as_here(program, tmp_path, cluster):
    assert cluster.startswith("tcp://127.0.0.1:")
    for folder, scheduler in (("here", None), ("cluster", cluster)):
        results, variations = tmp_path / folder, ("mu=0.5:1.0:3", "seed=1:2")
        assert many.sweep("circuit1", variations, results, program, 1, scheduler)
    assert table(tmp_path / "here") == table(tmp_path / "cluster")
    assert len(runs_of(program)) == 12


@pytest.mark.parametrize("uri", ["tcp://127.0.0.1:1", "nonsense://x"])
def test_scheduler_that_is_not_there_is_named(program, tmp_path, monkeypatch, uri):
    monkeypatch.setattr("f1tenth_scenarios.batch.sweep._CONNECT_TIMEOUT", 0.5)
    with pytest.raises(ScenarioError, match=f"--scheduler {uri}: .*"):
        many.sweep("circuit1", ["seed=1:2"], tmp_path / "r", program, None, uri)


def test_table_is_written_as_parquet_with_types(program, tmp_path):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("fastparquet")
    path = tmp_path / "table.parquet"
    assert many.sweep("circuit1", ["mu=0.5,1", "seed=1:2"], tmp_path / "r", program, 1, None, path)
    read = pandas.read_parquet(path, engine="fastparquet")
    assert read["mu"].tolist() == [0.5, 0.5, 1.0, 1.0]
    assert read["seed"].tolist() == [1, 2, 1, 2]
    assert read["passed"].tolist() == [True, False, True, False]
    assert read["lap_time"].tolist() == [10.5, 10.5, 11.0, 11.0]
    assert read["verdict"].tolist() == ["success"] * 4


def test_runs_without_a_lap_stay_numbers_in_parquet(tmp_path):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("fastparquet")
    path = tmp_path / "table.parquet"
    write_table(path, [{"world": "a", "lap_time": None}, {"world": "1", "lap_time": 2.0}])
    read = pandas.read_parquet(path, engine="fastparquet")
    assert read["world"].tolist() == ["a", "1"]
    assert math.isnan(read["lap_time"][0])


def test_table_may_be_written_as_csv_elsewhere(program, tmp_path):
    path = tmp_path / "table.csv"
    assert many.sweep("circuit1", ["seed=1:2"], tmp_path / "r", program, 1, None, path)
    assert path.read_bytes() == (tmp_path / "r" / "sweep" / "circuit1" / "sweep.csv").read_bytes()


@pytest.mark.parametrize(
    ("name", "answer"),
    [
        ("table.xlsx", "a table's name must end with .csv or .parquet"),
        ("nowhere/table.csv", "there is no folder "),
        ("table.parquet", "Parquet needs the Python package fastparquet (make setup installs it)"),
    ],
)
def test_table_that_cannot_be_written_is_answered_before_anything_runs(
    tmp_path, monkeypatch, capsys, name, answer
):
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    arguments = ["sweep", "circuit1", "--vary", "seed=1:2", "--results", str(tmp_path / "r")]
    assert cli.main([*arguments, "--output", str(tmp_path / name)]) == 2
    assert f"{tmp_path / name}: {answer}" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_bad_value_is_answered_before_anything_runs(tmp_path, capsys):
    assert cli.main(["sweep", "circuit1", "--vary", "mu=1:9:3", "--results", str(tmp_path)]) == 2
    assert "cars[0].mu is 5, must be above 0 and at most 3" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_key_is_varied_once(tmp_path, capsys):
    arguments = ["sweep", "circuit1", "--vary", "seed=1:2", "--vary", "seed=3", "--results", str(tmp_path)]
    assert cli.main(arguments) == 2
    assert "--vary seed: is varied more than once" in capsys.readouterr().err


def test_values_that_would_share_a_folder_are_answered(tmp_path, capsys):
    worlds = [tmp_path / "b c.world", tmp_path / "b_c.world"]
    original = places.world_file("circuit1", tmp_path)
    for world in worlds:
        shutil.copy(original, world)
        shutil.copy(places.map_file(original), world.with_suffix(".yaml"))
    vary = "world=" + ",".join(map(str, worlds))
    assert cli.main(["sweep", "pushed_box", "--vary", vary, "--results", str(tmp_path / "r")]) == 2
    assert f"{worlds[0]}' and 'world={worlds[1]}' would both be written to" in capsys.readouterr().err


@pytest.mark.parametrize("jobs", [1, 2])
def test_repeat_says_that_all_were_the_same(program, tmp_path, capsys, jobs):
    assert many.repeat("circuit1", 3, tmp_path, ["mu=1"], program, jobs)
    assert sorted(runs_of(program)) == ["001", "002", "003"]
    lines = capsys.readouterr().out.splitlines()
    assert "trajectories:      all the same, bit for bit" in lines
    assert "lap time:          11.000 s" in lines


def test_repeat_finds_a_difference(tmp_path, capsys):
    folder = tmp_path / "drift"
    folder.mkdir()
    (folder / "program.py").write_text(PROGRAM, encoding="utf-8")
    assert not many.repeat("circuit1", 2, folder, [], str(folder / "program.py"))
    assert "trajectories:      2 different ones" in capsys.readouterr().out


def test_repeat_needs_one_scenario_and_two_runs(capsys):
    assert cli.main(["run", "circuit1", "--repeat", "1"]) == 2
    assert cli.main(["run", "circuit1", "circuit2", "--repeat", "3"]) == 2
    assert "--repeat is for one scenario, and at least 2 times" in capsys.readouterr().err


def test_result_with_other_settings_is_not_taken(program, tmp_path):
    job = Job("/x/circuit1.yaml", ("seed=1",), str(tmp_path / "a"))
    run_job(job, program)
    assert read_finished(job)["passed"]
    assert read_finished(Job(job.scenario, ("seed=2",), job.folder)) is None


def test_run_that_was_told_to_stop_is_not_finished(program, tmp_path):
    job = Job("/x/circuit1.yaml", (), str(tmp_path / "a"))
    stopped = {**run_job(job, program), "culprit": {"culprit": "runner"}}
    job.result_file.write_text(json.dumps(stopped), encoding="utf-8")
    assert read_finished(job) is None


def test_steady_means_passed_and_the_same():
    one = {"verdict": "success", "passed": True, "trajectory_hash": "a"}
    other = {**one, "trajectory_hash": "b"}
    assert is_steady([one, one], lockstep=True)
    assert not is_steady([one, other], lockstep=True)
    assert is_steady([one, other], lockstep=False)
    assert not is_steady([one, {**one, "passed": False}], lockstep=False)


def test_spread_of_runs_without_laps():
    result = {"verdict": "error", "passed": False, "trajectory_hash": None}
    lines = dict(spread([{**result, "times": {"lap_time": None}, "minimum_clearance": None}]))
    assert (lines["verdicts"], lines["lap time"]) == ("1 error", "none")


def test_intervals_are_those_of_the_books():
    assert wilson_interval(10, 10) == pytest.approx((0.7225, 1.0), abs=1e-4)
    assert wilson_interval(5, 10) == pytest.approx((0.2366, 0.7634), abs=1e-4)
    assert mean_interval([1.0, 2.0, 3.0]) == pytest.approx((2.0, 0.8684, 3.1316), abs=1e-4)
    assert mean_interval([2.0]) == (2.0, 2.0, 2.0)
