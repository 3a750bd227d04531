"""A node written in Python, started as a fork of this process.

What is imported here it need not import again: numpy, the messages and roslib are most of the quarter of a
second of processor time that rospy takes in each of them. rospy itself is not imported, as it looks at the
command line then.
"""

import atexit
import os
import re
import runpy
import signal
import sys
import threading
import traceback
from typing import Optional, TextIO

import numpy  # noqa: F401
import rospkg
import std_msgs.msg  # noqa: F401
from roslaunch.core import printlog_bold
from roslaunch.nodeprocess import LocalProcess

_SHEBANG = re.compile(rb"#!(/usr/bin/env python3|/usr/bin/python3)\s")


def is_python_node(described: LocalProcess) -> bool:
    """Whether a node is a Python script that runs in this interpreter as well, without any prefix."""
    executable = described.args[0]
    if described.cwd or not os.path.isfile(executable):
        return False
    with open(executable, "rb") as stream:
        return bool(_SHEBANG.match(stream.read(100)))


class PythonNode(LocalProcess):
    """A node as roslaunch describes it; only its start is another one."""

    def __init__(self, described: LocalProcess):
        self.__dict__.update(described.__dict__)

    def start(self) -> bool:
        """Start the node; returns whether it runs."""
        self.spawn_count += 1
        output, _ = self._configure_logging()
        self.popen = _Fork(self.args, output, self.env)
        self.pid, self.started, self.stopped = self.popen.pid, True, False
        printlog_bold(f"process[{self.name}]: started with pid [{self.pid}]")
        return True


class _Fork:
    """Stands in for the subprocess.Popen of a LocalProcess."""

    def __init__(self, arguments: list[str], output: Optional[TextIO], environment: dict[str, str]):
        """`output`: where its standard output goes; None: where ours does."""
        sys.stdout.flush()
        sys.stderr.flush()
        self.returncode: Optional[int] = None
        self.pid = os.fork()
        if self.pid == 0:
            _become(arguments, output, environment)

    def poll(self) -> Optional[int]:
        """The exit code; nothing while it runs."""
        if self.returncode is None:
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            self.returncode = os.waitstatus_to_exitcode(status) if pid else None
        return self.returncode


def _become(arguments, output, environment) -> None:
    """Run the script as if this process had been started for it, and end as an interpreter does."""
    code = 1
    try:
        _leave_parent(output, environment)
        code = _run(arguments)
        threading._shutdown()
        atexit._run_exitfuncs()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)


def _leave_parent(output, environment) -> None:
    os.setsid()
    atexit._clear()
    signal.set_wakeup_fd(-1)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)
    if output:
        os.dup2(output.fileno(), sys.stdout.fileno())
    os.closerange(3, os.sysconf("SC_OPEN_MAX"))
    folder = rospkg.get_ros_home()
    os.makedirs(folder, exist_ok=True)
    os.chdir(folder)
    os.environ.clear()
    os.environ.update(environment)


def _run(arguments) -> int:
    sys.argv = list(arguments)
    sys.path[0] = os.path.dirname(arguments[0])
    try:
        runpy.run_path(arguments[0], run_name="__main__")
    except SystemExit as end:
        return _exit_code(end)
    except BaseException:
        traceback.print_exc()
        return 1
    return 0


def _exit_code(end: SystemExit) -> int:
    if end.code is None or isinstance(end.code, int):
        return end.code or 0
    print(end.code, file=sys.stderr)
    return 1
