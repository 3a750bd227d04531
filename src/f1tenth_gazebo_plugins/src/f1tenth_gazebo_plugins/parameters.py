"""What collision_detection can be told."""

from dataclasses import dataclass

from workspace_support.nodes import ParameterError, parse_parameters

BUMPERS = ("bumper_front", "bumper_rear", "bumper_left", "bumper_right")


@dataclass(frozen=True)
class Parameters:
    """topics: contact sensors to listen to. ground_models: models that a car may touch."""

    topics: tuple[str, ...] = BUMPERS
    ground_models: tuple[str, ...] = ("ground_plane",)


def read_parameters(name, found):
    """Check the private parameters of the node of a name; raises ParameterError."""
    parameters = parse_parameters(Parameters, (name, found))
    if not parameters.topics:
        raise ParameterError(f"parameter {name}/topics: found [], must be at least one topic")
    return parameters
