"""The sockets of planners send small messages at once, without being asked."""

import os
import socket
import subprocess
import sys

import pytest
from f1tenth_scenarios.launch.prompt_sockets import PromptSockets

PROGRAM = """
import os, socket, subprocess, sys
another = subprocess.Popen(["sleep", "600"])
listening = socket.create_server(("127.0.0.1", 0))
def pair():
    one = socket.create_connection(listening.getsockname())
    return one, listening.accept()[0]
early, beside = pair(), open("/dev/null")
print("ready", flush=True)
sys.stdin.readline()
late = pair()
print(*(each.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY) != 0 for each in (*early, *late)))
print(os.get_blocking(listening.fileno()))
another.kill()
"""


@pytest.fixture(autouse=True)
def _as_rospy_has_it():
    """A time limit of this process's sockets is none of theirs."""
    before = socket.getdefaulttimeout()
    socket.setdefaulttimeout(60.0)
    yield
    socket.setdefaulttimeout(before)


@pytest.mark.parametrize(
    ("mark", "told"), [("red", "True True False True"), ("blue", "False False False False")]
)
def test_what_is_open_and_what_is_accepted_later(mark, told):
    with subprocess.Popen(
        [sys.executable, "-c", PROGRAM],
        env={**os.environ, "COLOUR": "red"},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout.readline() == "ready\n"
        sockets = PromptSockets([f"COLOUR={mark}"])
        sockets.poll()
        if sockets.refusal:
            process.communicate("")
            pytest.skip(f"the kernel does not give the sockets of other processes: {sockets.refusal}")
        assert process.communicate("go on\n")[0] == f"{told}\nTrue\n"


def test_without_processes_there_is_nothing_to_do():
    sockets = PromptSockets(["COLOUR=none"])
    sockets.poll()
    assert not sockets.refusal
