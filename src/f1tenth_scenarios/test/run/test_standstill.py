"""Simulated time that stands: who keeps it from going on is named, and not who waits."""

import dataclasses

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.run.memory import require_memory
from f1tenth_judge.scenario.scenario import Limits
from fake_run import FakeRun
from patience import PATIENCE
from scenario_samples import scenario

STOPPED = "is stopped by a signal (SIGSTOP, or Ctrl-Z)"
OPENS_FILES = "import resource; resource.setrlimit(resource.RLIMIT_NOFILE, (64, 64))\n" + (
    "files = [open('/dev/null') for _ in range(40)]\n"
)


def run_of(folder, answer=0.5, wall=PATIENCE):
    return FakeRun(
        folder, dataclasses.replace(scenario(), limits=Limits(timeout=10.0, answer=answer, wall=wall))
    )


def reason_of(run):
    return run.execute().reason


def test_a_simulator_that_is_stopped_is_the_culprit(tmp_path):
    run = run_of(tmp_path).records(2.0).starts_node("sim2d", stopped=True)
    assert reason_of(run) == f"sim2d: {STOPPED}"


def test_who_is_stopped_is_the_culprit_when_another_waits_for_it(tmp_path):
    run = run_of(tmp_path).records(2.0).starts_node("race_starter", stopped=True)
    run.simulator_says(participant="robot1/race_mgr", error="robot1/race_mgr did not answer period 80")
    run.ends_node("sim2d", 3)
    assert reason_of(run) == f"race_starter: {STOPPED}"


def test_who_is_stopped_is_no_culprit_of_what_died(tmp_path):
    run = run_of(tmp_path).records(2.0).starts_node("map_server", stopped=True)
    run.ends_node("robot1/move_base", -9)
    assert reason_of(run) == "robot1/move_base: was killed by signal 9"


def test_who_is_stopped_does_not_matter_while_time_goes_on(tmp_path):
    run = run_of(tmp_path).records(1.0).starts_node("map_server", stopped=True).records(10.5)
    assert reason_of(run) == "not finished after 10 s of simulated time; robot1 drove 10.0 m, 3 of 3 goals"


def test_a_process_without_free_descriptors_is_the_culprit(tmp_path):
    run = run_of(tmp_path).records(2.0).starts_node("sim2d", OPENS_FILES)
    reason = reason_of(run)
    assert reason.startswith("sim2d: Too many open files: 4")
    assert reason.endswith(" of the 64 that it may have (ulimit -n)")


def test_time_that_stands_for_no_known_reason_is_the_simulators(tmp_path):
    run = run_of(tmp_path, wall=3.0).records(2.0).starts_node("sim2d")
    assert reason_of(run).startswith("sim2d: simulated time stands at 2.000 s, for ")


def test_too_little_memory_is_said_before_anything_is_started(monkeypatch):
    monkeypatch.setattr("resource.getrlimit", lambda _: (300 << 20, -1))
    with pytest.raises(ScenarioError) as caught:
        require_memory()
    assert str(caught.value) == "ulimit -v lets a process have 315 MB of memory, a run needs 1000 MB"


@pytest.mark.parametrize("limit", [-1, 4 << 30])
def test_enough_memory_is_enough(monkeypatch, limit):
    monkeypatch.setattr("resource.getrlimit", lambda _: (limit, -1))
    require_memory()
