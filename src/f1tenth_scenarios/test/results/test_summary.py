"""What a person reads of a run."""

import dataclasses

from f1tenth_judge.results.console import summary
from fake_run import FakeRun
from scenario_samples import died, finished, racing, reached, scenario


def test_summary_has_all_that_make_race_prints(tmp_path):
    run = FakeRun(tmp_path).records(4.0)
    result = run.hears(racing(), finished(3.0)).execute()
    assert summary(result, run.plan).splitlines() == [
        "scenario:          sample",
        "verdict:           success (expected success)",
        "passed:            yes",
        "reason:            every goal was passed in order",
        "note:              the best lap, 3.000 s, is quicker than the reference of 4.497 s,"
        " whose tyres are those of friction alone",
        "driver:            race (launch file of ROS 1)",
        "lap time:          3.000 s",
        "reference:         4.497 s (fastest flying lap possible);"
        " this lap, from standstill, took 0.67 times as long",
        "minimum clearance: 0.500 m",
        "real-time factor:  none",
        f"cost:              {result.cost:.1f} s besides simulating",
        f"result:            {run.plan.folder}/result.json",
        f"picture:           {run.plan.folder}/trajectory.png",
    ]


def test_summary_lists_the_laps_if_there_are_several(tmp_path):
    run = FakeRun(tmp_path, scenario(laps=2, timeout=20.0)).records(8.0, speed=0.5)
    run.hears(racing(), reached(4.0, 3), reached(7.5, 6))
    lines = summary(run.execute(), run.plan).splitlines()
    assert "lap time:          3.500 s" in lines
    assert "laps of robot1:    4.000 s, 3.500 s" in lines
    assert any(line.endswith("the best lap took 0.78 times as long") for line in lines)


def test_summary_has_no_reference_for_what_is_no_lap_of_a_circuit(tmp_path):
    run = FakeRun(tmp_path, dataclasses.replace(scenario(), world="circuit2")).records(4.0)
    run.hears(racing(), finished(3.0))
    assert "reference:" not in summary(run.execute(), run.plan)


def test_summary_compares_a_lap_of_a_track_with_the_raceline_beside_it(tmp_path):
    raceline = tmp_path / "square_raceline.csv"
    raceline.write_text("".join(f"0; {x}; {y}; 0; 0; 2.0; 0\n" for x, y in ((0, 0), (4, 0), (4, 4), (0, 4))))
    run = FakeRun(tmp_path, dataclasses.replace(scenario(), world="circuit2")).records(4.0)
    run.plan = dataclasses.replace(run.plan, place=dataclasses.replace(run.plan.place, raceline=raceline))
    run.hears(racing(), finished(3.0))
    assert (
        "reference:         8.000 s (square_raceline.csv at its speeds);"
        " this lap, from standstill, took 0.38 times as long"
    ) in summary(run.execute(), run.plan).splitlines()


def test_summary_of_an_interrupted_run_leads_to_no_replay(tmp_path):
    run = FakeRun(tmp_path).records(1.0).hears(failure=died())
    result = run.execute()
    assert "\nreplay:" in summary(result, run.plan)
    interrupted = dataclasses.replace(result, folder=result.folder / "interrupted")
    assert "\nreplay:" not in summary(interrupted, run.plan)


def test_summary_of_a_failure_quotes_the_culprit(tmp_path):
    run = FakeRun(tmp_path).records(1.0).hears(failure=died())
    lines = summary(run.execute(), run.plan).splitlines()
    assert "failed:            verdict: error, limit success" in lines
    assert "failed:            goals_in_order: 1 goal, limit 3 goals" in lines
    assert "log:               /log/move_base.log" in lines
    assert "                   last words" in lines
    assert "lap time:          none" in lines
    assert "real-time factor:  none" in lines
