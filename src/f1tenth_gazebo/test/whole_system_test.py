#!/usr/bin/env python3
"""The running system must be sound in the eyes of the tools with which users look at it."""

import math
import subprocess
import sys
import threading
import time
import xml.etree.ElementTree as ElementTree
from collections import defaultdict

import pytest
import rospy
import tf2_ros
from gazebo_msgs.msg import ContactsState
from geometry_msgs.msg import PoseStamped
from move_base_msgs.msg import MoveBaseActionResult
from nav_msgs.msg import Odometry
from sensor_msgs.msg import Imu, JointState, LaserScan
from tf2_msgs.msg import TFMessage

PATIENCE = 60.0  # wall s
CAR = "robot1"
STAMPED = {
    "scan": LaserScan,
    "odom": Odometry,
    "perfect_odom": Odometry,
    "imu": Imu,
    "joint_states": JointState,
    "bumper_front": ContactsState,
    "bumper_rear": ContactsState,
    "bumper_left": ContactsState,
    "bumper_right": ContactsState,
}
# Inputs that nobody uses while nobody drives.
OPEN_INPUTS = {
    f"/{CAR}/drive",
    f"/{CAR}/move_base/cancel",
    f"/{CAR}/move_base/goals_ahead",
    f"/{CAR}/move_base_simple/goal",
    "/gazebo/set_model_state",
}


class Collector:
    """Notes something about every message of a topic."""

    def __init__(self, topic, message_type, note):
        self._notes = []
        self._note = note
        self._arrived = threading.Condition()
        self._subscriber = rospy.Subscriber(topic, message_type, self._on_message)

    def _on_message(self, message):
        with self._arrived:
            self._notes.append(self._note(message))
            self._arrived.notify_all()

    def wait(self, count):
        """Return the notes when there are at least so many."""
        with self._arrived:
            assert self._arrived.wait_for(lambda: len(self._notes) >= count, PATIENCE), len(self._notes)
            return list(self._notes)


def links():
    """Names of the links of the car's description."""
    description = ElementTree.fromstring(rospy.get_param(f"/{CAR}/robot_description"))
    return [link.get("name") for link in description.findall("link")]


@pytest.fixture(scope="module")
def buffer():
    buffer = tf2_ros.Buffer()
    listener = tf2_ros.TransformListener(buffer)
    yield buffer
    listener.unregister()


@pytest.fixture(scope="module", autouse=True)
def running(buffer):
    """The system, once everything in it has started."""
    end = time.monotonic() + PATIENCE
    while not buffer.can_transform("map", f"{CAR}/front_left_wheel", rospy.Time(0)):
        assert time.monotonic() < end, "there is no transform from map to a wheel"
        time.sleep(0.05)


def test_there_is_a_transform_from_the_map_to_every_link(buffer):
    missing = [link for link in links() if not buffer.can_transform("map", f"{CAR}/{link}", rospy.Time(0))]
    assert links()
    assert not missing


def test_every_transform_has_one_publisher():
    publishers = defaultdict(set)

    def note(message):
        for transform in message.transforms:
            publishers[transform.child_frame_id].add(message._connection_header["callerid"])

    moving = Collector("/tf", TFMessage, note)
    Collector("/tf_static", TFMessage, note).wait(2)
    moving.wait(100)
    assert {f"{CAR}/{link}" for link in links()} <= set(publishers)
    assert {child: nodes for child, nodes in publishers.items() if len(nodes) > 1} == {}


@pytest.mark.parametrize("topic", STAMPED)
def test_stamps_are_simulated_time_and_increase(topic):
    now = rospy.get_time()
    stamps = Collector(f"/{CAR}/{topic}", STAMPED[topic], lambda message: message.header.stamp).wait(20)
    assert all(earlier < later for earlier, later in zip(stamps, stamps[1:]))
    assert now - 1.0 < stamps[0].to_sec() < stamps[-1].to_sec() <= rospy.get_time() + 1.0


def test_roswtf_finds_nothing_but_inputs_that_nobody_uses():
    report = subprocess.run(["roswtf"], capture_output=True, text=True, timeout=PATIENCE, check=False).stdout
    online = report[report.index("Online checks summary") :]
    assert "ERROR" not in online
    assert online.count("WARNING") == 1, online
    listed = {line.strip(" *\n") for line in online.splitlines() if line.startswith("   * ")}
    assert listed <= OPEN_INPUTS, online


def test_view_frames_draws_one_tree(tmp_path):
    command = ["rosrun", "tf2_tools", "view_frames.py"]
    subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=PATIENCE, check=True)
    assert (tmp_path / "frames.pdf").stat().st_size > 0
    edges = [
        line.split('"') for line in (tmp_path / "frames.gv").read_text().splitlines() if "Broadcaster" in line
    ]
    parents = {child: parent for _, parent, _, child, *_ in edges}
    assert {f"{CAR}/{link}" for link in links()} <= set(parents)
    assert {parent for parent in parents.values() if parent not in parents} == {"map"}


def test_a_goal_clicked_in_rviz_ends_at_a_standstill_there():
    goal = PoseStamped()
    goal.header.frame_id = "map"
    goal.pose.position.x, goal.pose.position.y = 2.0, 5.1
    goal.pose.orientation.z = 1.0  # against x
    results = Collector(f"/{CAR}/move_base/result", MoveBaseActionResult, lambda message: message.status)
    clicks = rospy.Publisher(f"/{CAR}/move_base_simple/goal", PoseStamped, queue_size=1, latch=True)
    clicks.publish(goal)
    assert results.wait(1)[0].text == "Goal reached."
    for pose, twist in Collector(f"/{CAR}/perfect_odom", Odometry, motion_of).wait(20):
        assert math.hypot(pose.position.x - 2.0, pose.position.y - 5.1) < 0.2
        assert abs(pose.orientation.w) < math.sin(0.1)  # half of the angle
        assert math.hypot(twist.linear.x, twist.linear.y) < 0.1


def motion_of(odometry):
    return odometry.pose.pose, odometry.twist.twist


if __name__ == "__main__":
    rospy.init_node("whole_system_test")
    junit = [a.replace("--gtest_output=xml:", "--junitxml=") for a in sys.argv if "_output=xml:" in a]
    sys.exit(pytest.main([__file__, "-p", "no:cacheprovider", *junit]))
