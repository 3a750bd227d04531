"""A run from start to verdict, with a program in roslaunch's place."""

import signal
import time
from pathlib import Path

import pytest
from f1tenth_judge.scenario.criteria import Criteria
from f1tenth_judge.scenario.scenario import Limits, Verdict
from fake_run import FakeRun, result_of, succeeding
from scenario_samples import aborted, died, finished, racing, reached, scenario


def test_success_is_written_with_all_that_was_measured(tmp_path):
    result = result_of(succeeding(tmp_path))
    assert (result["verdict"], result["expected"], result["passed"]) == ("success", "success", True)
    assert result["reason"] == "every goal was passed in order"
    assert result["times"]["start"] == 0.0
    assert result["times"]["finish"] == 3.0
    assert result["times"]["lap_time"] == 3.0
    assert result["cars"] == {
        "robot1": {
            "planner": "race",
            "driver": "launch file of ROS 1",
            "description": "the F1/10 car",
            "lap_times": [3.0],
            "goals_passed": [0.5, 1.5, 2.5],
            "finish": 2.5,
            "channels": {},
        }
    }
    assert result["winner"] is None
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
    version = (Path(__file__).parents[4] / "VERSION").read_text().strip()
    assert result["versions"]["f1tenth_scenarios"] == version


def test_cost_is_what_a_run_takes_besides_simulating(tmp_path):
    result = result_of(succeeding(tmp_path), started=time.monotonic() - 20.0)
    simulating = result["times"]["finish"] / result["real_time_factor"]
    assert result["times"]["wall"] > 20.0 + simulating
    assert result["times"]["cost"] == pytest.approx(result["times"]["wall"] - simulating)


def test_cost_of_a_run_that_simulates_nothing_is_all_of_its_time(tmp_path):
    times = result_of(FakeRun(tmp_path).ends(1))["times"]
    assert times["cost"] == times["wall"]


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


def placed(stamp, caller="/robot1/planner"):
    return {"time": stamp, "kind": "set_model_state", "caller": caller, "model": "robot1"}


def test_driver_that_places_its_car_ends_the_run_and_is_disqualified(tmp_path):
    result = result_of(FakeRun(tmp_path).records(2.0).notes_interventions(placed(1.5)))
    assert (result["verdict"], result["passed"], result["times"]["finish"]) == ("disqualified", False, 1.5)
    assert result["reason"] == (
        "robot1 is out: /robot1/planner called set_model_state for robot1 at 1.500 s, which the scenario"
        " does not allow"
    )
    assert result["interventions"] == [placed(1.5)]


def test_touch_before_a_reset_counts_though_the_record_begins_anew(tmp_path):
    reset = {"time": 2.0, "kind": "reset_simulation", "caller": "/robot1/planner", "model": ""}
    run = FakeRun(tmp_path, scenario(criteria=Criteria(light_touch=1.5)))
    run.records(2.0, contacts={1.0: "Wall_1"}, contact_speed=2.0).resets().notes_interventions(reset)
    result = result_of(run.records(1.0))
    assert (result["verdict"], result["times"]["finish"]) == ("collision", 1.0)


def test_reset_without_a_touch_disqualifies_by_the_record_before_it(tmp_path):
    reset = {"time": 2.0, "kind": "reset_simulation", "caller": "/somebody", "model": ""}
    result = result_of(FakeRun(tmp_path).records(2.0).resets().notes_interventions(reset).records(0.5))
    assert (result["verdict"], result["times"]["finish"]) == ("disqualified", 2.0)
    assert result["trajectory_hash"] == "hash80"


def test_note_of_an_intervention_that_is_none_is_the_simulators_fault(tmp_path):
    run = FakeRun(tmp_path).records(2.0).notes_interventions({"time": "soon"}).hears(racing(), finished(1.9))
    result = result_of(run)
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "sim2d")


def test_contact_after_the_finish_is_none(tmp_path):
    run = FakeRun(tmp_path).records(4.0, contacts={3.5: "Wall_1"})
    assert result_of(run.hears(racing(), finished(3.0)))["verdict"] == "success"


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
    result = result_of(run.ends_node("robot1/move_base", -9))
    assert result["verdict"] == "error"
    assert result["reason"] == "robot1/move_base: was killed by signal 9"
    assert result["culprit"]["culprit"] == "robot1/move_base"
    assert result["culprit"]["log_lines"] == ["[ERROR] [1] [/robot1/move_base]: cannot go on"]


def test_clean_end_of_a_planner_is_an_error_too(tmp_path):
    run = FakeRun(tmp_path).records(4.0).ends_node("robot1/move_base", 0)
    assert result_of(run)["reason"] == "robot1/move_base: ended with exit code 0"


def test_clean_end_of_a_helper_is_none(tmp_path):
    run = FakeRun(tmp_path).records(4.0).ends_node("race_starter", 0)
    assert result_of(run.hears(racing(), finished(3.0)))["verdict"] == "success"


def test_end_of_a_node_that_somebody_prints_is_none(tmp_path):
    run = FakeRun(tmp_path).records(4.0)
    for said in (
        "[sim2d-2] process has died [pid 12, exit code 3, cmd /x/sim2d].",
        "[robot1/move_base-5] process has finished cleanly",
        "REQUIRED process [sim2d-2] has died!\nprocess has finished cleanly",
        "ERROR: cannot launch node of type [x/y]: x",
    ):
        run.prints(said)
    assert result_of(run.hears(racing(), finished(3.0)))["verdict"] == "success"


def test_race_that_ends_in_the_moment_its_manager_dies_counts(tmp_path):
    run = FakeRun(tmp_path).records(4.0).ends_node("robot1/race_mgr", 3)
    assert result_of(run.hears(racing(), aborted(2.0)))["verdict"] == "aborted"


def test_silent_participant_is_named(tmp_path):
    run = FakeRun(tmp_path).records(4.0)
    run.simulator_says(participant="robot1/move_base", error="robot1/move_base did not answer period 200")
    result = result_of(run.ends(1))
    assert result["reason"] == "robot1/move_base: robot1/move_base did not answer period 200"


def test_run_whose_answers_went_astray_is_told_not_to_be_repeatable(tmp_path):
    stray = {"participant": "robot1", "period": 40, "time": 1.0}
    run = FakeRun(tmp_path).records(4.0).simulator_says(stray_answers=[stray])
    result = result_of(run.hears(racing(), finished(3.0)))
    assert (result["verdict"], result["lockstep"], result["repeatable"]) == ("success", True, False)
    assert result["note"].endswith(
        "not repeatable, as in period 40 (1.000 s) an answer of robot1 to another scan was taken for the one"
        " that was missing"
    )


@pytest.mark.parametrize("lockstep", [True, False])
def test_run_in_lockstep_is_repeatable(tmp_path, lockstep):
    run = FakeRun(tmp_path, scenario(lockstep=lockstep)).records(4.0)
    assert result_of(run.hears(racing(), finished(3.0)))["repeatable"] == lockstep


@pytest.mark.parametrize("key", ["physics_step", "world_sha256", "cars_sha256"])
def test_what_was_simulated_is_what_the_simulator_says(tmp_path, key):
    said = {"physics_step": 0.001, "world_sha256": "0" * 64, "cars_sha256": {"robot1": "1" * 64}}
    (tmp_path / "whole").mkdir()
    (tmp_path / "part").mkdir()
    run = FakeRun(tmp_path / "whole").records(4.0).simulator_says(**said)
    assert result_of(run.hears(racing(), finished(3.0)))["judged"] == said
    del said[key]
    run = FakeRun(tmp_path / "part").records(4.0).simulator_says(**said)
    assert result_of(run.hears(racing(), finished(3.0)))["judged"] is None


def test_launch_that_fails_is_quoted(tmp_path):
    result = result_of(FakeRun(tmp_path).prints("RLException: no such package").ends(1))
    assert result["reason"] == "roslaunch: ended with exit code 1: RLException: no such package"
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
