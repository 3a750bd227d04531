"""Runs the commands of this package as processes."""

import os
import signal
import subprocess

import rospkg

LONG = 60.0  # wall s: only a hang takes that long


def command_path(name):
    """Return the path of a command in the devel or install space."""
    paths = [
        os.path.join(p, "lib", "controller_manager", name) for p in os.environ["CMAKE_PREFIX_PATH"].split(":")
    ]
    paths.append(os.path.join(rospkg.RosPack().get_path("controller_manager"), "scripts", name))
    return next(path for path in paths if os.access(path, os.X_OK))


def start(name, *arguments, namespace):
    """Start a command whose output is a pipe."""
    return subprocess.Popen(
        [command_path(name), *arguments],
        env={**os.environ, "ROS_NAMESPACE": namespace, "PYTHONUNBUFFERED": "1"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def run_until(text, name, *arguments, namespace, before_end=lambda: None):
    """Start a command, interrupt it when it says the text, and return its exit code and all that it has said.

    Args:
        before_end: what to do before it is interrupted.
    """
    process = start(name, *arguments, namespace=namespace)
    said = []
    for line in process.stdout:
        said.append(line)
        if text in line:
            before_end()
            process.send_signal(signal.SIGINT)
    return process.wait(LONG), "".join(said)
