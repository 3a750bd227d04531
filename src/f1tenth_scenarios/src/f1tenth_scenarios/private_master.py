"""A ROS master of our own, on a port that is free for certain."""

import contextlib
import os
from collections.abc import Iterator

from rosmaster.master import Master


@contextlib.contextmanager
def private_master() -> Iterator[str]:
    """Serve a master from this process, only to this machine, and point ROS_MASTER_URI to it; gives its URI.

    A master inside this process, unlike a roscore, gets its port from the system and cannot outlive us.
    """
    ours = {"ROS_HOSTNAME": "localhost"}
    before = {name: os.environ.get(name) for name in ("ROS_HOSTNAME", "ROS_IP", "ROS_MASTER_URI")}
    os.environ.pop("ROS_IP", None)
    os.environ.update(ours)
    master = Master(port=0)
    master.start()
    os.environ["ROS_MASTER_URI"] = master.uri
    try:
        yield master.uri
    finally:
        master.stop()
        _restore(before)


def _restore(variables) -> None:
    for name, value in variables.items():
        if value is None:
            os.environ.pop(name, None)
        else:
            os.environ[name] = value
