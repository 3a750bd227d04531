"""A planner that speaks ROS 2, started by a command, as the driver of a car."""

import contextlib
import os
import shlex
import textwrap
import time
from collections.abc import Iterator, Sequence
from typing import Optional

import f1tenth_sim2d
from f1tenth_judge.drivers.proxy_driver import ProxyDriver
from f1tenth_judge.drivers.ros2.car_topics import CarTopics
from f1tenth_judge.drivers.ros2.connection import Connection
from f1tenth_judge.drivers.ros2.isolation import child_environment, private_domain
from f1tenth_judge.drivers.ros2.launch_output import dead_processes, output_of_raiser
from f1tenth_judge.drivers.ros2.own_topics import OwnTopics
from f1tenth_judge.drivers.ros2.planner_view import PlannerView
from f1tenth_judge.drivers.ros2.shared_memory import remove_what_is_left
from f1tenth_judge.drivers.ros2.why_mute import NO_CLOCK, ignores_clock, mismatched, why_mute
from f1tenth_judge.errors import MismatchError, NotAtRestError
from f1tenth_judge.places.map_file import Grid
from f1tenth_judge.plan.hand_off import given_arguments
from f1tenth_judge.plan.pins import variables_of
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.observations import Failure
from f1tenth_judge.run.command_watch import CommandCount, CommandWatch
from f1tenth_judge.run.log_excerpt import exception_in, last_lines, quoted
from f1tenth_judge.run.outcome import track_map
from f1tenth_judge.run.processes import ProcessTree
from f1tenth_judge.run.stage import Stage
from f1tenth_judge.stop_request import StopRequest

_MARK = "F1TENTH_DRIVER"  # in the environment of the planner's processes
_NOT_AT_REST = "has not come to rest within {:g} s of wall time (limits.answer)"
_GRACE = 4.0  # wall s, to end after SIGINT
_WIDTH = 200  # characters, of its last words
_COUNT_INTERVAL = 1.0  # simulated s, between two looks at the commands


class Ros2Driver:
    """Starts a command in a domain of its own, and drives as its nodes say."""

    def __init__(self, plan: Plan, stage: Stage, car: str, grid: Optional[Grid], stop: StopRequest):
        """Start the planner of a car; its output goes to CAR.log in the plan's log folder.

        CAR.env there tells which variables it was given.

        Raises:
            ScenarioError: no domain is left.
        """
        self._car, self._limits, self._in_lockstep = car, plan.scenario.limits, plan.scenario.lockstep
        self._log = plan.log_folder / f"{car}.log"
        self._watch = CommandWatch([car], self._limits.silence, _time_to_load(plan))
        self._counted = 0.0  # s, when the commands were looked at last
        self._accepted, self._refused, self._refusal = 0, 0, ""
        self._not_at_rest: Optional[NotAtRestError] = None
        with contextlib.ExitStack() as opened:
            domain = opened.enter_context(private_domain())
            self._connection = Connection(domain)
            opened.callback(self._connection.close)
            self._topics = CarTopics(self._connection, stage, car, grid)
            self._own_topics = OwnTopics(self._connection, stage, car)
            self._view = PlannerView(self._connection, self._topics, lambda: self._has_ended(stop))
            mark = f"{car} of {plan.folder}"
            variables = {
                "PYTHONUNBUFFERED": "1",
                "ROS_LOG_DIR": str(plan.log_folder),
                # `ros2 launch` keeps what a node says from its own output unless the launch file asks for it.
                "OVERRIDE_LAUNCH_PROCESS_OUTPUT": "screen",
                **variables_of(plan.scenario, os.environ),
                **child_environment(domain),
                _MARK: mark,
            }
            environment_file = plan.log_folder / f"{car}.env"
            environment_file.write_text("".join(f"{name}={value}\n" for name, value in variables.items()))
            opened.callback(remove_what_is_left, time.time())
            self._tree = ProcessTree(["bash", "-c", _command(plan, car)], self._log, variables)
            opened.callback(self._tree.stop, _GRACE)
            self._proxy = ProxyDriver(self._view, f"{_MARK}={mark}", self._limits.answer, self._limits.load)
            self._opened = opened.pop_all()

    def begin(self) -> None:
        """Let it load and connect; see Driver."""
        if self._in_lockstep:
            with self._named_mismatch():
                self._proxy.begin()

    def act(self, stage: Stage) -> None:
        """Let it handle a period; see Driver."""
        has_sent = self._topics.publish_sensed()
        if self._in_lockstep:
            try:
                with self._named_mismatch():
                    self._proxy.act(stage.time, has_sent)
            except NotAtRestError as error:
                self._not_at_rest = error
        else:
            self._view.publish_scans()
            self._view.publish_clock(stage.time)
        for command in self._view.new_commands():
            try:
                stage.command(self._car, command)
                self._accepted += 1
            except f1tenth_sim2d.Error as error:
                self._refused, self._refusal = self._refused + 1, str(error)
        self._own_topics.take()

    def failure(self, time: float, is_done: bool) -> Optional[Failure]:
        """Why it is of no use; see Driver."""
        if is_done:
            return None
        code = self._tree.exit_code()
        if code is not None:
            return self._failed(f"ended with exit code {code}", time)
        if self._not_at_rest:
            return self._failed(_NOT_AT_REST.format(self._limits.answer), time)
        if time - self._counted >= _COUNT_INTERVAL:
            self._counted = time
            self._watch.take(CommandCount(time, self._car, self._accepted, self._refused, self._refusal))
        for problem in self._watch.problems(set()):
            clues = why_mute(self._connection) if problem.is_mute else []
            return self._failed(problem.text, problem.stamp, clues)
        return None

    def note(self) -> str:
        """What does not fit, and did not keep it from driving."""
        found = mismatched(self._connection)
        found += [NO_CLOCK] if ignores_clock(self._connection) else []
        found += dead_processes(last_lines(self._log))
        found += [*self._topics.note(), *self._own_topics.note()]
        return "; ".join(f"{self._car}: {each}" for each in found)

    def close(self) -> None:
        """End the planner, and leave its domain."""
        self._opened.close()

    @contextlib.contextmanager
    def _named_mismatch(self) -> Iterator[None]:
        try:
            yield
        except MismatchError as mismatch:
            why = f"the driver of {self._car} does not fit lockstep: {mismatch}"
            raise MismatchError(why) from mismatch

    def _has_ended(self, stop: StopRequest) -> bool:
        return bool(stop.signal) or self._tree.exit_code() is not None

    def _failed(self, reason: str, time: float, clues: Sequence[str] = ()) -> Failure:
        lines = output_of_raiser(last_lines(self._log))
        why = [reason, *dead_processes(lines)]
        if raised := exception_in(lines):
            why.append(f"it raised {raised}")
        elif lines and why == [reason] and self._tree.exit_code() is not None:
            why.append(f"its last words: {textwrap.shorten(lines[-1], _WIDTH)}")
        why += clues
        return Failure(f"{self._car}/planner", "; ".join(why), str(self._log), tuple(quoted(lines)), time)


def _time_to_load(plan: Plan) -> float:
    """Simulated time (s) for which a planner may load: none in lockstep, where time waits for it."""
    scenario = plan.scenario
    return 0.0 if scenario.lockstep else scenario.limits.load * scenario.real_time_factor


def _command(plan: Plan, name: str) -> str:
    car = next(each for each in plan.scenario.cars if each.name == name)
    told = given_arguments(plan, car).items()
    return " ".join([car.driver.ros2, *(shlex.quote(f"{name}:={value}") for name, value in told)])


def ros2_drivers(
    plan: Plan, stage: Stage, stop: StopRequest, stack: contextlib.ExitStack
) -> dict[str, Ros2Driver]:
    """The drivers of a plan whose planners all speak ROS 2; see run.execute.Drivers."""
    grid = track_map(plan)
    return {
        car: stack.enter_context(contextlib.closing(Ros2Driver(plan, stage, car, grid, stop)))
        for car in stage.cars
    }
