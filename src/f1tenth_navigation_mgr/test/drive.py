"""The mock in a process of its own, and a NavigationMgr that drives to its goals."""

import os
import subprocess
import sys
import time

import f1tenth_navigation_mgr as nav

HERE = os.path.dirname(os.path.abspath(__file__))
LIMIT = 120.0  # wall s, against hangs
NO_EVENT = (nav.SpinResult.NOT_CONNECTED, nav.SpinResult.DRIVING, nav.SpinResult.IDLE)


class Server:
    """The mock, in a namespace."""

    def __init__(self, robot, *arguments):
        command = [sys.executable, os.path.join(HERE, "mock_move_base.py"), *arguments, f"__ns:=/{robot}"]
        self._process = subprocess.Popen(command)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.kill()
        self._process.wait()


def timeouts(**wanted):
    """The defaults, but for what is wanted (s)."""
    found = nav.Timeouts()
    for name, seconds in wanted.items():
        setattr(found, name, seconds)
    return found


class Drive:
    """A NavigationMgr and its events; the y of a goal is an order to the mock, the x its number."""

    def __init__(self, *orders, robot="robot1", spin=nav.NavigationMgr.spin, **wanted):
        self.navigation = nav.NavigationMgr(robot, timeouts(**wanted))
        self.navigation.on_goal_reached(self._note)
        self.navigation.on_goal_failed(self._note)
        for number, order in enumerate(orders):
            self.navigation.add_goal(nav.Goal(number, order, 0.0))
        self.events = []
        self._spin = spin

    def _note(self, result):
        self.events.append(f"goal {result.goal.x:g} {result.outcome.name.lower()}: {result.text}")

    def until(self, *wanted, at=()):
        """Spin until that is the result; `at` may hold the ROS time of all spins."""
        end = time.monotonic() + LIMIT
        while time.monotonic() < end:
            did = self._spin(self.navigation, *at)
            if did not in NO_EVENT:
                self.events.append(did.name.lower())
            if did in wanted:
                return did
        raise AssertionError(f"not within {LIMIT} s: {wanted}; so far {self.events}")

    def to_the_end(self):
        """Spin until the queue is empty, which is said once; return all events."""
        self.until(nav.SpinResult.QUEUE_EMPTY)
        assert {self._spin(self.navigation) for _ in range(5)} == {nav.SpinResult.IDLE}
        return self.events
