"""Many variations: swept, resumed, counted, summed up; with a program in the place of real runs."""

import csv
import json
import math
import shutil
import signal
import subprocess
import time

import pytest
from f1tenth_judge.batch import cluster
from f1tenth_judge.batch import sweep as sweep_module
from f1tenth_judge.batch.jobs import Outcome
from f1tenth_judge.batch.sweep_picture import make_figure
from f1tenth_judge.batch.table_file import write_table
from f1tenth_judge.cli.exit_codes import PASSED
from f1tenth_judge.places import lookup
from scenario_samples import SCENARIO_TEXT

from f1tenth_judge import cli


def swept(results, *variations, name="circuit1", **options):
    varied = [part for each in variations for part in ("--vary", each)]
    more = [part for key, value in options.items() if value for part in (f"--{key}", str(value))]
    return cli.main(["sweep", name, *varied, "--results", str(results), *more]) == PASSED


def table(results):
    with open(results / "sweep" / "circuit1" / "sweep.csv", encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def test_sweep_writes_table_and_picture(program, tmp_path, capsys):
    assert swept(tmp_path / "r", "mu=0.5,1", "seed=1:2")
    rows = table(tmp_path / "r")
    assert [(row["mu"], row["seed"], row["passed"], row["lap_time"]) for row in rows] == [
        ("0.5", "1", "True", "10.5"), ("0.5", "2", "False", "10.5"),
        ("1", "1", "True", "11.0"), ("1", "2", "False", "11.0"),
    ]  # fmt: skip
    assert (tmp_path / "r" / "sweep" / "circuit1" / "sweep.png").stat().st_size > 10_000
    assert "passed:            2 of 4" in capsys.readouterr().out


def test_sweep_gives_the_same_four_at_a_time(program, tmp_path):
    for at_once in (1, 4):
        assert swept(tmp_path / str(at_once), "mu=0.5:1.0:3", "seed=1:2", workers=at_once)
    assert table(tmp_path / "1") == table(tmp_path / "4")


def test_sweep_does_not_repeat_what_is_finished_and_says_so(program, tmp_path, capsys):
    swept(tmp_path, "seed=1:2")
    swept(tmp_path, "seed=1:3")
    assert sorted(program.runs()) == ["seed=1", "seed=2", "seed=3"]
    assert [row["seed"] for row in table(tmp_path)] == ["1", "2", "3"]
    assert [line for line in capsys.readouterr().out.splitlines() if line.startswith("reused:")] == [
        "reused:            2 of 3, of the same inputs",
    ]


def test_sweep_takes_planner_seeds_and_settings_as_other_commands_do(program, tmp_path):
    planner = tmp_path / "mine.py"
    planner.write_text("class Mine:\n    pass\n", encoding="utf-8")
    options = ["--planner", f"{planner}:Mine", "--seeds", "1,3", "--set", "laps=2", "--bag"]
    arguments = ["sweep", "circuit3", "--vary", "mu=0.5,1", *options, "--results", str(tmp_path)]
    assert cli.main(arguments) == PASSED
    assert sorted(program.runs()) == ["mu=0.5,seed=1", "mu=0.5,seed=3", "mu=1,seed=1", "mu=1,seed=3"]
    result = json.loads((tmp_path / "sweep" / "circuit3" / "mu=1,seed=3" / "result.json").read_text())
    assert result["settings"] == ["laps=2", f"planner={{python: '{planner}:Mine'}}", "mu=1", "seed=3"]


def test_sweep_repeats_what_was_run_with_other_software(program, tmp_path, monkeypatch):
    swept(tmp_path, "seed=1:2")
    monkeypatch.setattr(sweep_module, "hash_software", lambda: "another build")
    swept(tmp_path, "seed=1:2")
    assert len(program.runs()) == 4


def test_sweep_repeats_what_was_run_with_another_scenario(program, tmp_path):
    file = tmp_path / "own.yaml"
    file.write_text(SCENARIO_TEXT, encoding="utf-8")
    for _ in range(2):
        assert swept(tmp_path, "seed=1:2", name=str(file))
        file.write_text(file.read_text(encoding="utf-8").replace("seed: 1", "seed: 1\nlaps: 2"))
    assert len(program.runs()) == 4


def test_a_run_during_which_something_changed_is_repeated(program, tmp_path, monkeypatch):
    builds = iter(["one", "two"])
    monkeypatch.setattr(sweep_module, "hash_software", lambda: next(builds, "two"))
    swept(tmp_path, "seed=1")
    swept(tmp_path, "seed=1")
    swept(tmp_path, "seed=1")
    assert len(program.runs()) == 2


def test_a_changed_run_is_not_taken_for_that_of_the_software_before(program, tmp_path, monkeypatch):
    builds = iter(["one", "one", "two", "three"])
    monkeypatch.setattr(sweep_module, "hash_software", lambda: next(builds, "one"))
    for _ in range(3):  # by one, by two that becomes three, by one again
        swept(tmp_path, "seed=1")
    assert len(program.runs()) == 3


def test_run_without_result_is_named(program, tmp_path, capsys):
    assert not swept(tmp_path, "seed=12:14")
    assert [row["seed"] for row in table(tmp_path)] == ["12", "14"]
    assert "seed=13: exit code 1, no result: bad luck" in capsys.readouterr().err


def test_run_whose_inputs_cannot_be_noted_is_named_and_counts(program, tmp_path, monkeypatch, capsys):
    run_jobs = sweep_module.run_jobs

    def spoilt(jobs, *others):
        (jobs[0].folder / "inputs.sha256").mkdir(parents=True)
        return run_jobs(jobs, *others)

    monkeypatch.setattr(sweep_module, "run_jobs", spoilt)
    assert swept(tmp_path, "seed=1:2")
    assert [row["seed"] for row in table(tmp_path)] == ["1", "2"]
    assert "seed=1/inputs.sha256: cannot be written: Is a directory" in capsys.readouterr().err


def test_runs_that_were_told_to_stop_are_no_problems(tmp_path, monkeypatch, capsys):
    def interrupted(jobs, stop, _at_once):
        stop.signal = signal.SIGINT
        yield Outcome(jobs[0], 130, "not written:  replay.json.gz", None)

    monkeypatch.setattr(sweep_module, "run_jobs", interrupted)
    assert not swept(tmp_path, "seed=1:2")
    assert capsys.readouterr() == ("", "circuit1  1 of 2, 0 passed\n")


@pytest.fixture
def dask(tmp_path):
    """A Dask scheduler and a worker, as people start them; its address."""
    pytest.importorskip("distributed")
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


def test_sweep_on_a_cluster_gives_the_same_as_here(program, tmp_path, dask):
    assert dask.startswith("tcp://127.0.0.1:")
    for folder, scheduler in (("here", None), ("cluster", dask)):
        assert swept(tmp_path / folder, "mu=0.5:1.0:3", "seed=1:2", scheduler=scheduler)
    assert table(tmp_path / "here") == table(tmp_path / "cluster")
    assert len(program.runs()) == 12


@pytest.mark.parametrize("uri", ["tcp://127.0.0.1:1", "nonsense://x"])
def test_scheduler_that_is_not_there_is_named(program, tmp_path, monkeypatch, capsys, uri):
    pytest.importorskip("distributed")
    monkeypatch.setattr(cluster, "_CONNECT_TIMEOUT", 0.5)
    assert not swept(tmp_path / "r", "seed=1:2", scheduler=uri)
    assert f"--scheduler {uri}: " in capsys.readouterr().err


def test_scheduler_without_an_address_is_answered(program, tmp_path, capsys):
    assert not swept(tmp_path / "r", "seed=1:2", scheduler="host")
    assert "--scheduler host: must be an address, as in tcp://host:8786" in capsys.readouterr().err


def test_table_is_written_as_parquet_with_types(program, tmp_path):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("fastparquet")
    path = tmp_path / "table.parquet"
    assert swept(tmp_path / "r", "mu=0.5,1", "seed=1:2", output=path)
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
    assert swept(tmp_path / "r", "seed=1:2", output=path)
    assert path.read_bytes() == (tmp_path / "r" / "sweep" / "circuit1" / "sweep.csv").read_bytes()


@pytest.mark.parametrize(
    ("name", "answer"),
    [
        ("table.xlsx", "a table's name must end with .csv or .parquet"),
        ("nowhere/table.csv", "there is no folder "),
        ("/proc/table.csv", "cannot be written: "),
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


def test_results_folder_that_cannot_be_written_is_answered_before_anything_runs(program, tmp_path, capsys):
    (tmp_path / "file").touch()
    folder = tmp_path / "file" / "results"
    assert cli.main(["sweep", "circuit1", "--vary", "seed=1:2", "--results", str(folder)]) == 2
    answer = f"f1tenth: {folder}/sweep/circuit1: cannot be written: Not a directory\n"
    assert capsys.readouterr().err == answer
    assert program.runs() == []


@pytest.mark.parametrize("name", ["sweep.csv", "sweep.png"])
def test_file_that_cannot_be_written_is_named(program, tmp_path, capsys, name):
    file = tmp_path / "sweep" / "circuit1" / name
    file.mkdir(parents=True)
    assert cli.main(["sweep", "circuit1", "--vary", "seed=1", "--results", str(tmp_path)]) == 2
    assert capsys.readouterr().err.splitlines()[-1] == f"f1tenth: {file}: cannot be written: Is a directory"


def test_bad_value_is_answered_before_anything_runs(tmp_path, capsys):
    assert cli.main(["sweep", "circuit1", "--vary", "mu=1:9:3", "--results", str(tmp_path)]) == 2
    assert "cars[0].mu is 5, must be above 0 and at most 3" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_no_workers_are_refused(tmp_path, capsys):
    arguments = ["sweep", "circuit1", "--vary", "seed=1:2", "--results", str(tmp_path), "--workers", "0"]
    assert cli.main(arguments) == 2
    assert "--jobs is 0, must be at least 1" in capsys.readouterr().err


def test_key_is_varied_once(tmp_path, capsys):
    arguments = ["sweep", "circuit1", "--vary", "seed=1:2", "--vary", "seed=3", "--results", str(tmp_path)]
    assert cli.main(arguments) == 2
    assert "--vary seed: is varied more than once" in capsys.readouterr().err


def test_values_that_would_share_a_folder_are_answered(tmp_path, capsys):
    worlds = [tmp_path / "b c.world", tmp_path / "b_c.world"]
    original = lookup.world_file("circuit1", tmp_path)
    for world in worlds:
        shutil.copy(original, world)
        shutil.copy(lookup.map_file(original), world.with_suffix(".yaml"))
    vary = "world=" + ",".join(map(str, worlds))
    assert cli.main(["sweep", "pushed_box", "--vary", vary, "--results", str(tmp_path / "r")]) == 2
    assert f"{worlds[0]}' and 'world={worlds[1]}' would both be written to" in capsys.readouterr().err


def rows_of(key, values):
    return [{key: value, "passed": True, "lap_time": 5.0} for value in values]


@pytest.mark.parametrize(
    ("key", "values", "label", "ticks"),
    [
        ("seed", ["1", "2"], "seed", ["1", "2"]),
        ("limits.timeout", ["7.5", "20"], "limits.timeout (s)", ["7.5", "20"]),
        ("mu", ["0.3", "1"], "mu", ["0.3", "1"]),
        ("cars.robot2.speed_max", ["1", "1.5"], "cars.robot2.speed_max (m/s)", ["1", "1.5"]),
        ("world", ["b", "a"], "world", ["a", "b"]),
    ],
)
def test_axes_have_units_and_ticks_where_the_values_are(key, values, label, ticks):
    _, below = make_figure("t", rows_of(key, values), [key]).axes
    assert below.get_xlabel() == label
    assert [tick.get_text() for tick in below.get_xticklabels()] == ticks


def test_many_whole_values_have_whole_ticks():
    values = [str(seed) for seed in range(1, 31)]
    figure = make_figure("t", rows_of("seed", values), ["seed"])
    figure.canvas.draw()
    ticks = figure.axes[1].get_xticks()
    assert len(ticks) < 12
    assert all(float(tick).is_integer() for tick in ticks)


@pytest.mark.parametrize(("laps", "interval"), [([1.0, 2.0, 3.0], (-0.4841, 4.4841)), ([2.0], (2.0, 2.0))])
def test_interval_of_a_mean_is_that_of_the_books(laps, interval):
    rows = [{**rows_of("mu", ["1"])[0], "lap_time": lap} for lap in laps]
    _, below = make_figure("t", rows, ["mu"]).axes
    assert tuple(below.lines[0].get_ydata()) == pytest.approx(interval, abs=1e-4)


@pytest.mark.parametrize(("passed", "interval"), [(10, (0.7225, 1.0)), (5, (0.2366, 0.7634))])
def test_interval_of_a_rate_is_that_of_the_books(passed, interval):
    rows = [{**row, "passed": i < passed} for i, row in enumerate(rows_of("mu", ["1"] * 10))]
    above, _ = make_figure("t", rows, ["mu"]).axes
    assert tuple(above.lines[0].get_ydata()) == pytest.approx(interval, abs=1e-4)
