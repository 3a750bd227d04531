"""The node race_starter: announces what the Countdown says is due."""

import signal
import sys
import time
from dataclasses import dataclass

import rospy
from std_msgs.msg import Int32
from workspace_support.nodes import ParameterError, parse_parameters, synchronous_publisher

from f1tenth_race_starter.countdown import Countdown

EXIT_STARTED = 0
EXIT_STOPPED = 1
EXIT_BAD_INPUT = 2

POLL_PERIOD = 0.005  # wall s
PERIOD_TIMEOUT = 0.1  # wall s, how long a stop request may wait


@dataclass(frozen=True)
class Parameters:
    """What the node reads from its private namespace."""

    time_to_start: int = 5  # s of ROS time
    lockstep: bool = False
    linger: float = 5.0  # wall s


class RaceStarter:
    """Publishes the countdown, by the clock or once per period in lockstep."""

    def __init__(self, parameters, stop_requests):
        self._parameters = parameters
        self._stop_requests = stop_requests
        self._countdown = Countdown(parameters.time_to_start)
        # Six messages of four bytes fill no buffer.
        self._publisher = synchronous_publisher("time_to_start", Int32, latch=True)

    def run(self):
        """Block until the 0 is announced and `linger` is over, or ROS shuts down; return the exit code."""
        if self._parameters.lockstep:
            self._run_in_lockstep()
        else:
            self._run_by_clock()
        if not self._countdown.finished:
            return EXIT_STOPPED
        self._linger()
        return EXIT_STARTED

    def _stopping(self):
        return rospy.is_shutdown() or bool(self._stop_requests)

    def _run_by_clock(self):
        # Not rospy.sleep: it does not return when the clock stops.
        while not (self._stopping() or self._countdown.finished):
            self._announce(rospy.get_rostime())
            time.sleep(POLL_PERIOD)

    def _run_in_lockstep(self):
        from sim2d_lockstep import Participant

        participant = Participant(rospy.get_name().lstrip("/"))
        while not (self._stopping() or self._countdown.finished):
            stamp = participant.wait_for_period(PERIOD_TIMEOUT)
            if stamp is not None:
                self._announce(stamp)
                participant.done(stamp)
        participant.leave()

    def _announce(self, now):
        for seconds_left in self._countdown.update(now.to_nsec()):
            self._publisher.publish(seconds_left)
            rospy.loginfo("%d s to the start", seconds_left)

    def _linger(self):
        # A latched message is gone with its node; who connects a little late is to get the start signal too.
        end = time.monotonic() + self._parameters.linger
        while not self._stopping() and time.monotonic() < end:
            time.sleep(POLL_PERIOD)


def _note_stop_signals():
    """Return a list that grows with each SIGINT and SIGTERM.

    rospy's own handler shuts down inside the signal, and hangs when that interrupts a log or a publish.
    """
    requests = []
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda received, _: requests.append(received))
    return requests


def main():
    """Run the node; return its exit code."""
    try:
        # It waits for a master: until there is one, a signal ends the process as usual.
        rospy.init_node("race_starter", disable_signals=True)
    except KeyboardInterrupt:
        rospy.signal_shutdown("interrupted")
        return EXIT_STOPPED
    except OverflowError:
        print("race_starter: a parameter on the command line is too large for ROS", file=sys.stderr)
        return EXIT_BAD_INPUT
    stop_requests = _note_stop_signals()
    try:
        parameters = parse_parameters(Parameters, (rospy.get_name(), rospy.get_param("~", {})))
    except ParameterError as error:
        rospy.logfatal("%s", error)
        return EXIT_BAD_INPUT
    code = RaceStarter(parameters, stop_requests).run()
    rospy.signal_shutdown("the countdown is over")
    return code
