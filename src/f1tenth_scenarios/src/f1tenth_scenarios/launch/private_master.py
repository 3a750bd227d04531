"""Our own ROS master on a free port: python3 -m f1tenth_scenarios.launch.private_master."""

import contextlib
import logging
import os
import signal
import subprocess
import sys
from collections.abc import Iterator

import psutil
from f1tenth_judge.errors import ScenarioError

_ENVIRONMENT = ("ROS_HOSTNAME", "ROS_IP", "ROS_MASTER_URI")


@contextlib.contextmanager
def private_master() -> Iterator[str]:
    """Serve a master, only to this machine, and point ROS_MASTER_URI to it; gives its URI.

    Unlike a roscore, it gets its port from the system and cannot outlive this process.

    Raises:
        ScenarioError: it does not start.
    """
    before = {name: os.environ.get(name) for name in _ENVIRONMENT}
    os.environ.pop("ROS_IP", None)
    os.environ["ROS_HOSTNAME"] = "localhost"
    command = [sys.executable, "-m", "f1tenth_scenarios.launch.private_master"]
    # In its own session, and deaf to signals until it has one: this process handles Ctrl-C.
    unblocked = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        master = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, start_new_session=True
        )
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, unblocked)
    try:
        assert master.stdout
        uri = master.stdout.readline().strip()
        if not uri:
            raise ScenarioError("the ROS master of the run has not started; is there a host 'localhost'?")
        os.environ["ROS_MASTER_URI"] = uri
        yield uri
    finally:
        master.communicate()
        _restore(before)


def master_process() -> dict[str, int]:
    """The id of the master that this process has started, by the name `master`; empty if it has not."""
    for each in psutil.Process().children():
        with contextlib.suppress(psutil.Error):  # one that has just ended
            if __name__ in each.cmdline():
                return {"master": each.pid}
    return {}


def _restore(variables) -> None:
    for name, value in variables.items():
        if value is None:
            os.environ.pop(name, None)
        else:
            os.environ[name] = value


def _serve() -> None:
    """Until the end of the input; the URI goes to the output."""
    from rosmaster.master import Master

    # They would complain of every node that has ended before it was told of another's end, or answered.
    for name in ("rosmaster", "xmlrpc"):
        logging.getLogger(name).addHandler(logging.NullHandler())
    master = Master(port=0)
    master.start()
    print(master.uri, flush=True)
    sys.stdin.read()
    # Its threads would keep running for as long as they call a node that has ended.
    os._exit(0)


if __name__ == "__main__":
    _serve()
