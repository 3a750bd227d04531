"""What the tests of the node share."""

import os
import signal
import subprocess
import sys
import threading
import time

import rospkg
import rospy
from move_base_msgs.msg import MoveBaseActionResult
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Header, Int32
from workspace_support.nodes import synchronous_publisher

from f1tenth_race_mgr.msg import RaceStatus

LIMIT = 120.0  # wall s, against hangs
PATIENCE = 10.0  # wall s, for a node to end by itself
REPEAT_PERIOD = 0.1  # wall s
FAR_FUTURE = 2147483647 * 1_000_000_000  # ns
QUIET = 0.5  # wall s in which something must not happen

PACKAGES = rospkg.RosPack()
MOCK = os.path.join(PACKAGES.get_path("f1tenth_navigation_mgr"), "test", "mock_move_base.py")
RACE_MGR = os.path.join(PACKAGES.get_path("f1tenth_race_mgr"), "scripts", "race_mgr")


class Node:
    """A program of ours in the namespace /robot1."""

    def __init__(self, script):
        self._script = script
        self._process = subprocess.Popen(
            [sys.executable, "-X", "faulthandler", script, "__ns:=/robot1"], stderr=subprocess.PIPE, text=True
        )

    def __enter__(self):
        return self

    def __exit__(self, _kind, error, _traceback):
        if isinstance(error, AssertionError) and self.is_alive():
            # What is printed here is lost with rostest's log; the text of the failure is not.
            raise AssertionError(f"{error}\n{self._script}:\n{self._where_it_hangs()}") from error
        self._end()
        self._process.stderr.close()

    def _end(self):
        # Killed only if it must be: the master goes on knowing whom it was not told of, tells their port to
        # shut down when the next of their name comes, and whoever has got that port by then does.
        self.interrupt()
        try:
            self._process.wait(PATIENCE)
        except subprocess.TimeoutExpired:  # rospy may miss a signal that comes while it starts
            self.kill()
            self._process.wait()

    def kill(self):
        self._process.kill()

    def interrupt(self):
        self._process.send_signal(signal.SIGINT)

    def finish(self):
        """Return exit code and what was said on stderr."""
        try:
            _, errors = self._process.communicate(timeout=LIMIT)
        except subprocess.TimeoutExpired as error:
            raise AssertionError(f"did not end in {LIMIT:g} s:\n{self._where_it_hangs()}") from error
        return self._process.returncode, errors

    def _where_it_hangs(self):
        # Python's faulthandler prints the stacks of all threads.
        self._process.send_signal(signal.SIGABRT)
        return self._process.communicate(timeout=LIMIT)[1]

    def is_alive(self):
        return self._process.poll() is None


class Listener:
    """Collects what a topic says."""

    def __init__(self, topic, message_type, convert):
        self.heard = []
        self._changed = threading.Condition()
        self._convert = convert
        self._subscriber = rospy.Subscriber(topic, message_type, self._on_message)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._subscriber.unregister()

    def _on_message(self, message):
        with self._changed:
            self.heard.append(self._convert(message))
            self._changed.notify_all()

    def wait_for(self, item, timeout=LIMIT):
        with self._changed:
            return self._changed.wait_for(lambda: item in self.heard, timeout)


def listen_to_status():
    """Collect (state, goals_reached)."""
    return Listener("/robot1/race_status", RaceStatus, lambda message: (message.state, message.goals_reached))


def listen_to_results():
    """Collect the terminal states of goals."""
    return Listener("/robot1/move_base/result", MoveBaseActionResult, lambda message: message.status.status)


def read_status():
    """Return the latched status as a late subscriber gets it."""
    return rospy.wait_for_message("/robot1/race_status", RaceStatus, LIMIT)


class StartSignal:
    """Plays the race starter."""

    def __init__(self):
        self._publisher = synchronous_publisher("/time_to_start", Int32, latch=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._publisher.unregister()

    def publish(self, seconds_left):
        self._publisher.publish(seconds_left)


class Lockstep:
    """Plays the simulator and the participants before race_mgr."""

    def __enter__(self):
        rospy.set_param("/use_sim_time", True)
        self._clock = synchronous_publisher("/clock", Clock, latch=True)
        self._done = synchronous_publisher("/sim2d/done", Header, latch=True)
        self._answers = Listener(
            "/sim2d/done", Header, lambda message: (message.frame_id, message.stamp.to_nsec())
        )
        return self

    def __exit__(self, *_):
        self._clock.unregister()
        self._done.unregister()
        self._answers.__exit__()
        rospy.delete_param("/use_sim_time")

    def run_period(self, nsec, participants, timeout=LIMIT):
        """Publish a period and these participants' answers; return whether race_mgr answers, too.

        Again and again, as the simulator does until everybody is connected.
        """
        end = time.monotonic() + timeout
        while time.monotonic() < end:
            self._clock.publish(rospy.Time(0, nsec))
            for participant in participants:
                self._done.publish(Header(frame_id=participant, stamp=rospy.Time(0, nsec)))
            if self._answers.wait_for(("robot1/race_mgr", nsec), REPEAT_PERIOD):
                return True
        return False

    def has_left(self):
        """Return whether race_mgr has said that nobody needs to wait for it again."""
        return self._answers.wait_for(("robot1/race_mgr", FAR_FUTURE))
