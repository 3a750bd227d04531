"""What a run leaves in its folder, however it ends; with a program in roslaunch's place."""

import csv
import dataclasses
import errno
import json
import signal

import psutil
import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.replay import read_replay
from f1tenth_judge.record.row import COLUMNS
from f1tenth_judge.results.console import summary
from fake_run import FakeRun, result_of, succeeding
from PIL import Image
from scenario_samples import aborted, finished, racing


def test_trajectory_ends_with_the_deciding_stamp(tmp_path):
    run = succeeding(tmp_path)
    run.execute()
    with open(run.plan.folder / "trajectory.csv", encoding="utf-8", newline="") as stream:
        written = list(csv.reader(stream))
    assert tuple(written[0]) == COLUMNS
    assert float(written[-1][0]) == 3.0
    assert len(written) == 121


def test_picture_is_written(tmp_path):
    run = succeeding(tmp_path)
    run.execute()
    with Image.open(run.plan.folder / "trajectory.png") as picture:
        assert min(picture.size) > 500


@pytest.mark.parametrize("text", ["image: none.pgm", "image: [", "7", "resolution: 1"])
def test_map_that_cannot_be_read_costs_the_picture_its_walls_only(tmp_path, text):
    run = succeeding(tmp_path)
    run.plan.place.map.write_text(text, encoding="utf-8")
    assert result_of(run)["verdict"] == "success"
    assert (run.plan.folder / "trajectory.png").exists()


def test_signal_ends_the_run_and_leaves_a_result(tmp_path):
    run = FakeRun(tmp_path).records(2.0)

    def interrupt(simulated, _wall):
        if simulated is not None:
            signal.raise_signal(signal.SIGTERM)

    with run.stop.listening():
        run.execute(progress=interrupt)
    result = json.loads((run.plan.folder / "interrupted" / "result.json").read_text(encoding="utf-8"))
    assert result["reason"] == "runner: was told to stop by SIGTERM"
    assert result["not_written"] == [
        f"{file}: the run was told to stop" for file in ("trajectory.png", "replay.json.gz")
    ]
    assert not (run.plan.folder / "result.json").exists()


def test_signal_leaves_the_results_of_the_run_before(tmp_path):
    before = succeeding(tmp_path)
    before.execute()
    kept = {path: path.read_bytes() for path in before.plan.folder.rglob("*") if path.is_file()}
    run = FakeRun(tmp_path).records(2.0)
    run.stop.signal = signal.SIGINT
    run.execute()
    interrupted = run.plan.folder / "interrupted"
    left = {
        path: path.read_bytes()
        for path in run.plan.folder.rglob("*")
        if path.is_file() and interrupted not in path.parents
    }
    assert left == kept
    assert (interrupted / "log" / "roslaunch.log").exists()


def test_nothing_is_left_behind(tmp_path):
    run = succeeding(tmp_path)
    # Other tests of this process may have started helpers that live as long as it does.
    before = psutil.Process().children(recursive=True)
    run.execute()
    assert sorted(path.name for path in run.plan.folder.iterdir()) == [
        ".lock", "junit.xml", "log", "replay.json.gz", "result.json", "trajectory.csv", "trajectory.png",
    ]  # fmt: skip
    assert set(psutil.Process().children(recursive=True)) <= set(before)
    assert run.watch.closed


def test_results_survive_a_later_run_that_breaks(tmp_path):
    succeeding(tmp_path).execute()
    run = FakeRun(tmp_path).prints("what it said")

    def fail(*_):
        raise RuntimeError("progress cannot be shown")

    with pytest.raises(RuntimeError):
        run.execute(progress=fail)
    assert json.loads((run.plan.folder / "result.json").read_text(encoding="utf-8"))["passed"]
    assert (run.plan.folder / "log" / "record.csv").exists()
    assert (run.plan.folder / "interrupted" / "log" / "roslaunch.log").exists()


@pytest.mark.parametrize(
    ("error", "reason"),
    [
        (OSError(errno.ENOSPC, "No space left on device"), "No space left on device"),
        (MemoryError(), "MemoryError"),
    ],
)
@pytest.mark.parametrize(
    ("writer", "file"),
    [
        ("f1tenth_judge.results.picture.write_picture", "trajectory.png"),
        ("f1tenth_judge.run.outcome.write_replay", "replay.json.gz"),
        ("f1tenth_judge.run.outcome.write_trajectory", "trajectory.csv"),
    ],
)
def test_a_file_that_cannot_be_written_does_not_cost_the_verdict(
    tmp_path, monkeypatch, writer, file, error, reason
):
    def fail(*_):
        raise error

    run = succeeding(tmp_path)
    monkeypatch.setattr(writer, fail)
    result = run.execute()
    assert result.not_written == (f"{file}: {reason}",)
    lines = summary(result, run.plan).splitlines()
    assert f"not written:       {file}: {reason}" in lines
    assert any(line.startswith("picture:") for line in lines) == (file != "trajectory.png")
    written = json.loads((run.plan.folder / "result.json").read_text(encoding="utf-8"))
    assert (written["verdict"], written["not_written"]) == ("success", [f"{file}: {reason}"])
    others = {"trajectory.png", "replay.json.gz", "trajectory.csv"} - {file}
    assert others <= {path.name for path in run.plan.folder.iterdir()}


def test_a_verdict_that_cannot_be_written_is_said(tmp_path, monkeypatch):
    def fail(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("f1tenth_judge.results.writing.write_result", fail)
    run = succeeding(tmp_path)
    with pytest.raises(ScenarioError) as caught:
        run.execute()
    assert str(caught.value) == (
        f"{run.plan.folder}: the results cannot be written: No space left on device;"
        " the verdict was success: every goal was passed in order"
    )


def test_a_log_folder_that_cannot_be_written_is_said(tmp_path, monkeypatch):
    def fail(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("f1tenth_scenarios.run.run.write_launch_file", fail)
    run = succeeding(tmp_path)
    with pytest.raises(ScenarioError, match=f"{run.plan.log_folder}: cannot begin the run: No space left"):
        run.execute()


def test_a_master_that_is_gone_costs_the_replay_and_nothing_else(tmp_path, monkeypatch):
    def fail():
        raise ConnectionRefusedError(errno.ECONNREFUSED, "Connection refused")

    run = succeeding(tmp_path)
    monkeypatch.setattr(run.watch, "descriptions", fail)
    result = run.execute()
    assert result.passed
    assert result.not_written == ("replay.json.gz: Connection refused",)


def test_bag_of_a_run_that_passed_is_kept_if_wanted(tmp_path):
    for keep in (False, True):
        run = succeeding(tmp_path)
        run.plan = dataclasses.replace(run.plan, keep_bag=keep)
        assert run.execute().not_written == ()
        assert (run.plan.folder / "run.bag").exists() == keep
        assert not run.plan.bag_file.exists()


def test_bag_of_a_run_that_failed_is_kept(tmp_path):
    run = FakeRun(tmp_path).records(4.0).hears(racing(), aborted(2.0))
    run.execute()
    assert (run.plan.folder / "run.bag").exists()


def test_recorder_that_dies_costs_the_bag_and_nothing_else(tmp_path):
    run = FakeRun(tmp_path).loses_its_bag().records(4.0)
    run.ends_node("scenario_recorder", -6)
    result = run.hears(racing(), finished(3.0)).execute()
    assert result.passed
    (problem,) = result.not_written
    assert problem.startswith(f"replay.json.gz: {run.plan.bag_file}: cannot be read: ")
    assert read_replay(run.plan.folder / "replay.json.gz").goals["robot1"]


def test_log_of_the_culprit_is_told_from_the_folder_of_the_results(tmp_path):
    run = FakeRun(tmp_path).records(4.0).prints("[ERROR] [1] [/robot1/move_base]: cannot go on")
    run.ends_node("robot1/move_base", -9)
    assert result_of(run)["culprit"]["log_file"] == "log/roslaunch.log"


def test_second_run_into_the_same_folder_is_refused(tmp_path):
    answers = []

    def second(*_):
        if not answers:
            with pytest.raises(ScenarioError) as caught:
                FakeRun(tmp_path).execute()
            answers.append(str(caught.value))

        run.stop.signal = signal.SIGINT

    run = FakeRun(tmp_path)
    run.execute(progress=second)
    assert answers == [f"{run.plan.folder}: another run is writing its results there"]


def test_results_that_cannot_be_written_are_refused(tmp_path):
    (tmp_path / "sample").write_text("a file in the way", encoding="utf-8")
    with pytest.raises(ScenarioError, match="sample: cannot write results: File exists"):
        FakeRun(tmp_path).execute()
