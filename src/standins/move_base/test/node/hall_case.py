"""What the tests of the node in lockstep share: a car in a hall, and a client of its action."""

import math
import threading
import unittest
from xmlrpc.client import ServerProxy

import actionlib
import pytest
import rospy
from fake_robot import FakeRobot, Room
from geometry_msgs.msg import PoseStamped, Quaternion
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import Path
from std_srvs.srv import Empty
from tf.transformations import quaternion_from_euler

PATIENCE = rospy.Duration(120.0)  # simulated
WALL_PATIENCE = 60.0  # s


def make_room():
    """A hall with a divider, a closet behind a gap of 0.8 m, and a cell without a door."""
    room = Room(12.0, 6.0)
    room.add_wall(4.0, 0.0, 4.2, 3.5)
    room.add_wall(9.0, 0.0, 9.2, 0.6)
    room.add_wall(9.0, 1.4, 9.2, 2.0)
    room.add_wall(9.0, 2.0, 12.0, 2.2)
    room.add_wall(9.0, 4.0, 12.0, 4.2)
    room.add_wall(9.0, 4.0, 9.2, 6.0)
    return room


def pose_at(x, y, yaw=0.0, frame="map"):
    """A pose message."""
    pose = PoseStamped()
    pose.header.frame_id = frame
    pose.pose.position.x = x
    pose.pose.position.y = y
    pose.pose.orientation = Quaternion(*quaternion_from_euler(0.0, 0.0, yaw))
    return pose


class Listener:
    """Collects the messages of a topic."""

    def __init__(self, topic, message_type):
        self.messages = []
        self._arrived = threading.Condition()
        self._subscriber = rospy.Subscriber(topic, message_type, self._note)

    def _note(self, message):
        with self._arrived:
            self.messages.append(message)
            self._arrived.notify_all()

    def close(self):
        self._subscriber.unregister()

    def connected(self):
        """Whether all that publish know of this listener: they note it after they have answered it."""
        connections = self._subscriber.impl.connections
        return bool(connections) and all(self._is_known_to(each.endpoint_id) for each in connections)

    def _is_known_to(self, publisher_uri):
        _, _, links = ServerProxy(publisher_uri).getBusInfo(rospy.get_name())
        return any(
            destination == rospy.get_name() and direction == "o" and topic == self._subscriber.resolved_name
            for _, destination, direction, _, topic, *_ in links
        )

    def wait(self, condition=lambda messages: messages):
        """Until the condition holds for the messages; fails after a while."""
        with self._arrived:
            assert self._arrived.wait_for(lambda: condition(self.messages), WALL_PATIENCE), "nothing arrived"
            return list(self.messages)


class HallCase(unittest.TestCase):
    """A car that stands in the hall before each test."""

    @classmethod
    def setUpClass(cls):
        cls.room = make_room()
        cls.robot = FakeRobot(cls.room, "move_base")
        rospy.wait_for_service("move_base/clear_costmaps")
        cls.topics_before = dict(rospy.get_published_topics())
        cls.robot.start()
        cls.client = actionlib.SimpleActionClient("move_base", MoveBaseAction)
        assert cls.client.wait_for_server(PATIENCE)
        cls.goals_ahead = rospy.Publisher("move_base/goals_ahead", Path, queue_size=None, tcp_nodelay=True)
        while cls.goals_ahead.get_num_connections() == 0:
            rospy.sleep(0.05)

    @classmethod
    def tearDownClass(cls):
        cls.robot.stop()

    def setUp(self):
        self.robot.real_room = self.room
        self.robot.put(1.0, 1.0)
        rospy.ServiceProxy("move_base/clear_costmaps", Empty)()

    def send(self, pose):
        self.client.send_goal(MoveBaseGoal(pose))

    def result(self):
        assert self.client.wait_for_result(PATIENCE)
        return self.client.get_state(), self.client.get_goal_status_text()

    def assert_result(self, state, text):
        result = self.result()
        assert result == (state, text), result

    def wait_until(self, condition):
        """Let simulated time run until the condition holds."""
        end = self.robot.now + PATIENCE.to_sec()
        while not condition():
            assert self.robot.now < end
            rospy.sleep(0.05)

    def listen(self, topic, message_type):
        """Listen, connected, until the test ends."""
        listener = Listener(topic, message_type)
        self.addCleanup(listener.close)
        self.wait_until(listener.connected)
        return listener

    def drive_off(self, pose):
        self.send(pose)
        self.wait_until(lambda: self.robot.speed > 0.5)

    def assert_stopped(self):
        self.wait_until(lambda: self.robot.commands and self.robot.commands[-1][1].linear.x == 0.0)
        assert self.robot.commands[-1][1].angular.z == 0.0

    def assert_stands_at(self, x, y, yaw=0.0):
        assert abs(self.robot.speed) < 0.06
        assert math.hypot(self.robot.pose[0] - x, self.robot.pose[1] - y) < 0.2
        assert self.robot.pose[2] == pytest.approx(yaw, abs=0.2)
        assert not self.robot.touched
