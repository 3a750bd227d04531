"""What the three commands understand."""

import argparse
from collections.abc import Sequence
from typing import Callable

import rospy

from . import controller_manager_interface as manager

DEFAULT_TIMEOUT = 30.0  # wall s


def spawner_parser():
    """The parser of `spawner`."""
    parser = argparse.ArgumentParser(
        prog="spawner", description="Load and start controllers; stop them at the end."
    )
    parser.add_argument("controllers", nargs="+", metavar="CONTROLLER", help="name; its type is in NAME/type")
    parser.add_argument("--stopped", action="store_true", help="load, but do not start")
    parser.add_argument("--wait-for", metavar="TOPIC", help="start when a true std_msgs/Bool has come on it")
    parser.add_argument("--namespace", metavar="NS", help="of the controller manager")
    parser.add_argument(
        "--timeout", type=float, default=DEFAULT_TIMEOUT, help="wall s for the controller manager"
    )
    parser.add_argument(
        "--no-timeout", dest="timeout", action="store_const", const=None, help="wait for ever"
    )
    parser.add_argument(
        "--shutdown-timeout", type=float, default=1.0, help="wall s for the controller manager at the end"
    )
    return parser


def unspawner_parser():
    """The parser of `unspawner`."""
    parser = argparse.ArgumentParser(
        prog="unspawner", description="Stop controllers; start them again at the end."
    )
    parser.add_argument("controllers", nargs="+", metavar="CONTROLLER")
    parser.add_argument("--namespace", metavar="NS", help="of the controller manager")
    return parser


def _each(action, names):
    """Whether the action worked for all; it is tried for every one."""
    return all([action(name) for name in names])  # noqa: C419


COMMANDS: dict[str, Callable[[Sequence[str]], bool]] = {
    "list": lambda names: manager.list_controllers(),
    "list-types": lambda names: manager.list_controller_types(),
    "reload-libraries": lambda names: manager.reload_libraries(),
    "load": lambda names: _each(manager.load_controller, names),
    "unload": lambda names: _each(manager.unload_controller, names),
    "start": manager.start_controllers,
    "stop": manager.stop_controllers,
    "spawn": lambda names: _each(manager.load_controller, names) and manager.start_controllers(names),
    "kill": lambda names: manager.stop_controllers(names) and _each(manager.unload_controller, names),
}
WITHOUT_NAMES = ("list", "list-types", "reload-libraries")


def manager_parser():
    """The parser of `controller_manager`."""
    parser = argparse.ArgumentParser(prog="controller_manager")
    parser.add_argument("command", choices=COMMANDS)
    parser.add_argument("controllers", nargs="*", metavar="CONTROLLER")
    return parser


def run_manager(arguments):
    """Do one command; return the exit code."""
    parser = manager_parser()
    found = parser.parse_args(arguments)
    if not found.controllers and found.command not in WITHOUT_NAMES:
        parser.error(f"{found.command}: name at least one controller")
    # Not before the arguments are known to be good: it waits for a master.
    rospy.init_node("controller_manager_command", anonymous=True)
    return 0 if COMMANDS[found.command](found.controllers) else 1
