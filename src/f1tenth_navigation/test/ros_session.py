"""A ROS master of one's own and launch files that end with the test."""

import contextlib
import os
import signal
import socket
import subprocess
import threading
import time

import roslib.packages
import rospkg
import rospy

PATIENCE = 120  # s of wall time for whatever has to happen, on a busy machine too


def missing_nodes(nodes):
    """Return which of the (package, executable) pairs are not built."""
    return [name for package, name in nodes if not _executable(package, name)]


def _executable(package, name):
    try:
        return roslib.packages.find_node(package, name)
    except rospkg.ResourceNotFound:
        return []


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


@contextlib.contextmanager
def launched(*arguments, environment=None):
    """Run roslaunch; it brings a master if there is none yet."""
    process = subprocess.Popen(["roslaunch", *arguments], env={**os.environ, **(environment or {})})
    try:
        yield
    finally:
        process.send_signal(signal.SIGINT)
        process.wait()


def wait_until(condition, what):
    """Wait in wall time: the simulated clock may not run yet."""
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, f"not within {PATIENCE} s: {what}"
        time.sleep(0.05)


class Latest:
    """The latest message of a topic."""

    def __init__(self, topic, kind):
        self._topic = topic
        self._arrived = threading.Event()
        self._message = None
        rospy.Subscriber(topic, kind, self._on_message)

    def _on_message(self, message):
        self._message = message
        self._arrived.set()

    def get(self):
        """Return it; wait for the first one."""
        assert self._arrived.wait(PATIENCE), f"nothing on {self._topic} within {PATIENCE} s"
        return self._message
