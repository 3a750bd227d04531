"""Who published what was heard: on a topic of ROS 1 anybody may."""

from collections.abc import Callable
from typing import Any


def sender(message: Any) -> str:
    """The node that published a message that a rospy subscriber has got, without the leading slash."""
    return message._connection_header["callerid"].strip("/")


def heard_from(node: str, take: Callable[[Any], None]) -> Callable[[Any], None]:
    """A callback that takes a node's own messages."""

    def take_own(message):
        if sender(message) == node:
            take(message)

    return take_own
