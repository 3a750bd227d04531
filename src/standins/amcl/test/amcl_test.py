#!/usr/bin/env python3
"""The node's interface, in lockstep, and what it says to wrong parameters."""

import math
import os
import pathlib
import subprocess
import threading
import unittest

import pytest
import roslib.packages
import rospkg
import rospy
import rostest
from geometry_msgs.msg import PoseArray, PoseWithCovarianceStamped
from nav_msgs.msg import OccupancyGrid
from nav_msgs.srv import GetMap, GetMapResponse, SetMap, SetMapRequest
from played_car import PERIOD, START, drive, mounting, room, scan, stamp_of, transform
from played_simulator import PATIENCE, Simulator
from roslaunch.config import load_config_default
from sensor_msgs.msg import LaserScan
from std_srvs.srv import Empty

PERIODS = 60


def latest(topic, kind):
    """The latched message of a topic."""
    return rospy.wait_for_message(topic, kind, PATIENCE)


class Kept:
    """The messages of a topic so far."""

    def __init__(self, topic, kind):
        self._arrived = threading.Condition()
        self._messages = []
        self._subscriber = rospy.Subscriber(topic, kind, self._keep)

    def _keep(self, message):
        with self._arrived:
            self._messages.append(message)
            self._arrived.notify_all()

    def is_connected(self):
        return self._subscriber.get_num_connections() > 0

    def wait_for(self, stamp):
        """The message of a stamp."""
        with self._arrived:
            assert self._arrived.wait_for(lambda: self.of(stamp), PATIENCE)
            return self.of(stamp)[0]

    def last(self):
        return self._messages[-1]

    def of(self, stamp):
        return [message for message in self._messages if message.header.stamp == stamp]


class AmclTest(unittest.TestCase):
    """One drive for all tests; the last period counts on."""

    @classmethod
    def setUpClass(cls):
        """Drive through the room."""
        rospy.Service("static_map", GetMap, lambda _request: GetMapResponse(room()))
        cls.simulator = Simulator(mounting())
        cls.poses = Kept("amcl_pose", PoseWithCovarianceStamped)
        cls.pose_publisher = rospy.Publisher(
            "initialpose", PoseWithCovarianceStamped, queue_size=None, tcp_nodelay=True
        )
        cls.simulator.wait_for_listeners()
        while not cls.pose_publisher.get_num_connections():
            threading.Event().wait(0.01)
        cls.simulator.run(drive(PERIODS))
        cls.period = PERIODS
        cls.clouds = Kept("particlecloud", PoseArray)
        while not cls.clouds.is_connected():
            threading.Event().wait(0.01)
        cls.transforms = cls.simulator.transforms_until(stamp_of(PERIODS - 1) + rospy.Duration(0.1))

    def call(self, name, kind, *arguments):
        rospy.wait_for_service(name, PATIENCE)
        proxy = rospy.ServiceProxy(name, kind)
        return self.simulator.call(lambda: proxy(*arguments), self.stamps())

    def stamps(self):
        """Yield the stamps of further periods."""
        while True:
            type(self).period += 1
            yield stamp_of(self.period - 1)

    def stand(self, x, odometry=1.1 * (PERIODS - 1) * PERIOD, **fields):
        """Another period with a scan from (x, 0), while odometry stands still. Returns its stamp."""
        stamp = stamp_of(self.period)
        message = scan(x, stamp)
        for name, value in fields.items():
            setattr(message, name, value)
        moved = transform("odom", "base_footprint", odometry, stamp)
        self.simulator.run([(stamp, [("/tf", moved), ("/scan", message)])])
        type(self).period += 1
        return stamp

    def tell(self, x, frame="map", correlation=0.0):
        message = PoseWithCovarianceStamped()
        message.header.frame_id = frame
        message.pose.pose.position.x = x
        message.pose.pose.orientation.w = 1.0
        message.pose.covariance[0] = message.pose.covariance[7] = message.pose.covariance[35] = 0.01
        message.pose.covariance[1] = message.pose.covariance[6] = correlation
        self.pose_publisher.publish(message)

    def test_1_pose_is_latched_and_right(self):
        pose = latest("amcl_pose", PoseWithCovarianceStamped)
        assert pose.header.frame_id == "map"
        driven = pose.header.stamp.to_sec() - START
        assert driven > 1.3
        assert pose.pose.pose.position.x == pytest.approx(driven, abs=0.07)  # odometry says 0.14 m more
        assert pose.pose.pose.position.y == pytest.approx(0.0, abs=0.04)
        assert abs(pose.pose.pose.orientation.z) < 0.02
        assert 0.0 < pose.pose.covariance[0] < 0.01

    def test_2_particles_are_there_for_who_comes_late_and_have_become_fewer(self):
        last = latest("particlecloud", PoseArray)
        assert last.header.frame_id == "map"
        assert stamp_of(0) < last.header.stamp < stamp_of(PERIODS)
        assert 100 <= len(last.poses) < 1000

    def test_3_transform_is_there_from_the_start_post_dated_and_corrects_odometry(self):
        first, *others = self.transforms
        assert first.header.stamp.to_sec() <= START + 0.1 + 1e-6
        assert {t.child_frame_id for t in self.transforms} == {"odom"}
        last = latest("amcl_pose", PoseWithCovarianceStamped)
        odometry = 1.1 * (last.header.stamp.to_sec() - START)
        # But for the estimate's yaw, which is not quite 0.
        assert others[-1].transform.translation.x == pytest.approx(
            last.pose.pose.position.x - odometry, abs=1e-4
        )
        assert others[-1].transform.translation.x < -0.09

    def test_4_pose_is_kept_as_parameters(self):
        saved = rospy.get_param("/amcl/initial_pose_x")
        assert 0.0 < saved < PERIODS * PERIOD
        assert rospy.get_param("/amcl/initial_cov_aa") > 0.0

    def test_5_a_belief_that_there_cannot_be_is_ignored(self):
        before = (PERIODS - 1) * PERIOD
        self.tell(-1.0, correlation=1.0)
        self.tell(math.nan)
        self.call("request_nomotion_update", Empty)
        pose = self.poses.wait_for(self.stand(before))
        assert pose.pose.pose.position.x == pytest.approx(before, abs=0.05)

    def test_5_a_scan_that_makes_no_sense_is_left_out(self):
        before = (PERIODS - 1) * PERIOD
        self.call("request_nomotion_update", Empty)
        left_out = self.stand(before, angle_increment=math.nan)
        assert self.poses.wait_for(self.stand(before))
        assert not self.poses.of(left_out)

    def test_5_initial_pose_moves_the_estimate_unless_its_frame_is_wrong(self):
        before = (PERIODS - 1) * PERIOD
        self.tell(-1.0, frame="odom")
        self.call("request_nomotion_update", Empty)
        pose = self.poses.wait_for(self.stand(before))
        assert pose.pose.pose.position.x == pytest.approx(before, abs=0.05)
        self.tell(-1.0)
        pose = self.poses.wait_for(self.stand(-0.9))
        assert pose.pose.pose.position.x == pytest.approx(-0.9, abs=0.09)

    def test_6_global_localization_spreads_the_particles(self):
        self.tell(2.0)
        self.call("global_localization", Empty)
        cloud = self.clouds.wait_for(self.stand(-0.9))
        assert len(cloud.poses) <= 5000
        places = [pose.position.x for pose in cloud.poses]
        assert max(places) - min(places) > 2.0

    def test_7_map_can_be_set(self):
        request = SetMapRequest(map=room())
        request.map.info.origin.position.x += 10.0
        request.initial_pose.pose.pose.position.x = 9.1
        request.initial_pose.pose.pose.orientation.w = 1.0
        assert self.call("set_map", SetMap, request.map, request.initial_pose).success
        pose = self.poses.wait_for(self.stand(-0.9))
        assert pose.pose.pose.position.x == pytest.approx(9.1, abs=0.05)

    def test_8_a_map_that_makes_no_sense_is_refused_and_the_old_one_kept(self):
        nowhere = room()
        nowhere.info.origin.position.x = math.nan
        uncertain = PoseWithCovarianceStamped()
        uncertain.pose.covariance[0] = -1.0
        for grid, start in [
            (OccupancyGrid(), PoseWithCovarianceStamped()),
            (nowhere, PoseWithCovarianceStamped()),
            (room(), uncertain),
        ]:
            assert not self.call("set_map", SetMap, grid, start).success
        self.call("request_nomotion_update", Empty)
        pose = self.poses.wait_for(self.stand(-0.9))
        assert pose.pose.pose.position.x == pytest.approx(9.1, abs=0.05)

    def test_8_odometry_that_leaps_off_the_earth_is_left_out(self):
        self.stand(-0.9, odometry=1e300)
        told = self.poses.last().pose.pose.position.x
        assert math.isfinite(told)
        names = ["pose_x", "pose_y", "pose_a", "cov_xx", "cov_yy", "cov_aa"]
        assert all(math.isfinite(rospy.get_param(f"/amcl/initial_{name}")) for name in names)

    def test_9_wrong_parameters_are_answered_in_one_line(self):
        wrong = [
            ("laser_model_type", "sonar", 'found "sonar", must be one of beam, likelihood_field, '),
            ("odom_model_type", "car", 'found "car", must be one of diff, omni, diff-corrected, '),
            ("min_particles", -5, "found -5, must be a whole number >= 1"),
            ("max_particles", "many", 'found "many", must be a whole number'),
            ("update_min_d", math.nan, "found nan, must be a number >= 0"),
            ("kld_err", 0.0, "found 0, must be a number > 0"),
            ("kld_z", 10.0, "found 10, must be a number >= 0 and <= 8"),
            ("laser_max_beams", 1, "found 1, must be a whole number >= 2"),
            ("laser_max_range", math.nan, "found nan, must be a finite number"),
            ("transform_tolerance", 1e10, "found 10000000000, must be a number >= 0 and <= 1e+09"),
        ]
        nodes = [self.node_with(name, value, f"wrong{i}") for i, (name, value, _) in enumerate(wrong)]
        for i, ((name, _, answer), node) in enumerate(zip(wrong, nodes)):
            said = node.communicate(timeout=PATIENCE)[1]
            assert node.returncode == 1, said
            (line,) = [line for line in said.splitlines() if line.startswith("amcl: ")]
            assert line.startswith(f"amcl: parameter /wrong{i}/amcl/{name}: {answer}")

    def test_9_what_the_original_goes_on_with_is_a_warning(self):
        self.expect_words(
            (
                self.node_with("initial_cov_xx", math.nan, "tolerant1", "static_map:=/static_map"),
                "found nan, must be a number >= 0; 0.25 is used",
            ),
            (
                self.node_with("min_particles", 6000, "tolerant2", "static_map:=/static_map"),
                "max_particles is set to min_particles, which is 6000",
            ),
        )

    def test_9_node_says_what_it_waits_for(self):
        message = scan(0.0, rospy.Time(1))
        message.header.frame_id = "lidar"
        publisher = rospy.Publisher("/lonely3/scan", LaserScan, queue_size=1, latch=True)
        publisher.publish(message)
        self.expect_words(
            (self.node("lonely1"), "an answer from the service /lonely1/static_map"),
            (self.node("lonely2", "static_map:=/static_map"), "scans on /lonely2/scan"),
            (
                self.node("lonely3", "static_map:=/static_map"),
                "a transform from base_link to lidar, the frame of the scans",
            ),
            (self.node_with("use_map_topic", True, "lonely4"), "a map on /lonely4/map"),
        )

    def node_with(self, name, value, namespace, *arguments):
        """Start a node with a parameter in a namespace of its own."""
        rospy.set_param(f"/{namespace}/amcl/{name}", value)
        return self.node(namespace, *arguments)

    def node(self, namespace, *arguments):
        (program,) = roslib.packages.find_node("amcl", "amcl")
        environment = {**os.environ, "ROS_NAMESPACE": namespace}
        node = subprocess.Popen([program, *arguments], env=environment, stderr=subprocess.PIPE, text=True)
        self.addCleanup(node.kill)
        return node

    @staticmethod
    def expect_words(*expected):
        """Let nodes run side by side until each has said its words."""
        for node, words in expected:
            stop = threading.Timer(PATIENCE, node.kill)
            stop.start()
            said = any(words in line for line in node.stderr)
            stop.cancel()
            assert said, words
            assert node.poll() is None
            node.kill()
            node.communicate()

    def test_9_examples_are_those_of_the_original(self):
        examples = pathlib.Path(rospkg.RosPack().get_path("amcl"), "examples")
        for model in ("diff", "omni"):
            config = load_config_default(
                [(str(examples / f"amcl_{model}.launch"), [])], port=None, verbose=False
            )
            (node,) = config.nodes
            assert (node.package, node.type) == ("amcl", "amcl")
            assert config.params["/amcl/odom_model_type"].value == model


if __name__ == "__main__":
    rospy.init_node("amcl_test")
    rostest.rosrun("amcl", "amcl_test", AmclTest)
