"""What rclpy offers a planner, on cyclonedds alone: topics, timers on /clock, spinning."""

import os
import signal

from cyclonedds.core import InstanceState, ReadCondition, SampleState, ViewState, WaitSet
from cyclonedds.domain import DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.qos import Policy, Qos
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from f1tenth_judge.drivers.ros2.messages.basic import Clock

DEFAULT = Qos(Policy.Reliability.Reliable(10**8), Policy.History.KeepLast(10))
SENSOR_DATA = Qos(Policy.Reliability.BestEffort, Policy.History.KeepLast(5))
LATCHED = Qos(
    Policy.Reliability.Reliable(10**8), Policy.Durability.TransientLocal, Policy.History.KeepLast(1)
)
_NEW = ViewState.Any | InstanceState.Any | SampleState.NotRead
_WAIT = 10**8  # ns


class Node:
    def __init__(self):
        # Python would not notice it while it waits in C.
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        self.participant = DomainParticipant(int(os.environ["ROS_DOMAIN_ID"]))
        self.callbacks = []
        self.waits = WaitSet(self.participant)
        self.now = 0.0  # s, simulated
        self.timers = []

    def publisher(self, topic, kind, qos=DEFAULT):
        return DataWriter(self.participant, Topic(self.participant, f"rt/{topic}", kind), qos).write

    def subscribe(self, topic, kind, callback, qos=DEFAULT):
        reader = DataReader(self.participant, Topic(self.participant, f"rt/{topic}", kind), qos)
        condition = ReadCondition(reader, _NEW)
        self.waits.attach(condition)
        self.callbacks.append((reader, condition, callback))

    def timer(self, period, callback):
        """`period` in simulated s."""
        if not self.timers:
            self.subscribe("clock", Clock, self._tick, SENSOR_DATA)
        self.timers.append([period, None, callback])

    def spin(self):
        while True:
            self.waits.wait(_WAIT)
            for reader, condition, callback in self.callbacks:
                for message in reader.take(10, condition):
                    callback(message)

    def _tick(self, clock):
        self.now = clock.clock.to_sec()
        for timer in self.timers:
            period, due, callback = timer
            if due is None or self.now >= due - 1e-9:
                timer[1] = (self.now if due is None else due) + period
                callback()
