"""Who may end the race or the node."""

import signal

import rospy
from std_srvs.srv import Trigger, TriggerResponse


class StopRequests:
    """SIGINT, SIGTERM and the end of ROS stop race and node; the service ~stop stops the race only."""

    def __init__(self):
        self._race = False
        self._node = False
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self._on_signal)
        self._service = rospy.Service("~stop", Trigger, self._on_stop)

    @property
    def race(self):
        """Whether the race is to stop."""
        return self._race or self.node

    @property
    def node(self):
        """Whether the node is to end."""
        return self._node or rospy.is_shutdown()

    def _on_signal(self, _number, _frame):
        self._node = True

    def _on_stop(self, _request):
        self._race = True
        return TriggerResponse(success=True, message="the race is being stopped")
