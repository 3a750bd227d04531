"""What is heard of a run on topics."""

import dataclasses
import queue
import time
from typing import Optional

import rospy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from f1tenth_judge.drivers.rest import marked_processes
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.participants import STARTER
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.observations import Failure, RaceState, RaceUpdate
from f1tenth_judge.record.replay import Poses
from f1tenth_judge.run.command_watch import CommandCount, CommandWatch, Problem
from f1tenth_judge.said.plane import planar
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import Odometry
from std_msgs.msg import Int32

from f1tenth_race_mgr.msg import RaceStatus
from f1tenth_scenarios.launch.launch_file import driver_mark
from f1tenth_scenarios.run.diagnosis.culprit import failure_of_driver
from f1tenth_scenarios.run.diagnosis.endless import computes_without_pause
from f1tenth_scenarios.run.diagnosis.unconnected_topics import (
    driver_nodes,
    meddling,
    shared_topic,
    topics_of,
    why_mute,
)
from f1tenth_scenarios.run.events.director import Director
from f1tenth_scenarios.run.ros_graph import ask, misread_by, publications_of, read_graph
from f1tenth_scenarios.senders import heard_from, sender

_PATIENCE, _LOOK_INTERVAL = 2.0, 0.005  # wall s
_GRAPH_INTERVAL = 0.5  # wall s between two looks at who hears whom
_ENDLESS = "computes without a pause, as in a loop or callback that never ends"
_COMMANDS_OF, _REFUSED = "sim2d: commands of ", "refused: "  # in the simulator's diagnostics


def to_update(car: str, message: RaceStatus) -> RaceUpdate:
    """A message of a car's race_mgr as a RaceUpdate."""
    return RaceUpdate(
        car, message.header.stamp.to_sec(), RaceState(message.state), message.goals_reached, message.text
    )


def to_count(stamp: float, status: DiagnosticStatus) -> CommandCount:
    """What the simulator says of the commands of a car at a stamp (s)."""
    values = {each.key: each.value for each in status.values}
    car, refusal = status.name[len(_COMMANDS_OF) :], status.message.removeprefix(_REFUSED)
    return CommandCount(stamp, car, int(values["accepted"]), int(values["refused"]), refusal)


def _steady_cars(plan: Plan) -> list[str]:
    """Those whose drivers send commands all the time: not while they wait for a start signal or a goal."""
    return [
        car
        for car, planned in plan.cars.items()
        if not planned.driver.needs_countdown and not planned.task.is_empty
    ]


def _time_to_load(plan: Plan) -> float:
    """Simulated time (s) for which a driver may load: none in lockstep, where time waits for it."""
    scenario = plan.scenario
    return 0.0 if scenario.lockstep else scenario.limits.load * scenario.real_time_factor


class RosWatch:
    """Listens to race_status and collision, and breaks what is to be broken. Needs a running rospy node."""

    def __init__(self, plan: Plan):
        self._plan = plan
        self._cars = list(plan.cars)
        self._updates: queue.SimpleQueue = queue.SimpleQueue()
        self._counts: queue.SimpleQueue = queue.SimpleQueue()
        self._commands = CommandWatch(_steady_cars(plan), plan.scenario.limits.silence, _time_to_load(plan))
        self._subscribers = [self._subscribe(car) for car in self._cars]
        take = heard_from("sim2d", self._take_diagnostics)
        self._subscribers.append(rospy.Subscriber("/diagnostics", DiagnosticArray, take))
        self._estimates: queue.SimpleQueue = queue.SimpleQueue()
        self._localizations = [self._subscribe_estimate(car) for car in self._cars]
        self._early: Optional[Failure] = None
        if plan.has_countdown:
            self._subscribers.append(rospy.Subscriber("/time_to_start", Int32, self._take_start))
        self._next_look = 0.0
        self._director = Director(plan) if plan.scenario.has_events else None

    def take(self) -> list[RaceUpdate]:
        """The updates since the last call, in the order of their arrival."""
        return [self._updates.get() for _ in range(self._updates.qsize())]

    def failure(self, done: set[str]) -> Optional[Failure]:
        """What went wrong on this side, if anything did; `done`: the cars that have finished."""
        if self._director and self._director.failure:
            return self._director.failure
        while not self._counts.empty():
            self._commands.take(self._counts.get())
        problems = self._commands.problems(done)
        if problems:
            return self._failure_of_driver(problems[0])
        if time.monotonic() < self._next_look:
            return None
        self._next_look = time.monotonic() + _GRAPH_INTERVAL
        return self.mixed_up()

    def _failure_of_driver(self, problem: Problem) -> Failure:
        graph = read_graph()
        description = self._plan.cars[problem.car].description
        nodes = driver_nodes(graph, problem.car)
        reasons = [problem.text]
        if problem.is_mute:
            car = next(each for each in self._plan.scenario.cars if each.name == problem.car)
            publications, topics = publications_of(nodes), topics_of(description)
            misread = misread_by(nodes, graph)
            reasons += [_ENDLESS] if computes_without_pause(driver_mark(self._plan, car)) else []
            reasons += why_mute(graph, problem.car, publications, car.driver.interface, topics, misread)
        failure = failure_of_driver(self._plan, problem.car, nodes, "; ".join(reasons))
        return dataclasses.replace(failure, stamp=problem.stamp)

    def mixed_up(self) -> Optional[Failure]:
        """Whether a driver hears another's, touches its car or moves the start: then nothing counts."""
        if self._early or len(self._cars) < 2:
            return self._early
        graph = read_graph()
        found = shared_topic(graph, self._cars) or meddling(graph, self._cars, self._car_of)
        return found and Failure(*found, str(self._plan.launch_log), stamp=0.0)

    def _car_of(self, node: str) -> Optional[str]:
        """Whose driver started a node; nothing if none did, or it does not tell which process it is."""
        try:
            pid = ask(node, "getPid", patience=1.0)
        except ScenarioError:
            return None
        cars = self._plan.scenario.cars
        return next((car.name for car in cars if pid in marked_processes(driver_mark(self._plan, car))), None)

    def estimates(self) -> dict[str, Poses]:
        """Where localization, or visual odometry that is to be judged, took the cars to be.

        They are complete if the localizations end within some time.
        """
        deadline = time.monotonic() + _PATIENCE
        while any(each.get_num_connections() for each in self._localizations) and time.monotonic() < deadline:
            time.sleep(_LOOK_INTERVAL)
        found: dict[str, tuple[list, list]] = {}
        while not self._estimates.empty():
            car, stamp, pose = self._estimates.get()
            stamps, values = found.setdefault(car, ([], []))
            stamps.append(stamp)
            values.append(pose)
        return {car: Poses(*heard) for car, heard in found.items()}

    def descriptions(self) -> dict[str, str]:
        """The robot_description of each car, empty if it has none; from any thread."""
        return {car: rospy.get_param(f"/{car}/robot_description", "") for car in self._cars}

    def close(self) -> None:
        """Stop listening."""
        for each in [*self._subscribers, *self._localizations]:
            each.unregister()
        if self._director:
            self._director.close()

    def _subscribe(self, car: str) -> rospy.Subscriber:
        take = heard_from(f"{car}/race_mgr", lambda message: self._updates.put(to_update(car, message)))
        return rospy.Subscriber(f"/{car}/race_status", RaceStatus, take, tcp_nodelay=True)

    def _take_start(self, message: Int32) -> None:
        node = sender(message)
        if node != STARTER and not self._early:
            reason = f"publishes /time_to_start, which is the {STARTER}'s"
            self._early = Failure(node, reason, str(self._plan.launch_log), stamp=0.0)

    def _take_diagnostics(self, message: DiagnosticArray) -> None:
        for status in message.status:
            if status.name.startswith(_COMMANDS_OF):
                self._counts.put(to_count(message.header.stamp.to_sec(), status))

    def _subscribe_estimate(self, car: str) -> rospy.Subscriber:
        def take(message):
            stamp = round(message.header.stamp.to_sec(), 9)
            self._estimates.put((car, stamp, planar(message.pose.pose)))

        if self._plan.scenario.criteria.odometry_drift is not None:
            return rospy.Subscriber(f"/{car}/visual_odom", Odometry, take)
        heard = heard_from(f"{car}/amcl", take)
        return rospy.Subscriber(f"/{car}/amcl_pose", PoseWithCovarianceStamped, heard)
