"""The node's parameters, read once and checked."""

import os
from dataclasses import dataclass, fields

BLOCK = "f1tenth_race_mgr"


class ParameterError(ValueError):
    """A parameter that cannot be used; the text is one line for the user."""


@dataclass(frozen=True)
class Parameters:
    """What race_mgr reads."""

    use_absolute_fpath: bool = False
    package_name: str = "f1tenth_race_mgr"
    fpath: str = "/config/navigation_goals.txt"
    loop_mode: bool = False
    lockstep: bool = False
    wait_for_start: bool = True
    exit_when_done: bool = False


def parse_parameters(sources):
    """Merge and check parameters.

    Args:
        sources: (place, dict) pairs as on the parameter server, the most important first; a place is
            what messages call it ("/robot1/race_mgr").

    Raises:
        ParameterError: "PLACE/KEY: what is wrong".

    """
    merged = {}
    for place, raw in reversed(sources):
        if not isinstance(raw, dict):
            raise ParameterError(f"{place}: expected parameters by name, found {raw!r}")
        for key, value in raw.items():
            _check(place, key, value)
            merged[key] = value
    return Parameters(**merged)


def goals_path(parameters, find_package):
    """Return the path of the goals file.

    Args:
        parameters: the Parameters.
        find_package: maps the name of a package to its folder.

    """
    if parameters.use_absolute_fpath:
        return parameters.fpath
    return os.path.join(find_package(parameters.package_name), parameters.fpath.lstrip("/"))


_TYPES = {field.name: field.type for field in fields(Parameters)}
_EXPECTED: dict = {bool: "true or false", str: "a text"}


def _check(place, key, value):
    if key not in _TYPES:
        raise ParameterError(f"{place}/{key}: unknown parameter, expected one of: {', '.join(_TYPES)}")
    if type(value) is not _TYPES[key]:
        raise ParameterError(f"{place}/{key}: expected {_EXPECTED[_TYPES[key]]}, found {value!r}")
    if value == "":
        raise ParameterError(f"{place}/{key}: expected a text that is not empty")
