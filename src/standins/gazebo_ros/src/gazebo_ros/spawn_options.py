"""The command line of spawn_model."""

import argparse
import math
from dataclasses import dataclass
from typing import Optional

from .errors import UsageError


@dataclass(frozen=True)
class SpawnOptions:
    """What to spawn, from where, and where to."""

    kind: str
    """"urdf" or "sdf"."""
    param: Optional[str]
    file: Optional[str]
    database: Optional[str]
    stdin: bool
    model: str
    robot_namespace: str
    reference_frame: str
    xyz: tuple
    """m."""
    rpy: tuple
    """rad."""
    joints: tuple
    """(name, position in rad or m) of each -J."""
    wait: Optional[str]
    """A model to wait for first."""
    unpause: bool
    bond: bool
    gazebo_namespace: str


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise UsageError(message)


def _number(text):
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"found {text!r}, expected a finite number")
    return value


def _parser():
    parser = _Parser(prog="spawn_model", add_help=True, allow_abbrev=False)
    kind = parser.add_mutually_exclusive_group(required=True)
    kind.add_argument(
        "-urdf", action="store_const", const="urdf", dest="kind", help="the description is URDF"
    )
    kind.add_argument("-sdf", action="store_const", const="sdf", dest="kind", help="the description is SDF")
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument("-param", help="ROS parameter that holds the description")
    source.add_argument("-file", help="file that holds the description")
    source.add_argument("-database", help="name of a model below GAZEBO_MODEL_PATH")
    source.add_argument("-stdin", action="store_true", help="the description comes from the standard input")
    parser.add_argument("-model", required=True, help="name of the model")
    parser.add_argument("-robot_namespace", help="ROS namespace; default: that of this node")
    parser.add_argument("-gazebo_namespace", default="/gazebo", help="of the services")
    parser.add_argument("-reference_frame", default="", help="a model or link; default: the world")
    for axis in "xyz":
        parser.add_argument(f"-{axis}", type=_number, default=0.0, help="m")
    for angle in "RPY":
        parser.add_argument(f"-{angle}", type=_number, default=0.0, help="rad")
    parser.add_argument("-J", nargs=2, action="append", default=[], metavar=("JOINT", "POSITION"))
    parser.add_argument("-wait", metavar="MODEL", help="wait for this model first")
    parser.add_argument("-unpause", action="store_true", help="set the simulator going afterwards")
    parser.add_argument(
        "-b", "-bond", action="store_true", dest="bond", help="delete the model when this node ends"
    )
    return parser


def parse(arguments, namespace):
    """Read the arguments without the name of the program, remappings left aside.

    Args:
        namespace: of this node, the default of the robot's.

    Raises:
        UsageError: it cannot be understood.
    """
    found = _parser().parse_args([each for each in arguments if ":=" not in each])
    return SpawnOptions(
        kind=found.kind,
        param=found.param,
        file=found.file,
        database=found.database,
        stdin=found.stdin,
        model=found.model,
        robot_namespace=namespace if found.robot_namespace is None else found.robot_namespace,
        reference_frame=found.reference_frame,
        xyz=(found.x, found.y, found.z),
        rpy=(found.R, found.P, found.Y),
        joints=tuple(_joint(*pair) for pair in found.J),
        wait=found.wait,
        unpause=found.unpause,
        bond=found.bond,
        gazebo_namespace=found.gazebo_namespace,
    )


def _joint(name, position):
    try:
        return name, _number(position)
    except argparse.ArgumentTypeError as error:
        raise UsageError(f"argument -J {name}: {error}") from None
