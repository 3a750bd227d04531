"""Noticing that the set-up of a run broke: a node that ended, a planner that fell silent."""

import time
from collections.abc import Sequence
from typing import Optional

from f1tenth_judge.drivers.proxy_driver import EXIT_MISMATCH
from f1tenth_judge.errors import MismatchError
from f1tenth_judge.plan.participants import PROXY_DRIVER, driver_nodes_among, named_nodes
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.files import read_json
from f1tenth_judge.record.observations import Failure, RaceState, RaceUpdate
from f1tenth_judge.run.log_excerpt import last_lines
from f1tenth_judge.run.processes import ProcessTree, program_of

from f1tenth_scenarios.launch.bag import RECORDER
from f1tenth_scenarios.launch.launch_events import LaunchEvents, NodeEnd
from f1tenth_scenarios.launch.private_master import master_process
from f1tenth_scenarios.launch.system_limits import hindered
from f1tenth_scenarios.run.diagnosis.culprit import Signs, failure_of

# What was said just before a node ended gets this long (wall s) to arrive.
_LAST_WORDS = 0.5
# The same for one killed by a signal, which is nobody else's fault: only its output may still be on its way.
_LAST_OUTPUT = 0.1


_GAZEBO = ("gazebo_ros/", "f1tenth_sim2d/sim2d")
_SECOND_SIMULATOR = (
    "is {}: the run has a simulator, a map and a car of its own; leave Gazebo and what is spawned in it out"
    " of the planner's launch file"
)


class Breakdown:
    """Looks at the processes of a run."""

    def __init__(self, plan: Plan, tree: ProcessTree, events: LaunchEvents):
        self._plan = plan
        self._tree = tree
        self._events = events
        self._seen_at: Optional[float] = None
        self._known: set[int] = set()  # processes that are not simulators

    @property
    def is_seen(self) -> bool:
        """Whether something has broken, though its last words may not be there yet."""
        return self._seen_at is not None

    def missing_views(self) -> list[str]:
        """Nodes that were to show something or to be steered by hand and are not there, and why."""
        return [f"{end.node} {end.describe()}" for end in self._events.ends if end.is_for_people]

    def failure(self, updates: Sequence[RaceUpdate], done: set[str], standing: float) -> Optional[Failure]:
        """Who broke the set-up, as soon as its last words can be there.

        `done`: the cars that have finished, whose drivers may end; `standing`: for how long simulated time
        has not gone on, wall s.

        Raises:
            MismatchError: a car's driver does not fit lockstep.
        """
        self._look_for_mismatch()
        if second := self._second_simulator():
            self._seen_at = time.monotonic()
            return second
        ends = [end for end in self._events.ends if self._is_fatal(end, done)]
        lost = [each for each in updates if each.state in (RaceState.LOST, RaceState.STOPPED)]
        exit_code = self._tree.exit_code()
        stuck = self._hindered() if standing >= self._plan.scenario.limits.answer else None
        if not (ends or lost or stuck or exit_code is not None):
            return None
        if self._seen_at is None:
            self._seen_at = time.monotonic()
        killed = any(end.exit_code < 0 for end in ends)
        words_may_come = time.monotonic() - self._seen_at < (_LAST_OUTPUT if killed else _LAST_WORDS)
        if words_may_come and not stuck:
            return None
        result = read_json(self._plan.simulator_result_file)
        signs = Signs(ends, lost, exit_code, result, tuple(self._events.pids), stuck or self._hindered())
        return failure_of(self._plan, signs)

    def _hindered(self) -> Optional[tuple[str, str]]:
        return hindered({**self._events.pids, **master_process()})

    def _second_simulator(self) -> Optional[Failure]:
        """A simulator that a planner's launch file brings along, or what spawns a car in one."""
        for node, pid in self._events.pids.items():
            program = "" if pid in self._known else program_of(pid)
            if node != "sim2d" and program.startswith(_GAZEBO):
                return Failure(node, _SECOND_SIMULATOR.format(program), str(self._plan.launch_log))
            if program:
                self._known.add(pid)
        return None

    def _look_for_mismatch(self) -> None:
        for car in self._plan.cars:
            proxy = f"{car}/{PROXY_DRIVER}"
            if any((end.node, end.exit_code) == (proxy, EXIT_MISMATCH) for end in self._events.ends):
                said = [line for line in last_lines(self._plan.launch_log) if f"[/{proxy}]: " in line]
                why = said[-1].partition(f"[/{proxy}]: ")[2] if said else "its proxy driver does not say why"
                raise MismatchError(f"the driver of {car} does not fit lockstep: {why}")

    def _is_fatal(self, end: NodeEnd, done: set[str]) -> bool:
        if end.is_required:
            return True
        # Without a bag, the replay has no plans; the verdict stands.
        if end.node == RECORDER or end.is_for_people:
            return False
        return end.exit_code != 0 or self._must_live(end.node, done)

    def _must_live(self, node: str, done: set[str]) -> bool:
        """Whether a node may not even end in order: simulator, proxy, a driver's named nodes or its last."""
        car, _, name = node.partition("/")
        if node == "sim2d" or (name == PROXY_DRIVER and car not in done):
            return True
        if car not in self._plan.cars or car in done or not driver_nodes_among(car, [node]):
            return False
        return node in named_nodes(self._plan, car) or not self._living(car)

    def _living(self, car: str) -> set[str]:
        return set(driver_nodes_among(car, self._events.pids)) - {end.node for end in self._events.ends}
