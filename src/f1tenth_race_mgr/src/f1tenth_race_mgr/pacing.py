"""When the race takes a step."""

import time

import rospy

from f1tenth_race_mgr.planner_watch import PlannerWatch

POLL_PERIOD = 0.005  # wall s
TIMEOUT = 0.1  # wall s, how long a stop request may wait


class ClockPacing:
    """Steps continuously."""

    def __init__(self, navigation, _start_signal, _stop_requests):
        self._planner_watch = PlannerWatch(navigation)

    def wait(self):
        """Return the ROS time of the next step."""
        self._planner_watch.check()
        # Not rospy.sleep: it does not return when the clock stops.
        time.sleep(POLL_PERIOD)
        return rospy.get_rostime()

    def done(self, now):
        """Do nothing: nobody waits for this node."""

    def leave(self):
        """Do nothing: nobody waits for this node."""


class LockstepPacing:
    """One step per period, as a participant that acts after the car's move_base and the race starter."""

    def __init__(self, navigation, start_signal, stop_requests):
        from sim2d_lockstep import Participant

        self._navigation = navigation
        self._planner_watch = PlannerWatch(navigation)
        self._start_signal = start_signal
        self._stop_requests = stop_requests
        after = [navigation.action_name.lstrip("/")]
        if start_signal:
            after.append("race_starter")
        self._participant = Participant(rospy.get_name().lstrip("/"), after)
        self._now = None
        self._ready = False

    def wait(self):
        """Return the stamp of the next period, or None when there is no step to take yet."""
        stamp = self._participant.wait_for_period(TIMEOUT)
        if stamp is None:
            return self._now if self._navigation.is_server_gone() else None
        self._now = stamp
        self._ready = self._ready or self._wait_until_ready()
        return stamp if self._ready else None

    def done(self, now):
        """Let the simulator go on."""
        self._participant.done(now)

    def leave(self):
        """Let the simulator never wait for this node again."""
        self._participant.leave()

    def _wait_until_ready(self):
        # Wall time: the clock stands still until the first done(). A starter that has spoken is connected,
        # so that its 0 arrives in its own period.
        while not self._stop_requests.race:
            if self._planner_watch.check(TIMEOUT) and self._start_is_connected():
                return True
        return False

    def _start_is_connected(self):
        return self._start_signal is None or self._start_signal.seconds_left() is not None
