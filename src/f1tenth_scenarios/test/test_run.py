"""A run from start to results, with a program in roslaunch's place."""

import csv
import dataclasses
import errno
import json
import signal
import time

import psutil
import pytest
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.record.record import COLUMNS
from f1tenth_scenarios.record.replay import read_replay
from f1tenth_scenarios.results.console import summary
from f1tenth_scenarios.scenario.scenario import Limits, Verdict
from fake_run import FakeRun
from PIL import Image
from scenario_samples import aborted, died, finished, racing, reached, scenario


def result_of(run, **others):
    run.execute(**others)
    return json.loads((run.plan.folder / "result.json").read_text(encoding="utf-8"))


def succeeding(tmp_path):
    run = FakeRun(tmp_path).records(1.0).waits(0.5).records(9.0)
    return run.hears(racing(), reached(2.2, 1), reached(2.5, 2), finished(3.0))


def test_success_is_written_with_all_that_was_measured(tmp_path):
    result = result_of(succeeding(tmp_path))
    assert (result["verdict"], result["expected"], result["passed"]) == ("success", "success", True)
    assert result["reason"] == "every goal was passed in order"
    assert result["times"]["start"] == 0.0
    assert result["times"]["finish"] == 3.0
    assert result["times"]["lap_time"] == 3.0
    assert result["cars"] == {"robot1": {"lap_times": [3.0], "goals_passed": [0.5, 1.5, 2.5]}}
    assert result["minimum_clearance"] == 0.5
    assert result["contacts"] == []
    assert 0.1 < result["real_time_factor"] < 20.0
    assert (result["seed"], result["trajectory_hash"]) == (1, "hash120")
    assert result["culprit"] is None
    assert [each["name"] for each in result["criteria"]] == [
        "verdict",
        "goals_in_order",
        "collision",
        "timeout",
    ]
    assert {each["status"] for each in result["criteria"]} == {"passed"}
    assert result["versions"]["f1tenth_scenarios"] == "0.2.0"


def test_trajectory_ends_with_the_deciding_stamp(tmp_path):
    run = succeeding(tmp_path)
    run.execute()
    with open(run.plan.folder / "trajectory.csv", encoding="utf-8", newline="") as stream:
        written = list(csv.reader(stream))
    assert tuple(written[0]) == COLUMNS
    assert float(written[-1][0]) == 3.0
    assert len(written) == 121


def test_cost_is_what_a_run_takes_besides_simulating(tmp_path):
    result = result_of(succeeding(tmp_path), started=time.monotonic() - 20.0)
    simulating = result["times"]["finish"] / result["real_time_factor"]
    assert result["times"]["wall"] > 20.0 + simulating
    assert result["times"]["cost"] == pytest.approx(result["times"]["wall"] - simulating)


def test_cost_of_a_run_that_simulates_nothing_is_all_of_its_time(tmp_path):
    times = result_of(FakeRun(tmp_path).ends(1))["times"]
    assert times["cost"] == times["wall"]


def test_picture_is_written(tmp_path):
    run = succeeding(tmp_path)
    run.execute()
    with Image.open(run.plan.folder / "trajectory.png") as picture:
        assert min(picture.size) > 500


@pytest.mark.parametrize("text", ["image: none.pgm", "image: [", "7", "resolution: 1"])
def test_map_that_cannot_be_read_costs_the_picture_its_walls_only(tmp_path, text):
    run = succeeding(tmp_path)
    run.plan.map.write_text(text, encoding="utf-8")
    assert result_of(run)["verdict"] == "success"
    assert (run.plan.folder / "trajectory.png").exists()


def test_same_run_noticed_earlier_or_later_gives_the_same_result(tmp_path):
    results = []
    for name, length in (("early", 3.0), ("late", 9.5)):
        (tmp_path / name).mkdir()
        run = FakeRun(tmp_path / name).records(length).hears(racing(2.0), finished(3.0))
        result = result_of(run)
        result["times"] = {key: result["times"][key] for key in ("start", "finish", "lap_time")}
        results.append((result, (run.plan.folder / "trajectory.csv").read_bytes()))
    assert results[0] == results[1]


def test_contact_ends_the_run_without_any_topic(tmp_path):
    result = result_of(FakeRun(tmp_path).records(4.0, contacts={1.0: "Wall_1", 1.025: "Wall_1"}))
    assert (result["verdict"], result["passed"]) == ("collision", False)
    assert result["contacts"] == [
        {"car": "robot1", "start": 1.0, "end": 1.0, "touched": ["Wall_1"], "x": 1.0, "y": 0.0, "speed": 1.0}
    ]
    assert result["trajectory_hash"] == "hash40"


def test_collision_that_is_only_reported_is_no_verdict_on_the_planner(tmp_path):
    result = result_of(FakeRun(tmp_path).records(2.0).hears(collided=["robot1"]))
    assert result["verdict"] == "error"
    assert result["reason"] == (
        "robot1/collision_detection: reports a collision that the record does not show"
    )


def test_contact_after_the_finish_is_none(tmp_path):
    run = FakeRun(tmp_path).records(4.0, contacts={3.5: "Wall_1"})
    assert result_of(run.hears(racing(), finished(3.0), collided=["robot1"]))["verdict"] == "success"


def test_timeout_ends_the_run(tmp_path):
    result = result_of(FakeRun(tmp_path).records(10.5))
    assert (result["verdict"], result["times"]["finish"]) == ("timeout", 10.0)


def test_false_start_ends_the_run_when_it_happens(tmp_path):
    result = result_of(FakeRun(tmp_path, scenario(time_to_start=2)).records(1.0))
    assert (result["verdict"], result["times"]["finish"]) == ("aborted", 0.075)
    assert result["reason"] == "false start: robot1 moved at 0.075 s, before the countdown of 2 s was over"


def test_false_start_after_the_countdown_ends_the_run_when_the_start_is_heard(tmp_path):
    result = result_of(FakeRun(tmp_path).records(1.0).hears(racing(0.5)))
    assert (result["verdict"], result["times"]["finish"]) == ("aborted", 0.075)


def test_record_that_lags_behind_the_finish_is_waited_for(tmp_path):
    run = FakeRun(tmp_path).records(2.9).hears(racing(), reached(2.2, 1), reached(2.5, 2), finished(3.0))
    result = result_of(run.waits(0.2).records(3.1))
    assert (result["verdict"], result["times"]["finish"]) == ("success", 3.0)


def test_record_that_never_shows_the_finish_is_the_simulators_fault(tmp_path):
    run = FakeRun(tmp_path).records(2.9).hears(racing(), reached(2.2, 1), reached(2.5, 2), finished(3.0))
    assert result_of(run)["reason"] == (
        "sim2d: its record ends before the race does (2.900 s instead of 3.000 s)"
    )


def test_planner_that_gives_up_ends_the_run(tmp_path):
    result = result_of(
        FakeRun(tmp_path, scenario(Verdict.ABORTED)).records(4.0).hears(racing(), aborted(2.0))
    )
    assert (result["verdict"], result["passed"]) == ("aborted", True)


def test_dead_node_is_named_with_its_last_words(tmp_path):
    run = FakeRun(tmp_path).records(4.0).prints("[ERROR] [1] [/robot1/move_base]: cannot go on")
    run.prints("[robot1/move_base-5] process has died [pid 12, exit code -9, cmd x].")
    result = result_of(run)
    assert result["verdict"] == "error"
    assert result["reason"] == "robot1/move_base: was killed by signal 9"
    assert result["culprit"]["culprit"] == "robot1/move_base"
    assert result["culprit"]["log_lines"] == ["[ERROR] [1] [/robot1/move_base]: cannot go on"]


def test_clean_end_of_a_planner_is_an_error_too(tmp_path):
    run = FakeRun(tmp_path).records(4.0).prints("[robot1/move_base-5] process has finished cleanly")
    assert result_of(run)["reason"] == "robot1/move_base: ended with exit code 0"


def test_clean_end_of_a_helper_is_none(tmp_path):
    run = FakeRun(tmp_path).records(4.0).prints("[race_starter-3] process has finished cleanly")
    assert result_of(run.hears(racing(), finished(3.0)))["verdict"] == "success"


def test_race_that_ends_in_the_moment_its_manager_dies_counts(tmp_path):
    run = (
        FakeRun(tmp_path)
        .records(4.0)
        .prints("[robot1/race_mgr-5] process has died [pid 1, exit code 3, cmd x].")
    )
    assert result_of(run.hears(racing(), aborted(2.0)))["verdict"] == "aborted"


def test_silent_participant_is_named(tmp_path):
    run = FakeRun(tmp_path).records(4.0)
    run.simulator_says(participant="robot1/move_base", error="robot1/move_base did not answer period 200")
    result = result_of(run.ends(1))
    assert result["reason"] == "robot1/move_base: robot1/move_base did not answer period 200"


def test_launch_that_fails_is_quoted(tmp_path):
    result = result_of(FakeRun(tmp_path).prints("RLException: no such package").ends(1))
    assert result["reason"] == "roslaunch: ended with exit code 1"
    assert result["culprit"]["log_lines"] == ["RLException: no such package"]
    assert (result["trajectory_hash"], result["minimum_clearance"]) == (None, None)


@pytest.mark.parametrize(
    ("expected", "later"),
    [
        (Verdict.TIMEOUT, {"end": 12.0}),
        (Verdict.COLLISION, {"end": 4.0, "contacts": {3.0: "Wall_1"}}),
    ],
)
def test_what_happens_after_the_launch_was_killed_does_not_count(tmp_path, expected, later):
    run = FakeRun(tmp_path, scenario(expected)).records(2.0).waits(0.5)
    result = result_of(run.is_killed_while_the_simulator_goes_on(**later))
    assert (result["verdict"], result["passed"]) == ("error", False)
    assert result["reason"] == "roslaunch: ended with exit code -9"


def test_failure_of_the_watch_ends_the_run(tmp_path):
    run = FakeRun(tmp_path).records(4.0).hears(failure=died("runner"))
    assert result_of(run)["reason"] == "runner: was killed by signal 9"


def test_record_that_is_none_is_the_simulators_fault(tmp_path):
    run = FakeRun(tmp_path).records(4.0)
    (tmp_path / "source1.csv").write_text("nonsense\n", encoding="utf-8")
    result = result_of(run.hears(racing(), finished(3.0)))
    assert result["verdict"] == "error"
    assert result["culprit"]["culprit"] == "sim2d"


def test_hang_is_an_error_after_the_wall_limit(tmp_path):
    wanted = scenario()
    hanging = type(wanted)(**{**vars(wanted), "limits": Limits(timeout=10.0, wall=3.0)})
    result = result_of(FakeRun(tmp_path, hanging).records(2.0).prints("waiting"))
    assert result["reason"] == ("runner: not decided after 3 s of wall time (limits.wall), 2.000 s simulated")
    assert result["culprit"]["log_lines"] == ["waiting"]


def test_signal_ends_the_run_and_leaves_a_result(tmp_path):
    run = FakeRun(tmp_path).records(2.0)

    def interrupt(simulated, _wall):
        if simulated is not None:
            signal.raise_signal(signal.SIGTERM)

    with run.stop.listening():
        run.execute(progress=interrupt)
    result = json.loads((run.plan.folder / "interrupted" / "result.json").read_text(encoding="utf-8"))
    assert result["reason"] == "runner: was told to stop by SIGTERM"
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
        ("results.picture.write_picture", "trajectory.png"),
        ("run.run.write_replay", "replay.json.gz"),
        ("run.run.write_trajectory", "trajectory.csv"),
    ],
)
def test_a_file_that_cannot_be_written_does_not_cost_the_verdict(
    tmp_path, monkeypatch, writer, file, error, reason
):
    def fail(*_):
        raise error

    run = succeeding(tmp_path)
    monkeypatch.setattr(f"f1tenth_scenarios.{writer}", fail)
    result = run.execute()
    assert result.not_written == (f"{file}: {reason}",)
    assert f"not written:       {file}: {reason}" in summary(result, run.plan).splitlines()
    written = json.loads((run.plan.folder / "result.json").read_text(encoding="utf-8"))
    assert (written["verdict"], written["not_written"]) == ("success", [f"{file}: {reason}"])
    others = {"trajectory.png", "replay.json.gz", "trajectory.csv"} - {file}
    assert others <= {path.name for path in run.plan.folder.iterdir()}


def test_a_verdict_that_cannot_be_written_is_said(tmp_path, monkeypatch):
    def fail(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("f1tenth_scenarios.results.writing.write_json", fail)
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
    run.prints("[scenario_recorder-9] process has died [pid 12, exit code -6, cmd x].")
    result = run.hears(racing(), finished(3.0)).execute()
    assert result.passed
    (problem,) = result.not_written
    assert problem.startswith(f"replay.json.gz: {run.plan.bag_file}: cannot be read: ")
    assert read_replay(run.plan.folder / "replay.json.gz").goals["robot1"]


def test_log_of_the_culprit_is_told_from_the_folder_of_the_results(tmp_path):
    run = FakeRun(tmp_path).records(4.0).prints("[ERROR] [1] [/robot1/move_base]: cannot go on")
    run.prints("[robot1/move_base-5] process has died [pid 12, exit code -9, cmd x].")
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


def test_progress_is_reported(tmp_path):
    reports = []
    run = FakeRun(tmp_path).records(1.0)

    def report(simulated, wall):
        reports.append((simulated, wall))
        if simulated is not None:
            run.stop.signal = signal.SIGINT

    run.execute(progress=report)
    assert reports[0][0] is None
    assert reports[-1][0] == 1.0
    assert 0.0 <= reports[0][1] < reports[-1][1]
