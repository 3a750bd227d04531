"""The command line of gzserver and gazebo."""

import argparse
import os
from dataclasses import dataclass

from .errors import UsageError

EMPTY_WORLD = "worlds/empty.world"


@dataclass(frozen=True)
class ServerOptions:
    """What of the command line means something here."""

    world: str
    """As written."""
    paused: bool
    profile: object
    """Name of the world's <physics> that counts, or None."""
    left_out: tuple
    """Options of the original that are accepted and do nothing."""


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise UsageError(message)


def _parser():
    parser = _Parser(prog="gzserver", add_help=False, allow_abbrev=False)
    parser.add_argument("world", nargs="?", default=EMPTY_WORLD)
    parser.add_argument("-u", "--pause", action="store_true")
    parser.add_argument("-e", "--physics", default="ode")
    for short, long in (("-s", "--server-plugin"), ("-g", "--gui-plugin")):
        parser.add_argument(short, long, action="append")
    parser.add_argument("-o", "--profile")
    for long in (
        "--seed",
        "--iters",
        "--record_path",
        "--record_encoding",
        "--record_period",
        "--record_filter",
        "--play",
    ):
        parser.add_argument(long)
    for long in ("--verbose", "--lockstep", "--record", "--minimal_comms"):
        parser.add_argument(long, action="store_true")
    parser.add_argument("-r", action="store_true", dest="record_short")
    return parser


NO_EFFECT = (
    "server_plugin",
    "gui_plugin",
    "iters",
    "record_path",
    "record_encoding",
    "record_period",
    "record_filter",
    "play",
    "lockstep",
    "record",
    "minimal_comms",
    "record_short",
)


def parse(arguments):
    """Read the arguments without the name of the program, remappings left aside.

    Returns:
        (ServerOptions, seed): seed is None unless it was given.

    Raises:
        UsageError: an option that the original does not have, or a wrong value.
    """
    found = _parser().parse_args([each for each in arguments if ":=" not in each])
    left_out = tuple(name for name in NO_EFFECT if getattr(found, name))
    return ServerOptions(found.world, found.pause, found.profile, left_out), _natural("--seed", found.seed)


def _natural(option, text):
    if text is None:
        return None
    if not text.isdigit():
        raise UsageError(f"{option}: found {text!r}, expected a whole number >= 0")
    return int(text)


def find_world(name, folders):
    """Return the path of a world.

    Args:
        name: a path, absolute or from here, or one below a folder.
        folders: looked through in order.

    Raises:
        UsageError: there is none.
    """
    for folder in ("", *folders):
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            return os.path.abspath(path)
    raise UsageError(f"no world {name}; looked here and in {', '.join(folders) or 'no other folder'}")


def resource_folders(environment, own_share):
    """Folders of GAZEBO_RESOURCE_PATH, then our own."""
    folders = environment.get("GAZEBO_RESOURCE_PATH", "").split(":")
    return [*(folder for folder in folders if folder), own_share]
