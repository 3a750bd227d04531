"""Starts rviz with a configuration for one car."""

import argparse
import os
import sys

import rospy

from f1tenth_navigation.rviz_config import ConfigError, config_for_car, is_for_car


def _arguments(argv):
    parser = argparse.ArgumentParser(prog="rviz_for_car", description=__doc__, allow_abbrev=False)
    parser.add_argument("--config", required=True, help="rviz configuration written for robot1")
    parser.add_argument("--car-name", default="robot1", help="car that takes the place of robot1")
    parser.add_argument("--frame-prefix", default=None, help="of its frames; / for none; default CAR_NAME/")
    options = parser.parse_args(rospy.myargv(argv)[1:])
    if options.frame_prefix is None:
        options.frame_prefix = options.car_name
    return options


def _config_path(options):
    text = config_for_car(options.config, options.car_name, options.frame_prefix)
    if is_for_car(options.car_name, options.frame_prefix):
        return options.config
    # A file in memory goes when rviz goes, however it ends.
    descriptor = os.memfd_create("rviz_config", 0)
    os.write(descriptor, text.encode())
    return f"/proc/self/fd/{descriptor}"


def main(argv=None):
    """Become rviz; return an exit code only if that fails."""
    argv = argv or sys.argv
    options = _arguments(argv)
    try:
        config = _config_path(options)
    except ConfigError as error:
        print(f"rviz_for_car: {error}", file=sys.stderr)
        return 1
    remappings = [argument for argument in argv[1:] if ":=" in argument]
    command = ["rosrun", "rviz", "rviz", "-d", config, *remappings]
    os.execvp(command[0], command)
    return None
