"""The parameters of collision_detection: read once, checked, then fixed."""

from __future__ import annotations

from dataclasses import dataclass, fields

BUMPERS = ("bumper_front", "bumper_rear", "bumper_left", "bumper_right")


class ParameterError(ValueError):
    """A wrong parameter; the text names it, what was found and what is allowed."""


@dataclass(frozen=True)
class Parameters:
    """topics: contact sensors to listen to. ground_models: models that a car may touch."""

    topics: tuple[str, ...] = BUMPERS
    ground_models: tuple[str, ...] = ("ground_plane",)


def parse_parameters(name, found):
    """Check the private parameters of a node.

    name: of the node, for messages. found: its parameters, or None if it has none.
    Raises ParameterError.
    """
    found = {} if found is None else found
    if not isinstance(found, dict):
        raise ParameterError(f"parameter {name}: found {found!r}, expected a map")
    allowed = [field.name for field in fields(Parameters)]
    for key in found:
        if key not in allowed:
            raise ParameterError(f"parameter {name}/{key}: unknown; allowed: {', '.join(allowed)}")
    parameters = Parameters(**{key: _names(f"{name}/{key}", value) for key, value in found.items()})
    if not parameters.topics:
        raise ParameterError(f"parameter {name}/topics: found [], expected at least one topic")
    return parameters


def _names(name, value):
    if not isinstance(value, list):
        raise ParameterError(f"parameter {name}: found {value!r}, expected a list of names")
    for index, entry in enumerate(value):
        if not isinstance(entry, str) or not entry:
            raise ParameterError(f"parameter {name}[{index}]: found {entry!r}, expected a name")
    if len(set(value)) != len(value):
        raise ParameterError(f"parameter {name}: found {value!r}, expected different names")
    return tuple(value)
