"""ROS masters of our own."""

import os
import signal
import subprocess
import sys

import psutil
import pytest
import rosgraph
from f1tenth_scenarios.launch.private_master import master_process, private_master
from patience import PATIENCE, wait_for

SERVES = """
import signal, sys
from f1tenth_scenarios.launch.private_master import master_process, private_master
signal.signal(signal.SIGINT, lambda *_: None)
with private_master() as uri:
    print(uri, flush=True)
    sys.stdin.read()
"""


@pytest.fixture
def serving():
    """A process with a master of its own, which it keeps until its input ends; and the master's URI."""
    command = [sys.executable, "-c", SERVES]
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    with subprocess.Popen(command, **pipes, text=True, start_new_session=True) as process:
        uri = process.stdout.readline().strip()
        assert is_served(uri)
        yield process, uri
        process.kill()


def is_served(uri):
    try:
        return rosgraph.Master("/test", uri).getPid() > 0
    except OSError:
        return False


def test_masters_of_our_own_do_not_meet(monkeypatch):
    monkeypatch.setenv("ROS_MASTER_URI", "http://elsewhere:11311")
    monkeypatch.setenv("ROS_IP", "10.0.0.1")
    with private_master() as one:
        assert os.environ["ROS_MASTER_URI"] == one
        assert "ROS_IP" not in os.environ
        with private_master() as two:
            assert one != two
    assert os.environ["ROS_MASTER_URI"] == "http://elsewhere:11311"
    assert os.environ["ROS_IP"] == "10.0.0.1"


def test_master_outlives_ctrl_c_but_not_its_user(serving):
    process, uri = serving
    os.killpg(process.pid, signal.SIGINT)
    assert is_served(uri)
    process.stdin.close()
    assert process.wait(PATIENCE) == 0
    assert not is_served(uri)


def test_master_ends_with_a_killed_user(serving):
    process, uri = serving
    process.kill()
    wait_for(lambda: not is_served(uri))


def test_master_of_a_run_does_not_hear_ctrl_c():
    with private_master():
        os.kill(master_process()["master"], signal.SIGINT)
        assert rosgraph.Master("/test").getPid()


def test_child_that_has_ended_does_not_hide_the_master(monkeypatch):
    class Ended:
        pid = 1

        def cmdline(self):
            raise psutil.ZombieProcess(self.pid)

    with private_master():
        children = [each for each in psutil.Process().children() if "private_master" in str(each.cmdline())]
        monkeypatch.setattr(psutil.Process, "children", lambda _: [Ended(), *children])
        assert master_process() == {"master": children[0].pid}
