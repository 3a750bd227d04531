"""One run of a scenario: start, watch, end, judge, keep."""

import contextlib
import dataclasses
import time
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Callable, Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.files import BAG_FILE, REPLAY_FILE, read_json
from f1tenth_judge.record.interventions import read_interventions
from f1tenth_judge.record.observations import Failure, Observations
from f1tenth_judge.record.record import Record, first_record, read_record
from f1tenth_judge.record.replay import Replay
from f1tenth_judge.results import versions
from f1tenth_judge.results.result import Result
from f1tenth_judge.results.results_folder import claimed
from f1tenth_judge.results.writing import write_rest, write_verdict
from f1tenth_judge.run.outcome import Files, files_of_record, judged, worth_a_wait, write_scene
from f1tenth_judge.run.processes import ProcessTree
from f1tenth_judge.stop_request import StopRequest

from f1tenth_scenarios.launch.bag import RECORDER, dropped
from f1tenth_scenarios.launch.bag_reader import read_bag
from f1tenth_scenarios.launch.launch_events import LaunchEvents
from f1tenth_scenarios.launch.launch_file import write_launch_file
from f1tenth_scenarios.run.preparation import Preparation
from f1tenth_scenarios.run.supervisor import Progress, Supervisor

if TYPE_CHECKING:  # it needs ROS
    from f1tenth_scenarios.run.ros_watch import RosWatch

# Wall s, for roslaunch to end its nodes; it takes 3.5 s for those that do not listen, which nobody who has
# pressed Ctrl-C waits for.
_SHUTDOWN_GRACE, _HURRIED_GRACE = 4.5, 2.0

_INPUTS = ("physics_step", "world_sha256", "cars_sha256")  # keys of the simulator's result


def execute(
    plan: Plan,
    command: Sequence[str],
    environment: Mapping[str, str],
    make_watch: Callable[[], "RosWatch"],
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
    with claimed(plan.folder, plan.log_folder, versions.commits(plan.driver_folders)) as claim:
        _prepare(plan)
        watch = make_watch()
        with _started(plan, command, environment, stop) as (tree, events):
            done, preparation, recorder = _drive(plan, tree, events, watch, stop, progress)
            # No run can be compared with one that was told to stop.
            folder = claim.place_of_interrupted() if stop.signal else claim.place_of_results()
            done = dataclasses.replace(done, folder=folder, wall_time=time.monotonic() - started)
            # First, because whatever else cannot be written must not cost the verdict.
            write_verdict(plan, done)
            problems = write_rest(
                folder, worth_a_wait(files_of_record(plan, done, preparation.picture), stop)
            )
            tree.interrupt(recorder, _grace(stop))
            bag = _Bag(plan)
            problems += write_rest(folder, worth_a_wait(bag.files(done, preparation), stop))
            problems += tuple(bag.left_out)
        plan.bag_file.unlink(missing_ok=True)
        wall_time = time.monotonic() - started
        done = dataclasses.replace(done, wall_time=wall_time, not_written=problems, published=bag.published)
        with contextlib.suppress(ScenarioError):  # what it wrote before was complete except for the time
            write_verdict(plan, done)
    return done


def _prepare(plan: Plan) -> None:
    try:
        write_launch_file(plan)
    except OSError as error:
        raise ScenarioError(f"{plan.log_folder}: cannot begin the run: {error.strerror}") from error


@contextlib.contextmanager
def _started(plan, command, environment, stop):
    """All that is started, ended at the end; and what it tells of its nodes."""
    with contextlib.closing(LaunchEvents()) as events:
        tree = ProcessTree(command, plan.launch_log, {**environment, **events.variables}, [events.pipe])
        try:
            yield tree, events
        finally:
            tree.stop(_grace(stop))


def _grace(stop: StopRequest) -> float:
    return _HURRIED_GRACE if stop.signal else _SHUTDOWN_GRACE


def _drive(plan, tree, events, watch, stop, progress) -> tuple[Result, Preparation, Optional[int]]:
    """The run, judged; what was prepared beside it; and the process that writes the bag, which may go on."""
    with contextlib.closing(watch):
        preparation = Preparation(plan.run_world, watch.descriptions)
        supervisor = Supervisor(plan, tree, events, watch, stop, preparation.beside(progress))
        failure = supervisor.wait()
        # The others may take their time to end, the simulator completes its record.
        tree.interrupt(supervisor.pid("sim2d"), _grace(stop))
        seen = _observations(plan, supervisor, watch, failure)
        done = judged(plan, seen, supervisor.pace.factor, watch.estimates())
        said = read_json(plan.simulator_result_file)
        strays = _strays(said)
        note = "; ".join(filter(None, (done.note, supervisor.note(), *strays)))
        done = dataclasses.replace(done, note=note, inputs=_inputs(said), is_repeatable=not strays)
        if not stop.signal:
            preparation.begin()
    return done, preparation, supervisor.pid(RECORDER)


def _strays(said: Mapping[str, Any]) -> list[str]:
    """The answers for which the simulator took others, by which a run is like no second one, in words."""
    return [
        f"not repeatable, as in period {each['period']} ({each['time']:.3f} s) an answer of"
        f" {each['participant']} to another scan was taken for the one that was missing"
        for each in said.get("stray_answers", ())
    ]


def _inputs(said: Mapping[str, Any]) -> Optional[dict[str, Any]]:
    """What the simulator says that it has simulated; None if it says nothing."""
    return {key: said[key] for key in _INPUTS} if said.keys() >= {*_INPUTS} else None


def _observations(plan, supervisor, watch, failure) -> Observations:
    record, interventions = Record({}), []
    failure = failure or supervisor.tampering()
    try:
        record = read_record(first_record(plan.record_file))
        interventions = read_interventions(plan.interventions_file)
    except ScenarioError as error:
        failure = failure or Failure("sim2d", str(error), stamp=0.0)
    return Observations(
        record, tuple(supervisor.updates), failure, tuple(interventions), supervisor.sound_until
    )


class _Bag:
    """The bag of a run, which is complete when its recorder has ended."""

    def __init__(self, plan: Plan):
        self._plan = plan
        self.left_out: list[str] = []  # what was too much for a file, in words
        self.published = Replay()

    def files(self, done: Result, preparation: Preparation) -> Files:
        """The files that need it."""
        if done.judgement.record.end is None and not self._plan.bag_file.exists():
            return {}  # nothing was started that could be recorded

        def write(path):
            try:
                cars = [car.name for car in self._plan.scenario.cars]
                self.published, too_much = read_bag(self._plan.bag_file, cars)
                self.left_out += [f"{REPLAY_FILE}: {each}" for each in too_much]
            finally:
                write_scene(path, self._plan, done, preparation.scene(), self.published)

        def keep(path):
            self.left_out += [f"{BAG_FILE}: {each}" for each in dropped(self._plan.bag_file)]
            self._plan.bag_file.rename(path)

        is_kept = self._plan.keep_bag or not done.passed
        return {REPLAY_FILE: write, **({BAG_FILE: keep} if is_kept else {})}
