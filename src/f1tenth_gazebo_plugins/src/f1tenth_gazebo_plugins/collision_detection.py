"""The node collision_detection: contact sensors in, one verdict out."""

import threading
import time

import rospy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from gazebo_msgs.msg import ContactsState
from std_msgs.msg import Bool, UInt32
from workspace_support.nodes import ParameterError

from f1tenth_gazebo_plugins.collision_monitor import SECOND, CollisionMonitor
from f1tenth_gazebo_plugins.parameters import read_parameters

BAD_INPUT = 2
# Wall time, s, between looks at the clock, which counts only while no sensor speaks.
CLOCK_CHECK = 0.02
# Wall time, s, without a message after which that is so. At 100 times real time, a message that waits
# 10 ms to be read lets the clock go 1 s ahead.
QUIET = 0.25


class CollisionDetection:
    """Connects a CollisionMonitor to its topics. rospy calls back from a thread for each connection."""

    def __init__(self, parameters):
        self._monitor = CollisionMonitor(parameters.topics, parameters.ground_models)
        self._lock = threading.Lock()
        self._next_diagnosis = 0
        self._last_heard = -QUIET
        self._is_over = False
        self._collision = rospy.Publisher("collision", Bool, queue_size=100, latch=True)
        self._collisions = rospy.Publisher("collisions", UInt32, queue_size=100, latch=True)
        self._diagnostics = rospy.Publisher("/diagnostics", DiagnosticArray, queue_size=10)
        rospy.on_shutdown(self._end)
        self._subscribers = [self._subscribe(topic) for topic in parameters.topics]

    def _subscribe(self, topic):
        return rospy.Subscriber(
            topic, ContactsState, self._on_contacts, callback_args=topic, tcp_nodelay=True
        )

    def _end(self):
        # rospy calls this before it closes topics, on which a callback that still runs could not publish.
        with self._lock:
            self._is_over = True

    def _on_contacts(self, message, topic):
        contacts = [(state.collision1_name, state.collision2_name) for state in message.states]
        with self._lock:
            if self._is_over:
                return
            self._last_heard = time.monotonic()
            self._publish(self._monitor.hear(topic, message.header.stamp.to_nsec(), contacts))

    def spin(self):
        """Watch for silence until the node is shut down."""
        pause = threading.Event()
        while not rospy.is_shutdown():
            now = rospy.get_rostime().to_nsec()
            with self._lock:
                if now > 0 and not self._is_over:
                    self._look(now)
            pause.wait(CLOCK_CHECK)

    def _look(self, now):
        if time.monotonic() - self._last_heard >= QUIET:
            self._publish(self._monitor.tick(now))
        self._diagnose(now)

    def _publish(self, report):
        if report.collision is not None:
            self._collision.publish(report.collision)
        if report.collisions is not None:
            self._collisions.publish(report.collisions)

    def _diagnose(self, now):
        # A clock that has gone back belongs to a new run.
        if self._next_diagnosis - SECOND <= now < self._next_diagnosis:
            return
        self._next_diagnosis = (now // SECOND + 1) * SECOND
        message = DiagnosticArray(status=[diagnosis(self._monitor.silent_sensors())])
        message.header.stamp = rospy.Time(0, now)
        self._diagnostics.publish(message)


def diagnosis(silent):
    """Make a status of CollisionMonitor.silent_sensors(), with a value for each sensor that says nothing."""
    status = DiagnosticStatus(
        name=rospy.get_name() + ": contact sensors", message="all contact sensors speak"
    )
    for sensor, silence in silent.items():
        text = "never spoke" if silence is None else f"silent for {silence / SECOND:.1f} s"
        status.values.append(KeyValue(key=sensor, value=text))
    if silent:
        status.level = DiagnosticStatus.ERROR
        status.message = "no word from " + ", ".join(silent)
    return status


def main():
    """Run the node; return its exit code."""
    rospy.init_node("collision_detection")
    try:
        parameters = read_parameters(rospy.get_name(), rospy.get_param("~", {}))
    except ParameterError as error:
        rospy.logfatal(str(error))
        return BAD_INPUT
    CollisionDetection(parameters).spin()
    return 0
