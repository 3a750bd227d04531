"""roslaunch, which tells what becomes of its nodes: python3 -m f1tenth_scenarios.launch.launcher FILE.

It writes events into a pipe that no node inherits, so nothing that a node prints can be mistaken for one.
"""

import contextlib
import json
import os
import sys
from typing import Any

import roslaunch
import roslaunch.launch
from roslaunch.node_args import NodeParamsException, create_local_process_args
from roslaunch.pmon import ProcessListener

from f1tenth_scenarios.launch.launch_events import PIPE


class _Teller(ProcessListener):
    """Writes an event per line, as JSON."""

    def __init__(self, descriptor: int, monitor):
        self._descriptor, self._monitor = descriptor, monitor
        self._told: set[tuple[str, int]] = set()

    def started(self, process) -> None:
        """A process runs."""
        self._tell(event="started", process=process.name, pid=process.pid)

    def refused(self, node, reason: str) -> None:
        """There is nothing that could be run."""
        self._tell(event="refused", package=node.package, type=node.type, reason=reason)

    def process_died(self, name, exit_code) -> None:
        """Called by roslaunch; again and again for a process that it is going to start anew."""
        process = self._monitor.get_process(name)
        if (name, process.spawn_count) in self._told:
            return
        self._told.add((name, process.spawn_count))
        self._tell(
            event="ended",
            process=name,
            exit_code=exit_code,
            package=process.package,
            is_required=process.required,
            log_file=os.path.join(process.log_dir or "", name.replace("/", "-")) + "*.log",
            said=os.fstat(sys.stdout.fileno()).st_size,
        )

    def _tell(self, **event: Any) -> None:
        with contextlib.suppress(BrokenPipeError):  # nobody listens any more
            os.write(self._descriptor, (json.dumps(event) + "\n").encode())


class _Runner(roslaunch.launch.ROSLaunchRunner):
    """Starts the nodes."""

    def __init__(self, *arguments, **named):
        super().__init__(*arguments, **named)
        self._teller = _Teller(_DESCRIPTOR, self.pm)
        # Not by ROSLaunchParent, which would listen only when all nodes have been started.
        self.pm.add_process_listener(self._teller)

    def launch_node(self, node, core=False):
        """Start a node, as roslaunch does, and tell of it."""
        process, is_started = super().launch_node(node, core)
        if is_started:
            self._teller.started(process)
        else:
            self._tell_why_not(node)
        return process, is_started

    def _tell_why_not(self, node) -> None:
        try:
            create_local_process_args(node, node.machine)
        except NodeParamsException as error:
            self._teller.refused(node, str(error))


if __name__ == "__main__":
    _DESCRIPTOR = int(os.environ.pop(PIPE))
    os.set_inheritable(_DESCRIPTOR, False)
    roslaunch.launch.ROSLaunchRunner = _Runner
    roslaunch.main(["roslaunch", *sys.argv[1:]])
