"""The command line of spawn_model."""

import argparse
import math

from .errors import UsageError


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


def _parser(namespace):
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
    parser.add_argument(
        "-robot_namespace", default=namespace, help="ROS namespace; default: that of this node"
    )
    parser.add_argument("-gazebo_namespace", default="/gazebo", help="of the services")
    parser.add_argument("-reference_frame", default="", help="a model or link; default: the world")
    for axis in "xyz":
        parser.add_argument(f"-{axis}", type=_number, default=0.0, help="m")
    for angle in "RPY":
        parser.add_argument(f"-{angle}", type=_number, default=0.0, help="rad")
    parser.add_argument(
        "-J", dest="joints", nargs=2, action="append", default=[], metavar=("JOINT", "POSITION")
    )
    parser.add_argument(
        "-package_to_model", action="store_true", help="accepted; package:// is found as model:// is"
    )
    parser.add_argument("-wait", metavar="MODEL", help="wait for this model first")
    parser.add_argument("-unpause", action="store_true", help="set the simulator going afterwards")
    parser.add_argument(
        "-b", "-bond", action="store_true", dest="bond", help="delete the model when this node ends"
    )
    return parser


def parse(arguments, namespace):
    """Read the arguments without the name of the program; remappings are ignored.

    Args:
        namespace: of this node, the default of the robot's.

    Raises:
        UsageError: it cannot be understood.
    """
    options = _parser(namespace).parse_args([each for each in arguments if ":=" not in each])
    for name, position in options.joints:
        try:
            _number(position)
        except argparse.ArgumentTypeError as error:
            raise UsageError(f"argument -J {name}: {error}") from None
    return options
