"""Runs the node with other nodes around it, under a master of its own."""

import contextlib
import json
import os
import signal
import subprocess
import tempfile
import time
from pathlib import Path

import psutil
import rosgraph
from f1tenth_scenarios.launch.private_master import private_master

from f1tenth_bench.places import executable
from f1tenth_bench.simulator.cars import F1TENTH, description

CALLER = "/f1tenth_bench"
LONG = 60.0  # wall s: only a hang takes that long
CIRCLING = "command_timeout: 1.0e+6\n"
"""Vehicle file of a car that goes on with its last command."""


class RosRun:
    """A ROS master and processes under it; a context manager that ends them all."""

    def __init__(self):
        self._stack = contextlib.ExitStack()
        self.folder = Path(self._stack.enter_context(tempfile.TemporaryDirectory(prefix="f1tenth_bench_")))
        self._processes = []

    def __enter__(self):
        self._stack.enter_context(private_master())
        self._master = rosgraph.Master(CALLER)
        return self

    def __exit__(self, *error):
        for process in reversed(self._processes):
            if process.poll() is None:
                process.kill()
                process.wait()
        self._stack.close()

    def set_param(self, name, value):
        """Set a parameter; a dictionary sets a tree."""
        self._master.setParam(name, value)

    def wait_for_service(self, name):
        """Wait until a node offers it."""
        _wait_for(self._master.lookupService, name)

    def wait_for_node(self, name):
        """Wait until it is known."""
        _wait_for(self._master.lookupNode, name)

    def start(self, command, namespace="/"):
        """Start a process; its output is kept."""
        process = subprocess.Popen(
            command,
            env={
                **os.environ,
                "ROS_NAMESPACE": namespace,
                "ROS_LOG_DIR": str(self.folder),
                "ROS_HOME": str(self.folder),
            },
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        self._processes.append(process)
        return process

    def start_sim2d(self, world, lidar=F1TENTH, pose=(0.0, 0.0, 0.0), **parameters):
        """Start the simulator with the workspace's car as robot1.

        Args:
            world: Path.
            pose: x, y, yaw of the start, m and rad.
            parameters: private parameters of the node besides.
        """
        vehicle = self.folder / "vehicle.yaml"
        vehicle.write_text(CIRCLING)
        x, y, yaw = map(float, pose)
        car = {"x": x, "y": y, "yaw": yaw, "vehicle": str(vehicle)}
        self.set_param("/use_sim_time", True)
        self.set_param("/robot1/robot_description", description(lidar))
        defaults = {"world": str(world), "cars": {"robot1": car}, "result_file": str(self.result_file)}
        self.set_param("/sim2d", {**defaults, **parameters})
        return self.start([executable("sim2d")])

    @property
    def result_file(self):
        """Where the simulator writes its result."""
        return self.folder / "result.json"

    def result(self):
        """What the simulator has written."""
        return json.loads(self.result_file.read_text())


def end(process):
    """Ask a process to end; return what it printed."""
    process.send_signal(signal.SIGINT)
    return process.communicate(timeout=LONG)[0]


def resident_megabytes(process):
    """Resident set of a running process, MB."""
    return psutil.Process(process.pid).memory_info().rss / 2**20


def processor_seconds(process):
    """Processor time of a running process so far, s."""
    times = psutil.Process(process.pid).cpu_times()
    return times.user + times.system


def _wait_for(look_up, name):
    deadline = time.monotonic() + LONG
    while True:
        try:
            return look_up(name)
        except rosgraph.MasterError:
            if time.monotonic() > deadline:
                raise TimeoutError(f"{name} has not come within {LONG:g} s") from None
        time.sleep(0.02)
