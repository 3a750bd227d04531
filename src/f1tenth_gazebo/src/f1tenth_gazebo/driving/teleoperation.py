"""Driving by hand: arrow keys in a terminal, or a joystick by way of the joy package."""

import contextlib
import os
import select
import sys
import termios
import tty
from dataclasses import dataclass

import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from sensor_msgs.msg import Joy, LaserScan

from f1tenth_gazebo.driving.drive_message import drive_message

HELP = "Arrow keys: up and down change the speed, left and right steer; space stops, q ends."
SPEED_STEP, SPEED_MAX = 0.25, 3.0  # m/s
STEERING_STEP, STEERING_MAX = 0.05, 0.4  # rad
FORWARD_AXIS, SIDEWAYS_AXIS = 1, 3
"""Of most game pads: left stick forward, right stick to the left."""

KEYS = {b"\x1b[A": "up", b"\x1b[B": "down", b"\x1b[C": "right", b"\x1b[D": "left", b" ": "stop", b"q": "quit"}
KEYS.update({code.replace(b"[", b"O"): name for code, name in KEYS.items()})


@dataclass
class Command:
    """What the driver wants."""

    speed: float = 0.0
    """m/s"""
    steering: float = 0.0
    """rad, left is positive."""

    def press(self, key):
        """Change with a key: up, down, left, right or stop."""
        if key == "stop":
            self.speed = self.steering = 0.0
        elif key in ("up", "down"):
            step = SPEED_STEP if key == "up" else -SPEED_STEP
            self.speed = min(max(self.speed + step, -SPEED_MAX), SPEED_MAX)
        elif key in ("left", "right"):
            step = STEERING_STEP if key == "left" else -STEERING_STEP
            self.steering = min(max(self.steering + step, -STEERING_MAX), STEERING_MAX)

    def push(self, axes):
        """Take the axes of a joystick, each -1 to 1."""
        self.speed = SPEED_MAX * _axis(axes, FORWARD_AXIS)
        self.steering = STEERING_MAX * _axis(axes, SIDEWAYS_AXIS)


def _axis(axes, index):
    return min(max(axes[index], -1.0), 1.0) if index < len(axes) else 0.0


def keys_in(data):
    """Names of the keys in what a terminal has sent, in order; others are left out."""
    names = []
    while data:
        code = next((code for code in KEYS if data.startswith(code)), data[:1])
        names += [KEYS[code]] if code in KEYS else []
        data = data[len(code) :]
    return names


@contextlib.contextmanager
def single_keys(terminal):
    """Let a terminal give keys at once and unseen."""
    before = termios.tcgetattr(terminal)
    tty.setcbreak(terminal)
    try:
        yield
    finally:
        termios.tcsetattr(terminal, termios.TCSADRAIN, before)


class Teleoperation:
    """Answers each scan with the present command, on `drive`, so that it takes part in lockstep."""

    def __init__(self):
        """Subscribe and advertise."""
        self.command = Command()
        self._publisher = rospy.Publisher("drive", AckermannDriveStamped, queue_size=1, tcp_nodelay=True)
        rospy.Subscriber("scan", LaserScan, self._on_scan, tcp_nodelay=True)
        rospy.Subscriber("joy", Joy, lambda message: self.command.push(message.axes))

    def _on_scan(self, scan):
        message = drive_message(scan.header.stamp, self.command.speed, self.command.steering)
        self._publisher.publish(message)

    def read_keys(self, terminal):
        """Follow the keys until the driver ends or ROS shuts down."""
        print(HELP, flush=True)
        while not rospy.is_shutdown():
            if not select.select([terminal], [], [], 0.1)[0]:
                continue
            data = os.read(terminal, 64)
            for key in keys_in(data):
                self.command.press(key)
                print(
                    f"\r{self.command.speed:5.2f} m/s {self.command.steering:5.2f} rad ", end="", flush=True
                )
                if key == "quit":
                    return
            if not data:
                return


def main():
    """Wire keyboard and joystick; return the exit code."""
    rospy.init_node("teleoperation")
    teleoperation = Teleoperation()
    if rospy.get_param("~keyboard", True):
        if not sys.stdin.isatty():
            print("teleoperation: found no terminal to read keys from; start it in one", file=sys.stderr)
            return 1
        with single_keys(sys.stdin.fileno()):
            teleoperation.read_keys(sys.stdin.fileno())
    else:
        rospy.spin()
    return 0
