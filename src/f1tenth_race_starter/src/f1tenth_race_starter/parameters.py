"""The node's parameters, read once and checked."""

from dataclasses import dataclass, fields

INT32_MAX = 2**31 - 1


class ParameterError(ValueError):
    """A parameter that cannot be used; the text is one line for the user."""


@dataclass(frozen=True)
class Parameters:
    """What race_starter reads from its private namespace."""

    time_to_start: int = 5  # s of ROS time
    lockstep: bool = False
    linger: float = 5.0  # wall s


def parse_parameters(raw, namespace):
    """Check the private parameters.

    Args:
        raw: dict as on the parameter server.
        namespace: where they stand there, for the messages ("/race_starter").

    Raises:
        ParameterError: "NAMESPACE/KEY: what is wrong".

    """
    allowed = [field.name for field in fields(Parameters)]
    for key in raw:
        if key not in allowed:
            raise ParameterError(
                f"{namespace}/{key}: unknown parameter, expected one of: {', '.join(allowed)}"
            )
    parameters = Parameters(**raw)
    for key, (is_valid, expected) in _RULES.items():
        value = getattr(parameters, key)
        if not is_valid(value):
            raise ParameterError(f"{namespace}/{key}: expected {expected}, found {value!r}")
    return parameters


def _is_number(value, types):
    # To Python True is an int.
    return isinstance(value, types) and not isinstance(value, bool)


_RULES = {
    "time_to_start": (
        lambda value: _is_number(value, int) and 0 <= value <= INT32_MAX,
        f"a whole number of seconds from 0 to {INT32_MAX}",
    ),
    "lockstep": (lambda value: isinstance(value, bool), "true or false"),
    "linger": (
        lambda value: _is_number(value, (int, float)) and 0 <= value < float("inf"),
        "a number of seconds, 0 or more",
    ),
}
