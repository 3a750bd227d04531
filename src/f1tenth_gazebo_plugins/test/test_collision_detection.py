"""The node collision_detection while it ends; without a master."""

import pytest
from f1tenth_gazebo_plugins.collision_detection import CollisionDetection
from f1tenth_gazebo_plugins.parameters import Parameters
from gazebo_msgs.msg import ContactsState

from f1tenth_gazebo_plugins import collision_detection

TOPIC = "bumper_front"


class ClosingTopic:
    """A topic that is closed at the end, as rospy's are."""

    is_closed = False

    def __init__(self, *_arguments, **_options):
        self.published = 0

    def publish(self, _message):
        """Count, unless it is too late."""
        assert not ClosingTopic.is_closed, "publish() to a closed topic"
        self.published += 1


@pytest.fixture
def node(monkeypatch):
    """A node, what rospy calls when it ends, and the callback of its sensor."""
    hooks, callbacks = [], []
    monkeypatch.setattr(ClosingTopic, "is_closed", False)
    monkeypatch.setattr(collision_detection.rospy, "Publisher", ClosingTopic)
    monkeypatch.setattr(
        collision_detection.rospy,
        "Subscriber",
        lambda _topic, _kind, callback, **_: callbacks.append(callback),
    )
    monkeypatch.setattr(collision_detection.rospy, "on_shutdown", hooks.append)
    detection = CollisionDetection(Parameters(topics=(TOPIC,)))
    return detection, hooks, callbacks[0]


def test_contacts_are_published(node):
    detection, _, hear = node
    hear(ContactsState(), TOPIC)
    assert detection._collision.published == 1


def test_contacts_that_come_while_it_ends_are_left_out(node):
    _, hooks, hear = node
    for hook in hooks:
        hook()
    ClosingTopic.is_closed = True
    hear(ContactsState(), TOPIC)
