"""Watching a run until something decides it."""

import dataclasses
import time
from typing import TYPE_CHECKING, Callable, Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.judge.interventions import forbidden
from f1tenth_judge.plan.participants import driver_nodes_among, has_proxy_driver
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.interventions import read_interventions
from f1tenth_judge.record.observations import Failure, RaceState, RaceUpdate
from f1tenth_judge.record.pace import Pace
from f1tenth_judge.record.record import STAMP_EPSILON
from f1tenth_judge.run.log_excerpt import LINE_COUNT, last_lines
from f1tenth_judge.run.processes import ProcessTree
from f1tenth_judge.run.so_far import SoFar
from f1tenth_judge.stop_request import StopRequest

from f1tenth_scenarios.launch.launch_events import LaunchEvents
from f1tenth_scenarios.launch.launch_file import driver_mark
from f1tenth_scenarios.launch.prompt_sockets import PromptSockets
from f1tenth_scenarios.run.diagnosis.breakdown import Breakdown
from f1tenth_scenarios.run.diagnosis.culprit import failure_of_driver
from f1tenth_scenarios.run.evidence import Evidence
from f1tenth_scenarios.run.file_tail import LineTail, RecordTail

if TYPE_CHECKING:  # it needs ROS
    from f1tenth_scenarios.run.ros_watch import RosWatch

_POLL_INTERVAL = 0.02  # wall s
# What was recorded before a car said that it is done gets this long (wall s) to arrive.
_RECORD_LAG = 1.0

Progress = Callable[[Optional[float], float], None]


class Supervisor:
    """Looks at record, topics and processes until the run is decided."""

    def __init__(
        self,
        plan: Plan,
        tree: ProcessTree,
        events: LaunchEvents,
        watch: "RosWatch",
        stop: StopRequest,
        progress: Progress,
    ):
        """`progress` is called with the simulated time and the wall time since the start, both s."""
        self._plan = plan
        self._watch = watch
        self._stop = stop
        self._progress = progress
        self._started = time.monotonic()
        self._so_far = SoFar(plan)
        self._record = RecordTail(plan.record_file, self._so_far)
        self._interventions_tail = LineTail(plan.interventions_file)
        self._evidence = Evidence(plan.record_file, plan.interventions_file)
        self._events = events
        self._breakdown = Breakdown(plan, tree, events)
        driven = [car for car in plan.scenario.cars if has_proxy_driver(plan, car.name)]
        self._sockets = PromptSockets(driver_mark(plan, car) for car in driven)
        self._race_over_at: Optional[float] = None
        self._sound_at = 0.0
        self.sound_until: Optional[float] = None  # s, nothing as long as the set-up is whole
        self.updates: list[RaceUpdate] = []
        self.pace = Pace()

    def pid(self, node: str) -> Optional[int]:
        """A node's process; nothing before it was started."""
        return self._events.pids.get(node)

    def note(self) -> str:
        """What the run has done without, in words; empty if nothing."""
        missing = "; ".join(self._breakdown.missing_views())
        views = f"without what is for people only: {missing}" if missing else ""
        delays = (
            f"messages between nodes of a driver may come late ({self._sockets.refusal})"
            if self._sockets.refusal
            else ""
        )
        return "; ".join(filter(None, (views, delays)))

    def wait(self) -> Optional[Failure]:
        """Return when the run is decided; with a failure if the set-up broke."""
        while True:
            self._poll()
            failure = self._broken()
            # What somebody changed may be why something broke.
            if self._is_disqualified() or (self.sound_until is None and self._decided()):
                return self._watch.mixed_up()
            if self.sound_until is None:
                failure = self._failure()
            if failure:
                self._poll()
                return failure
            self._progress(self._so_far.time, self._elapsed())
            time.sleep(_POLL_INTERVAL)

    def tampering(self, at_end: bool = True) -> Optional[Failure]:
        """Whether somebody changed what the simulator recorded: then nothing of it can be believed."""
        problem = self._evidence.problem_at_end() if at_end else self._evidence.problem()
        if not problem:
            return None
        reason = f"{problem}; no process of the run does that"
        started = {car: driver_nodes_among(car, self._events.pids) for car in self._plan.cars}
        drivers = [(car, nodes) for car, nodes in started.items() if nodes]
        failure = Failure("runner", reason)
        if len(drivers) == 1:
            failure = failure_of_driver(self._plan, *drivers[0], reason)
        return dataclasses.replace(failure, stamp=0.0)

    def _broken(self) -> Optional[Failure]:
        """Who broke the set-up; from then on nothing is decided by the record, which may go on."""
        standing = self.pace.standing(self._elapsed())
        failure = self._breakdown.failure(self.updates, self._done(), standing)
        if not self._breakdown.is_seen:
            self._sound_at = self._so_far.time or 0.0
        elif self.sound_until is None:
            self.sound_until = self._sound_at
        return failure

    def _decided(self) -> bool:
        return self._so_far.is_cut_short(self.updates) or self._is_race_over()

    def _is_race_over(self) -> bool:
        """Whether every task is done; outside lockstep the record lags behind what cars say of themselves."""
        if not self._so_far.is_race_over(self.updates):
            return False
        if self._race_over_at is None:
            self._race_over_at = time.monotonic()
        said = max((update.stamp for update in self.updates), default=0.0)
        shown = self._so_far.time is not None and self._so_far.time + STAMP_EPSILON >= said
        return shown or time.monotonic() - self._race_over_at > _RECORD_LAG

    def _is_disqualified(self) -> bool:
        """Whether somebody changed the world who may not, or what was noted of it cannot be read."""
        if not self._interventions_tail.new_lines():
            return False
        try:
            seen = read_interventions(self._plan.interventions_file)
        except ScenarioError:
            return True
        return any(True for _ in forbidden(self._plan.scenario, seen))

    def _poll(self) -> None:
        self.updates += self._watch.take()
        self._record.poll()
        self._events.poll()
        self._sockets.poll()
        self.pace.note(self._so_far.time, self._elapsed())

    def _elapsed(self) -> float:
        return time.monotonic() - self._started

    def _failure(self) -> Optional[Failure]:
        if self._stop.signal:
            return Failure("runner", f"was told to stop by {self._stop.signal.name}")
        if self._elapsed() > self._plan.scenario.limits.wall:
            return self._hang()
        if tampering := self.tampering(at_end=False):
            return tampering
        return self._watch.failure(self._done())

    def _done(self) -> set[str]:
        """The cars that have finished."""
        said = {update.car for update in self.updates if update.state is RaceState.FINISHED}
        shown = {car for car, finish in self._so_far.finishes().items() if finish is not None}
        return said | {car for car in shown if not self._plan.tasks[car].reports}

    def _hang(self) -> Failure:
        limits, simulated = self._plan.scenario.limits, self._so_far.time
        standing = self.pace.standing(self._elapsed())
        if simulated is not None and standing >= limits.answer:
            culprit = "sim2d"
            reason = (
                f"simulated time stands at {simulated:.3f} s, for {standing:.0f} s of wall time (limits.wall)"
            )
        else:
            culprit = "runner"
            reached = "nothing" if simulated is None else f"{simulated:.3f} s"
            reason = f"not decided after {limits.wall:g} s of wall time (limits.wall), {reached} simulated"
        return Failure(
            culprit,
            reason,
            str(self._plan.launch_log),
            tuple(last_lines(self._plan.launch_log, LINE_COUNT)),
        )
