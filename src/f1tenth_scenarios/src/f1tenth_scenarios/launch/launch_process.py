"""The process that starts the nodes of a run and ends them: python3 -m f1tenth_scenarios.launch.launch_process FILE.

It does what `roslaunch FILE` does, by roslaunch's own modules, and leaves out what costs a run time: the
versions of the core, the look at the disk usage of all logs, and waits of a tenth of a second. It reads the
launch file at once, and starts the nodes when a line comes in on standard input.
"""

import functools
import logging
import sys

from roslaunch.config import ROSLaunchConfig
from roslaunch.core import Node, RLException, printerrlog
from roslaunch.node_args import NodeParamsException
from roslaunch.nodeprocess import LocalProcess, create_node_process
from roslaunch.xmlloader import XmlLoader

from f1tenth_scenarios.launch.node_group import NodeGroup
from f1tenth_scenarios.launch.python_node import PythonNode, is_python_node

_RUN_ID = "nodes"  # names the folder of the nodes' logs
_CALLER = "/scenario"
ENDED, FAILED = 0, 1  # exit codes


def main(file: str) -> int:
    """Run a launch file until told to stop by a signal; returns the exit code."""
    logging.getLogger("roslaunch").addHandler(logging.NullHandler())
    try:
        return _run(_read(file))
    except (RLException, NodeParamsException) as error:
        printerrlog(str(error))
        return FAILED
    except KeyboardInterrupt:  # while reading
        return ENDED


def _run(config: ROSLaunchConfig) -> int:
    processes = [_describe(node, config.master.uri) for node in config.nodes]
    group = NodeGroup()
    try:
        # The end of the input is that of the runner.
        if not (group.wait_for_input(sys.stdin.fileno()) and sys.stdin.readline()):
            return ENDED
        _set_parameters(config)
        group.start(processes)
        group.wait()
        return ENDED
    finally:
        group.stop()


def _read(file: str) -> ROSLaunchConfig:
    config = ROSLaunchConfig()
    loader = XmlLoader()
    # A command whose output is a parameter, as xacro's, is run once for all cars of a kind.
    loader.param_value = functools.cache(loader.param_value)
    loader.load(file, config, verbose=False)
    config.assign_machines()
    return config


def _describe(node: Node, master_uri: str) -> LocalProcess:
    described = create_node_process(_RUN_ID, node, master_uri)
    return PythonNode(described) if is_python_node(described) else described


def _set_parameters(config: ROSLaunchConfig) -> None:
    """All in one call.

    Raises:
        RLException: the master refuses one.
    """
    calls = config.master.get_multi()
    for parameter in config.params.values():
        calls.setParam(_CALLER, parameter.key, parameter.value)
    for code, message, _ in calls():
        if code != 1:
            raise RLException(message)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
