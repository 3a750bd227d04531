"""How a command ends when it is told to by a signal."""

import signal
import threading

import rospy


class Ending:
    """Shuts ROS down on SIGINT and SIGTERM: in another thread, not while the main one makes a call.

    rospy would do it in the signal's handler, and hang if the main thread is logging: both ask the master.

    Args:
        patience: wall s for the call that is under way, which holds `working`.

    """

    def __init__(self, patience):
        self.has_begun = False
        self.working = threading.Lock()
        self._patience = patience
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, lambda *_: threading.Thread(target=self._end).start())

    def _end(self):
        self.has_begun = True
        if self.working.acquire(timeout=self._patience):
            self.working.release()
        rospy.signal_shutdown("told to end")
