"""Breaks and pushes what the scenario wants broken or pushed, at the simulated times that it gives."""

import queue
import threading
from typing import Optional

import rospy
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.participants import participants
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.observations import Failure
from f1tenth_judge.scenario.interventions import DIRECTOR
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Header

from f1tenth_scenarios.run.events.agenda import Agenda, PeriodGate
from f1tenth_scenarios.run.events.ros_node_kill import kill_node
from f1tenth_scenarios.run.events.ros_push import push_model


def _kills(scenario):
    return [(fault.at, lambda fault=fault: kill_node(fault.kill)) for fault in scenario.faults]


def _pushes(scenario):
    return [
        (push.at, lambda name=box.name, push=push: push_model(name, push))
        for box in scenario.boxes
        for push in box.pushes
    ]


# docs/lockstep.md: a participant with this stamp is not waited for any more.
_FAR_FUTURE = rospy.Time(2147483647)


class Director:
    """Follows the clock; in lockstep as a participant, so that what it does falls into its period."""

    def __init__(self, plan: Plan):
        scenario = plan.scenario
        self.failure: Optional[Failure] = None
        self._lockstep = scenario.lockstep
        self._agenda = Agenda([*_kills(scenario), *_pushes(scenario)])
        self._gate = PeriodGate({fault.kill for fault in scenario.faults} & set(participants(plan)))
        self._inbox: queue.SimpleQueue = queue.SimpleQueue()
        self._done = rospy.Publisher("/sim2d/done", Header, queue_size=10)
        self._subscribers = [
            rospy.Subscriber("/clock", Clock, self._inbox.put, tcp_nodelay=True),
            rospy.Subscriber("/sim2d/done", Header, self._inbox.put, tcp_nodelay=True),
        ]
        self._thread = threading.Thread(target=self._follow, daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Stop following."""
        self._inbox.put(None)
        self._thread.join()
        self._done.unregister()

    def _follow(self) -> None:
        waiting_for: Optional[rospy.Time] = None
        while not self._agenda.empty and (message := self._inbox.get()) is not None:
            if isinstance(message, Clock):
                waiting_for = message.clock
            else:
                self._gate.answer(message.frame_id, message.stamp.to_sec())
            if waiting_for is not None and self._may_go_on(waiting_for):
                self._act(waiting_for)
                waiting_for = None
        for each in self._subscribers:
            each.unregister()

    def _may_go_on(self, stamp: rospy.Time) -> bool:
        return not self._agenda.is_due(stamp.to_sec()) or self._gate.is_open(stamp.to_sec())

    def _act(self, stamp: rospy.Time) -> None:
        try:
            self._agenda.act(stamp.to_sec())
        except ScenarioError as error:
            self.failure = Failure("runner", str(error))
        if self._lockstep:
            self._done.publish(Header(stamp=_FAR_FUTURE if self._agenda.empty else stamp, frame_id=DIRECTOR))
