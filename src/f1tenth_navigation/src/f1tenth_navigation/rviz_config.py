"""Turns an rviz configuration written for robot1 into one for another car."""

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
