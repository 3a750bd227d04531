"""What nodes in Python share: parameters that are read once, publishers that send at once."""

import warnings
from dataclasses import fields
from math import inf

import rospy

_INT32_MAX = 2**31 - 1
_RULES = {
    bool: ("true or false", lambda value: isinstance(value, bool)),
    str: ("a text that is not empty", lambda value: isinstance(value, str) and value),
    # To Python True is an int.
    int: (
        f"a whole number from 0 to {_INT32_MAX}",
        lambda value: type(value) is int and 0 <= value <= _INT32_MAX,
    ),
    float: ("a number >= 0", lambda value: type(value) in (int, float) and 0 <= value < inf),
    tuple: ("a list of names", lambda value: isinstance(value, list)),
}


class ParameterError(ValueError):
    """A parameter that cannot be used; the text is one line for the user."""


def parse_parameters(kind, *sources):
    """Make a `kind` of what is on the parameter server.

    Args:
        kind: a dataclass whose fields have defaults, of the types bool, str, int and float (not negative) or
            tuple (of names).
        sources: (place, dict) pairs, the most important first; a place is what messages call it ("/n").

    Raises:
        ParameterError: "parameter PLACE/KEY: what is wrong"; PLACE/KEY[i] if it is a name in a list.

    """
    defaults: dict = {field.name: field.default for field in fields(kind)}
    merged: dict = {}
    for place, found in reversed(sources):
        if not isinstance(found, dict):
            raise ParameterError(f"parameter {place}: found {found!r}, must be a map")
        for key, value in found.items():
            if key not in defaults:
                raise ParameterError(f"parameter {place}/{key}: unknown; allowed: {', '.join(defaults)}")
            allowed, is_valid = _RULES[type(defaults[key])]
            if not is_valid(value):
                raise ParameterError(f"parameter {place}/{key}: found {value!r}, must be {allowed}")
            if isinstance(value, list):
                _check_names(f"parameter {place}/{key}", value)
            merged[key] = type(defaults[key])(value)
    return kind(**merged)


def synchronous_publisher(topic, message_type, **options):
    """Return a publisher whose publish() has written to every subscriber's socket when it returns.

    With a queue, rospy writes in a thread of its own: the message could be overtaken by the `done` that says
    it was sent, and could be lost when the node ends. rospy warns of subscribers that would block it. Without
    delay, as the kernel may hold back what is written.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SyntaxWarning)
        return rospy.Publisher(topic, message_type, queue_size=None, tcp_nodelay=True, **options)


def _check_names(place, values):
    for i, value in enumerate(values):
        if not (isinstance(value, str) and value):
            raise ParameterError(f"{place}[{i}]: found {value!r}, must be a name")
        if value in values[:i]:
            raise ParameterError(f"{place}[{i}]: found {value!r} twice, must be a different name")
