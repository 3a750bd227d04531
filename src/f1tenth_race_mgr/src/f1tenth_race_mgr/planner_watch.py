"""Warns while there is no planner: nobody should have to guess why the car stands still."""

import time

import rospy

PATIENCE = 5.0  # wall s before the first warning, and between two


class PlannerWatch:
    """Warns again and again until the planner's action server has been found.

    Args:
        navigation: a NavigationMgr, of which wait_for_server() and action_name are used.

    """

    def __init__(self, navigation):
        self._navigation = navigation
        self._found = False
        self._next_warning = time.monotonic() + PATIENCE

    def check(self, timeout=0.0):
        """Wait up to timeout (wall s) for the server; return whether it has been found."""
        self._found = self._found or self._navigation.wait_for_server(timeout)
        if not self._found and time.monotonic() >= self._next_warning:
            rospy.logwarn("waiting for a planner: no action server on %s", self._navigation.action_name)
            self._next_warning = time.monotonic() + PATIENCE
        return self._found
