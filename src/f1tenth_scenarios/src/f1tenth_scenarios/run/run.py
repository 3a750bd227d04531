"""One run of a scenario: start, watch, end, judge, keep."""

import contextlib
import dataclasses
import time
from collections.abc import Mapping, Sequence
from typing import Callable, Optional

from f1tenth_scenarios import versions
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.judge import criteria
from f1tenth_scenarios.judge.driving_criteria import least_clearance
from f1tenth_scenarios.judge.false_start import race_start
from f1tenth_scenarios.judge.judge import judge
from f1tenth_scenarios.judge.laps import lap_times
from f1tenth_scenarios.judge.measured import Measured
from f1tenth_scenarios.launch.launch_file import write_launch_file
from f1tenth_scenarios.launch.processes import ProcessTree
from f1tenth_scenarios.record.observations import Failure, Observations
from f1tenth_scenarios.record.record import Record, read_record
from f1tenth_scenarios.record.recording import Recording
from f1tenth_scenarios.record.replay import REPLAY_FILE, write_replay
from f1tenth_scenarios.record.track_map import TrackMap, read_track_map
from f1tenth_scenarios.results import result
from f1tenth_scenarios.results.result import Result
from f1tenth_scenarios.results.results_folder import claimed
from f1tenth_scenarios.run.preparation import Preparation
from f1tenth_scenarios.run.supervisor import Progress, Supervisor, Watch
from f1tenth_scenarios.scenario.plan import Plan
from f1tenth_scenarios.stop_request import StopRequest

_SHUTDOWN_GRACE = 12.0  # wall s, for roslaunch to end its nodes


def execute(
    plan: Plan,
    command: Sequence[str],
    environment: Mapping[str, str],
    make_watch: Callable[[], Watch],
    stop: StopRequest,
    progress: Progress = lambda simulated, wall: None,
    started: Optional[float] = None,
) -> Result:
    """Run a scenario and write its results.

    Args:
        plan: what to run
        command: starts everything
        environment: variables for it besides our own
        make_watch: begins to listen; called before any node is started
        stop: tells the run to end
        progress: is called with simulated time (s, nothing before the first period) and wall time (s)
        started: since when the run costs time, as time.monotonic() counts; default: now

    Raises:
        ScenarioError: the results folder cannot be used, or another run is using it.
    """
    started = time.monotonic() if started is None else started
    with claimed(plan.folder, plan.log_folder, versions.commit()):
        write_launch_file(plan)
        watch = make_watch()
        with _started(plan, command, environment) as tree:
            done = _drive(plan, tree, watch, stop, progress)
        done = dataclasses.replace(done, wall_time=time.monotonic() - started)
        # Last, because who sees a result.json may rely on the other files.
        result.write_json(
            plan.folder / result.RESULT_FILE, result.as_dict(done, versions.collect(), plan.settings)
        )
    return done


@contextlib.contextmanager
def _started(plan, command, environment):
    """All that is started; ended at the end."""
    tree = ProcessTree(command, plan.launch_log, environment)
    try:
        yield tree
    finally:
        tree.stop(_SHUTDOWN_GRACE)


def _drive(plan, tree, watch, stop, progress) -> Result:
    with contextlib.closing(watch):
        preparation = Preparation(plan.run_world, watch.descriptions)
        supervisor = Supervisor(plan, tree, watch, stop, preparation.beside(progress))
        failure = supervisor.wait()
        # The others may take their time to end, the simulator completes its record.
        tree.interrupt(supervisor.simulator_pid, _SHUTDOWN_GRACE)
        seen = _observations(plan, supervisor, watch, failure)
        heard = watch.recording()
        preparation.begin()
    done = _judge(plan, seen, heard, supervisor.pace.factor)
    _write(plan, done, heard, preparation)
    return done


def _observations(plan, supervisor, watch, failure) -> Observations:
    record, failure = _read_record(plan, failure)
    watch.catch_up(record.end or 0.0)
    return Observations(record, tuple(supervisor.updates), failure, watch.collided())


def _read_record(plan, failure):
    try:
        return read_record(plan.record_file), failure
    except ScenarioError as error:
        return Record({}), failure or Failure("sim2d", str(error))


def _judge(plan, seen, heard, real_time_factor) -> Result:
    judgement = judge(plan.scenario, plan.all_goals, seen)
    deciding = judgement.decision.stamp
    measured = Measured(
        start=race_start([update for update in seen.updates if update.stamp <= deciding]),
        lap_times=lap_times(plan.scenario, judgement, seen.updates),
        real_time_factor=real_time_factor,
        estimates={car: poses.until(deciding) for car, poses in heard.estimates.items()},
        course=plan.course,
    )
    judged = tuple(criteria.evaluate(plan.scenario, judgement, measured))
    return Result(plan.name, plan.scenario, judgement, judged, measured)


def _write(plan: Plan, done: Result, heard: Recording, preparation: Preparation) -> None:
    result.write_trajectory(plan.folder / result.TRAJECTORY_FILE, done.judgement.record)
    lines = (f"{done.judgement.decision.verdict.value}: {done.reason}", _facts(done))
    picture = plan.folder / result.PICTURE_FILE
    preparation.picture().write_picture(
        picture, plan.name, lines, done.judgement.record, plan.goals, _track_map(plan)
    )
    replay = preparation.scene().replay(plan.goals, heard).until(done.judgement.decision.stamp)
    write_replay(plan.folder / REPLAY_FILE, replay)


def _track_map(plan: Plan) -> Optional[TrackMap]:
    """Nothing if it cannot be read, as map_server has said already."""
    try:
        return read_track_map(plan.map) if plan.map else None
    except ScenarioError:
        return None


def _facts(done: Result) -> str:
    facts = [
        ("lap time", done.best_lap_time, "s"),
        ("minimum clearance", least_clearance(done.judgement), "m"),
    ]
    return ", ".join(f"{name} {value:.3f} {unit}" for name, value, unit in facts if value is not None)
