"""Killing a ROS node for certain."""

import os
import signal
import time

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.run.processes import wait_for_ends

from f1tenth_scenarios.run.ros_graph import ask

_PATIENCE = 2.0  # wall s


def kill_node(name: str) -> None:
    """End a node of this machine with SIGKILL and return when it is gone.

    Args:
        name: without the leading slash, as in `robot1/move_base`

    Raises:
        ScenarioError: there is no such node, or it does not go.
    """
    pid = ask(name, "getPid")
    try:
        os.kill(pid, signal.SIGKILL)
    except OSError as error:
        raise ScenarioError(f"cannot kill {name}: {error.strerror}") from error
    if not wait_for_ends([pid], time.monotonic() + _PATIENCE):
        raise ScenarioError(f"cannot kill {name}: it is still there after {_PATIENCE:g} s")
