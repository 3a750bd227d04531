"""A ROS master of our own, on a port that is free for certain."""

import contextlib
import logging
import os
import signal
from collections.abc import Iterator

from rosmaster.master import Master

from f1tenth_scenarios.errors import ScenarioError

_STOP_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


@contextlib.contextmanager
def private_master() -> Iterator[str]:
    """Serve a master, only to this machine, and point ROS_MASTER_URI to it; gives its URI.

    It is a fork of this process: the nodes of a run ask it a thousand things and would have to wait for
    whatever else goes on here. Unlike a roscore, it gets its port from the system and cannot outlive us.

    Raises:
        ScenarioError: it does not start.
    """
    before = {name: os.environ.get(name) for name in ("ROS_HOSTNAME", "ROS_IP", "ROS_MASTER_URI")}
    os.environ.pop("ROS_IP", None)
    os.environ["ROS_HOSTNAME"] = "localhost"
    life, ours = os.pipe()  # at whose end the master ends
    uris, told = os.pipe()
    pid = os.fork()
    if pid == 0:
        os.close(ours)
        _serve(life, told)
    os.close(life)
    os.close(told)
    with open(uris, encoding="utf-8") as stream:
        uri = stream.read()
    try:
        if not uri:
            raise ScenarioError("the ROS master of the run has not started; is there a host 'localhost'?")
        os.environ["ROS_MASTER_URI"] = uri
        yield uri
    finally:
        os.close(ours)
        os.waitpid(pid, 0)
        _restore(before)


def _serve(life: int, told: int) -> None:
    """Until the other end of `life` is closed; the URI goes to `told`."""
    try:
        # Of Ctrl-C and the like our parent makes what it should be.
        for number in _STOP_SIGNALS:
            signal.signal(number, signal.SIG_IGN)
        # It would complain of every node that has ended before it was told of another's end.
        logging.getLogger("rosmaster").addHandler(logging.NullHandler())
        master = Master(port=0)
        master.start()
        with open(told, "w", encoding="utf-8") as stream:
            stream.write(master.uri)
        os.read(life, 1)
    finally:
        os._exit(0)


def _restore(variables) -> None:
    for name, value in variables.items():
        if value is None:
            os.environ.pop(name, None)
        else:
            os.environ[name] = value
