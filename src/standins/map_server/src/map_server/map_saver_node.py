"""The node map_saver: one message from `map` into NAME.pgm and NAME.yaml."""

import argparse
import sys

import rospy
from nav_msgs.msg import OccupancyGrid

from map_server.conversions import from_occupancy_grid
from map_server.errors import MapError
from map_server.map_io import DEFAULT_FREE, DEFAULT_OCCUPIED, save_map


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        self.print_usage(sys.stderr)
        self.exit(1, f"{self.prog}: error: {message}\n")


def _percentage(lowest):
    def parse(text):
        if not text.isdecimal() or not lowest <= int(text) <= 100:
            raise argparse.ArgumentTypeError(
                f"found {text!r}, allowed is a whole number from {lowest} to 100"
            )
        return int(text)

    return parse


def parse_arguments(arguments):
    """Return the options; a wrong one prints usage and reason and exits with 1."""
    parser = _Parser(prog="map_saver", description="Save one map from the topic `map`.", allow_abbrev=False)
    parser.add_argument("-f", dest="name", default="map", help="write NAME.pgm and NAME.yaml", metavar="NAME")
    parser.add_argument(
        "--occ", type=_percentage(1), default=DEFAULT_OCCUPIED, help="cells from this value on are occupied"
    )
    parser.add_argument(
        "--free", type=_percentage(0), default=DEFAULT_FREE, help="cells up to this value are free"
    )
    options = parser.parse_args(arguments)
    if options.occ <= options.free:
        parser.error(f"--occ {options.occ} must exceed --free {options.free}")
    return options


def main(argv=None):
    """Run the node; return its exit code."""
    options = parse_arguments(rospy.myargv(argv or sys.argv)[1:])
    rospy.init_node("map_saver")
    rospy.loginfo("Waiting for a map on %s", rospy.resolve_name("map"))
    try:
        grid = from_occupancy_grid(rospy.wait_for_message("map", OccupancyGrid))
        rospy.loginfo("Received a map of %d x %d cells of %.3f m", grid.width, grid.height, grid.resolution)
        files = save_map(grid, options.name, options.occ, options.free)
    except MapError as error:
        rospy.logfatal("%s", error)
        return 1
    except rospy.ROSInterruptException:
        print("map_saver: ended before a map arrived, nothing is saved", file=sys.stderr)
        return 1
    rospy.loginfo("Saved the map as %s and %s", *files)
    return 0
