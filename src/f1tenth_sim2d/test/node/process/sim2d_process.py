"""Starts the node sim2d under the master of a test, and plays a participant that says how far it goes."""

import json
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import time

import rospkg
import rospy
from geometry_msgs.msg import Twist
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Header

PERIOD_NS = 25_000_000
LONG = 60.0  # wall s: only a hang takes that long
DATA = pathlib.Path(__file__).resolve().parents[1] / "data"
WORLD = str(DATA / "room.world")
LEFT_NS = 2_147_483_647_000_000_000


def car_description(*extra):
    """Return the URDF of the test car, with elements added at its end."""
    return (DATA / "car.urdf").read_text().replace("</robot>", "".join(extra) + "</robot>")


def executable(package, name):
    """Return the path of a node's executable in the devel or install space."""
    paths = [
        os.path.join(prefix, "lib", package, name) for prefix in os.environ["CMAKE_PREFIX_PATH"].split(":")
    ]
    paths += [os.path.join(rospkg.RosPack().get_path(package), name)]
    return next(path for path in paths if os.access(path, os.X_OK))


class Sim2d:
    """The node sim2d as a process of its own, with the given private parameters."""

    def __init__(self, description=None, environment=None, **parameters):
        """description: URDF of robot1; None leaves its parameter alone."""
        self._folder = tempfile.TemporaryDirectory(prefix="sim2d_test_")
        self.result_file = pathlib.Path(self._folder.name, "result.json")
        self.record_file = pathlib.Path(self._folder.name, "record.csv")
        self.interventions_file = pathlib.Path(self._folder.name, "interventions.jsonl")
        defaults = {
            "world": WORLD,
            "cars": {"robot1": {"x": 0.0}},
            "result_file": str(self.result_file),
            "record": str(self.record_file),
            "interventions": str(self.interventions_file),
        }
        rospy.set_param("/sim2d", {**defaults, **parameters})
        if description is not None:
            rospy.set_param("/robot1/robot_description", description)
        self._process = subprocess.Popen(
            [executable("f1tenth_sim2d", "sim2d")],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, **(environment or {})},
        )

    def wait(self):
        """Wait for the end; return the exit code, and leave the texts in stdout and stderr."""
        try:
            self.stdout, self.stderr = self._process.communicate(timeout=LONG)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self.stdout, self.stderr = self._process.communicate()
            raise
        return self._process.returncode

    def send(self, number):
        """Send a signal."""
        self._process.send_signal(number)

    def read_line(self):
        """Wait for a line of its standard output."""
        return self._process.stdout.readline()

    def stop(self):
        """Ask for the end and return the exit code."""
        if self._process.poll() is None:
            self.send(signal.SIGINT)
        return self.wait()

    def kill(self):
        """End it without asking, if it still runs."""
        if self._process.poll() is None:
            self._process.kill()
            self.wait()

    def result(self):
        """Return the content of the result file."""
        return json.loads(self.result_file.read_text())

    def record(self):
        """Return the rows of the record as dictionaries of text."""
        header, *rows = (line.split(",") for line in self.record_file.read_text().splitlines())
        return [dict(zip(header, row)) for row in rows]


def wait_for_subscriber(publisher):
    """Wait until somebody listens."""
    deadline = time.monotonic() + LONG
    while not publisher.get_num_connections():
        if time.monotonic() > deadline:
            raise AssertionError(f"nobody listens to {publisher.name}")
        time.sleep(0.01)


class Collector:
    """Keeps all messages of some topics, in the order in which they came."""

    def __init__(self, **topics):
        """topics: message class by topic; two underscores stand for a slash."""
        self.messages = {}
        self._changed = threading.Condition()
        self._subscribers = []
        for key, message_class in topics.items():
            topic = "/" + key.replace("__", "/")
            self.messages[topic] = []
            self._subscribers.append(
                rospy.Subscriber(topic, message_class, self._keep, topic, tcp_nodelay=True, buff_size=1 << 24)
            )

    def _keep(self, message, topic):
        with self._changed:
            self.messages[topic].append(message)
            self._changed.notify_all()

    def wait_until_connected(self):
        """Wait for a publisher on every topic."""
        deadline = time.monotonic() + LONG
        while not all(subscriber.get_num_connections() for subscriber in self._subscribers):
            if time.monotonic() > deadline:
                raise AssertionError("not every topic has a publisher")
            time.sleep(0.01)

    def wait_for(self, condition):
        """Wait until condition(messages) holds; return whether it does."""
        with self._changed:
            return self._changed.wait_for(lambda: condition(self.messages), LONG)

    def close(self):
        """Stop listening."""
        for subscriber in self._subscribers:
            subscriber.unregister()


class Driver:
    """Answers for a car, which is a participant: one command a period, so that none comes late."""

    def __init__(self, car, stepper):
        self._stepper = stepper
        self._commands = rospy.Publisher(f"/{car}/cmd_vel", Twist, queue_size=10)

    def drive_to(self, end_ns, linear_x, angular_z=0.0):
        """Advance period by period until the one that ends at end_ns is there."""
        wait_for_subscriber(self._commands)
        command = Twist()
        command.linear.x, command.angular.z = linear_x, angular_z
        if not self._stepper.now:
            self._stepper.advance_to(PERIOD_NS)
        for end in range(self._stepper.now + PERIOD_NS, end_ns + 1, PERIOD_NS):
            self._commands.publish(command)
            self._stepper.advance_to(end)

    def close(self):
        """Stop answering."""
        self._commands.unregister()


class Stepper:
    """The lockstep participant `test`, as this node is called: lets the simulation advance period by period.

    It stays in its first period, which it repeats for those who connect, until advance_to() is called.
    """

    def __init__(self):
        self._allowed = 0
        self.now = 0
        self._changed = threading.Condition()
        self._done = rospy.Publisher("/sim2d/done", Header, queue_size=100)
        self._clock = rospy.Subscriber("/clock", Clock, self._on_clock, tcp_nodelay=True)

    def _on_clock(self, message):
        with self._changed:
            self.now = message.clock.to_nsec()
            self._changed.notify_all()
            self._answer()

    def _answer(self):
        if 0 < self.now <= self._allowed:
            header = Header(frame_id="test")
            header.stamp = rospy.Time(0, self._allowed if self._allowed == LEFT_NS else self.now)
            self._done.publish(header)

    def restart(self):
        """Hold the simulation in its first period again."""
        with self._changed:
            self._allowed = self.now = 0

    def leave(self):
        """Answer whatever comes from now on."""
        with self._changed:
            self._allowed = LEFT_NS
            self._answer()

    def advance_to(self, end_ns):
        """Let the simulation advance until the period that ends at end_ns is there, and hold it there."""
        with self._changed:
            self._allowed = end_ns - 1
            self._answer()
            reached = self._changed.wait_for(lambda: self.now >= end_ns, LONG)
        if not reached:
            raise AssertionError(f"the simulator has not reached {end_ns} ns, it is at {self.now} ns")

    def close(self):
        """Stop answering."""
        self._clock.unregister()
        self._done.unregister()
