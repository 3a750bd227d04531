"""Starts rviz with a configuration for one car, made of the one for robot1."""

import argparse
import os
import sys

import rospy
import yaml

CAR = "robot1"


class ConfigError(Exception):
    """An rviz configuration that cannot be used; the text is one line for the user."""


def config_for_car(path, car_name, frame_prefix):
    """Return the text of the configuration at `path` with topics and frames of this car instead of robot1.

    `frame_prefix` may come with or without slashes; empty or "/" means frames without a prefix.
    Raises ConfigError.
    """
    prefix = frame_prefix.strip("/")
    return yaml.safe_dump(_for_car(_read(path), car_name, prefix), sort_keys=False)


def is_for_car(car_name, frame_prefix):
    """Whether a configuration as it stands already fits this car."""
    return (car_name, frame_prefix.strip("/")) == (CAR, CAR)


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


def _read(path):
    try:
        with open(path, encoding="utf-8") as file:
            config = yaml.safe_load(file)
    except OSError as error:
        raise ConfigError(f"{path}: cannot be opened: {error.strerror}") from error
    except (UnicodeDecodeError, yaml.YAMLError) as error:
        raise ConfigError(f"{path}: not an rviz configuration: {' '.join(str(error).split())}") from error
    if not isinstance(config, dict) or "Visualization Manager" not in config:
        raise ConfigError(f"{path}: not an rviz configuration: no Visualization Manager in it")
    return config


def _for_car(node, car_name, prefix):
    if isinstance(node, dict):
        return {key: _for_car(value, car_name, prefix) for key, value in node.items()}
    if isinstance(node, list):
        return [_for_car(value, car_name, prefix) for value in node]
    if isinstance(node, str):
        return _text_for_car(node, car_name, prefix)
    return node


def _text_for_car(text, car_name, prefix):
    """A name with a slash in front is a topic or parameter, one without is a frame or a frame prefix."""
    if text.startswith(f"/{CAR}/"):
        return f"/{car_name}/{text[len(CAR) + 2 :]}"
    if text == CAR:
        return prefix
    if text.startswith(f"{CAR}/"):
        return f"{prefix}/{text[len(CAR) + 1 :]}".lstrip("/")
    return text
