"""Which transform from the map counts at a scan must not depend on when messages arrive."""

import pytest
import rospy
from f1tenth_gazebo.driving import lap_inputs
from f1tenth_gazebo.driving.lap_inputs import LapInputs
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from tf2_msgs.msg import TFMessage


@pytest.fixture
def inputs(monkeypatch):
    """Inputs whose callbacks the test calls: {topic: callback} beside them."""
    callbacks = {}

    def subscriber(topic, kind, callback, **options):
        callbacks[topic] = callback

    monkeypatch.setattr(lap_inputs.rospy, "Subscriber", subscriber)
    monkeypatch.setattr(lap_inputs, "PATIENCE", 0.0)
    return LapInputs(), callbacks


def odometry(seconds, x):
    message = Odometry()
    message.header.stamp = rospy.Time.from_sec(seconds)
    message.header.frame_id = "robot1/odom"
    message.pose.pose.position.x = x
    message.pose.pose.orientation.w = 1.0
    return message


def correction(seconds, x, child="robot1/odom"):
    transform = TransformStamped()
    transform.header.stamp = rospy.Time.from_sec(seconds)
    transform.header.frame_id, transform.child_frame_id = "map", child
    transform.transform.translation.x = x
    transform.transform.rotation.w = 1.0
    return TFMessage([transform])


@pytest.mark.parametrize("seconds", [0.0, 0.05, 0.1])
def test_transform_of_the_first_moments_does_not_count_yet(inputs, seconds):
    known, callbacks = inputs
    callbacks["odom"](odometry(0.0, 1.0))
    callbacks["/tf"](correction(0.05, 10.0))
    assert known.at(rospy.Time.from_sec(seconds)) == ((1.0, 0.0, 0.0), 0.0)


def test_transform_counts_when_it_is_old_enough(inputs):
    known, callbacks = inputs
    callbacks["odom"](odometry(0.15, 1.0))
    callbacks["/tf"](correction(0.05, 10.0))
    callbacks["/tf"](correction(0.1, 20.0))
    assert known.at(rospy.Time.from_sec(0.15)) == ((11.0, 0.0, 0.0), 0.0)


def test_transform_of_another_car_does_not_count(inputs):
    known, callbacks = inputs
    callbacks["odom"](odometry(0.15, 1.0))
    callbacks["/tf"](correction(0.05, 10.0, "robot2/odom"))
    callbacks["/tf"](correction(0.1, 20.0, "robot2/odom"))
    assert known.at(rospy.Time.from_sec(0.15)) == ((1.0, 0.0, 0.0), 0.0)


def test_without_odometry_nothing_is_known(inputs):
    known, _ = inputs
    assert known.at(rospy.Time.from_sec(1.0)) is None
