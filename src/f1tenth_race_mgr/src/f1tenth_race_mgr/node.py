"""The node race_mgr: a Race on a NavigationMgr, stepped by the clock or once per period in lockstep."""

import time

import rospkg
import rospy
from workspace_support.nodes import ParameterError, parse_parameters

from f1tenth_navigation_mgr import GoalsFileError, NavigationMgr, StartSignal
from f1tenth_race_mgr.pacing import ClockPacing, LockstepPacing
from f1tenth_race_mgr.parameters import BLOCK, Parameters, goals_path
from f1tenth_race_mgr.publishers import StatusPublisher, publish_goals
from f1tenth_race_mgr.race import Race
from f1tenth_race_mgr.state import State
from f1tenth_race_mgr.stop_requests import StopRequests

EXIT_BAD_INPUT = 2
EXIT_CODES = {State.FINISHED: 0, State.STOPPED: 0, State.ABORTED: 3, State.LOST: 4}

SETTLE_TIMEOUT = 2.0  # wall s for the planner to acknowledge a cancellation
POLL_PERIOD = 0.005  # wall s


class BadInputError(Exception):
    """What the user gave cannot be used; the text is one line."""


def read_parameters():
    """Return the Parameters: private ones first, then the block below the node's name, then beside it."""
    private = rospy.get_param("~", {})
    below = private.pop(BLOCK, {}) if isinstance(private, dict) else {}
    node, beside = rospy.get_name(), rospy.resolve_name(BLOCK)
    sources = [(node, private), (f"{node}/{BLOCK}", below)]
    # A node that is itself called f1tenth_race_mgr has its own parameters there.
    if beside != node:
        sources.append((beside, rospy.get_param(beside, {})))
    try:
        return parse_parameters(Parameters, *sources)
    except ParameterError as error:
        raise BadInputError(error) from error


def load_goals(navigation, parameters):
    """Load the goals file that the parameters name."""
    try:
        navigation.load_goals(goals_path(parameters, rospkg.RosPack().get_path))
    except rospkg.ResourceNotFound as error:
        raise BadInputError(f"package_name: no package {parameters.package_name!r}") from error
    except GoalsFileError as error:
        raise BadInputError(error) from error


class RaceMgr:
    """Wires a Race to ROS and keeps it going."""

    def __init__(self, parameters, stop_requests):
        self._parameters = parameters
        self._stop_requests = stop_requests
        self._navigation = NavigationMgr("")
        load_goals(self._navigation, parameters)
        self._goals = publish_goals(self._navigation.queue)
        self._navigation.loop_mode = parameters.loop_mode
        start_signal = StartSignal(starter=parameters.starter) if parameters.wait_for_start else None
        has_started = start_signal.has_started if start_signal else lambda: True
        self._race = Race(self._navigation, has_started, StatusPublisher())
        pacing = LockstepPacing if parameters.lockstep else ClockPacing
        self._pacing = pacing(self._navigation, start_signal, stop_requests)

    def run(self):
        """Block until the race is over and the node told to end; return the exit code."""
        self._race.announce(rospy.get_rostime())
        while not (self._race.is_over or self._stop_requests.race):
            now = self._pacing.wait()
            if now is not None:
                self._race.step(now)
                self._pacing.done(now)
        self._race.stop(rospy.get_rostime())
        self._pacing.leave()
        self._settle()
        self._stay()
        return EXIT_CODES[self._race.status.state]

    def _settle(self):
        end = time.monotonic() + SETTLE_TIMEOUT
        # A planner that is gone acknowledges nothing.
        while (
            self._navigation.goal_in_flight is not None
            and self._navigation.wait_for_server(0.0)
            and time.monotonic() < end
        ):
            self._navigation.spin()

    def _stay(self):
        # A latched status disappears with its node.
        while not (self._parameters.exit_when_done or self._stop_requests.node):
            time.sleep(POLL_PERIOD)


def main():
    """Run the node; return its exit code."""
    # Signals are handled here: rospy would close the topics before the last status is sent.
    rospy.init_node("race_mgr", disable_signals=True)
    try:
        return RaceMgr(read_parameters(), StopRequests()).run()
    except BadInputError as error:
        rospy.logfatal("%s", error)
        return EXIT_BAD_INPUT
    finally:
        rospy.signal_shutdown("done")
