"""The command line of gzserver and gazebo."""

import argparse
import os

from .errors import UsageError

EMPTY_WORLD = "worlds/empty.world"
GREATEST_SEED = 2**31 - 1  # of a whole number on the parameter server


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise UsageError(message)


def _seed(text):
    if not text.isdecimal() or int(text) > GREATEST_SEED:
        raise UsageError(f"--seed: found {text!r}, expected a whole number from 0 to {GREATEST_SEED}")
    return int(text)


def parse(arguments):
    """Read the arguments without the name of the program; remappings are ignored.

    Returns:
        (options, left_out): world as written, pause, profile (name of the world's <physics> that counts) and
            seed, the last two None unless given; names of the options that are accepted and do nothing here.

    Raises:
        UsageError: an option that the original does not have, or a wrong value.
    """
    parser = _Parser(prog="gzserver", add_help=False, allow_abbrev=False)
    parser.add_argument("world", nargs="?", default=EMPTY_WORLD)
    parser.add_argument("-u", "--pause", action="store_true")
    parser.add_argument("-e", "--physics", default="ode")
    parser.add_argument("-o", "--profile")
    parser.add_argument("--seed", type=_seed)
    parser.add_argument("--verbose", action="store_true")
    with_value = ("iters", "record_path", "record_encoding", "record_period", "record_filter", "play")
    without_effect = [
        parser.add_argument("-s", "--server-plugin", action="append"),
        parser.add_argument("-g", "--gui-plugin", action="append"),
        *(parser.add_argument(f"--{name}") for name in with_value),
        *(
            parser.add_argument(f"--{name}", action="store_true")
            for name in ("lockstep", "record", "minimal_comms")
        ),
        parser.add_argument("-r", action="store_true", dest="record_short"),
    ]
    options = parser.parse_args([each for each in arguments if ":=" not in each])
    return options, [each.dest for each in without_effect if getattr(options, each.dest)]


def find_world(name, folders):
    """Return the path of a world.

    Args:
        name: a path, absolute or from the working directory, or one below a folder.
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
