#!/usr/bin/env python3
"""What the node publishes: rates, stamps, content."""

import math
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from gazebo_msgs.msg import ContactsState, ModelStates
from nav_msgs.msg import Odometry
from sensor_msgs.msg import Imu, JointState, LaserScan, Range
from sim2d_process import Collector, Driver, Sim2d, Stepper, car_description
from tf2_msgs.msg import TFMessage

SECOND = 1_000_000_000
PERIOD = 25_000_000
BUMPERS = tuple(f"bumper_{side}" for side in ("front", "rear", "left", "right"))
RATES = {"scan": 40, "odom": 50, "imu": 100, "joint_states": 50, "sonar": 40, **dict.fromkeys(BUMPERS, 50)}
TYPES = {
    "scan": LaserScan,
    "odom": Odometry,
    "imu": Imu,
    "joint_states": JointState,
    "sonar": Range,
    **dict.fromkeys(BUMPERS, ContactsState),
}
# 0.2 m above the ground, 0.3 m ahead of base_footprint, to the left.
SONAR = """<link name="sonar"/>
<joint name="sonar_joint" type="fixed">
<parent link="base_footprint"/><child link="sonar"/><origin xyz="0.3 0 0.2" rpy="0 0 1.5707963"/></joint>
<gazebo reference="sonar"><sensor name="sonar" type="ray"><update_rate>80</update_rate><ray>
<scan><horizontal><samples>5</samples><min_angle>-0.25</min_angle><max_angle>0.25</max_angle></horizontal></scan>
<range><min>0.05</min><max>3.0</max></range></ray>
<plugin name="sonar" filename="libgazebo_ros_range.so"><topicName>sonar</topicName>
<frameName>sonar</frameName>
<updateRate>40</updateRate><fov>0.5</fov><radiation>ultrasound</radiation><gaussianNoise>0.001</gaussianNoise>
</plugin></sensor></gazebo>"""


def expected_stamps(first, rate):
    """Return all of a second; who connects during the first period gets its last message, again and again."""
    assert first <= PERIOD
    return [n * SECOND // rate for n in range(rate + 1) if n * SECOND // rate >= first]


class OutputsTest(unittest.TestCase):
    def start(self, odometry="perfect", participants=("test",), description=None, **topics):
        """Hold the simulation in its first period until every subscriber is served."""
        self.stepper = Stepper()
        self.addCleanup(self.stepper.close)
        self.collector = Collector(**{f"robot1__{topic}": kind for topic, kind in TYPES.items()}, **topics)
        self.addCleanup(self.collector.close)
        self.driver = Driver("robot1", self.stepper)
        self.addCleanup(self.driver.close)
        self.sim2d = Sim2d(
            description or car_description(SONAR),
            lockstep=True,
            participants=list(participants),
            odometry=odometry,
        )
        self.addCleanup(self.sim2d.kill)
        self.collector.wait_until_connected()
        self.wait_for_all_until(PERIOD)

    def advance_to(self, end):
        self.stepper.advance_to(end)
        self.wait_for_all_until(end)

    def wait_for_all_until(self, end):
        last = {"/robot1/" + topic: end * rate // SECOND * SECOND // rate for topic, rate in RATES.items()}
        assert self.collector.wait_for(
            lambda messages: all(
                messages[topic] and messages[topic][-1].header.stamp.to_nsec() >= stamp
                for topic, stamp in last.items()
            )
        )

    def messages(self, topic):
        return self.collector.messages["/robot1/" + topic]

    def test_every_topic_has_its_rate_with_stamps_at_exact_multiples(self):
        self.start()
        self.advance_to(SECOND)
        for topic, rate in RATES.items():
            stamps = [message.header.stamp.to_nsec() for message in self.messages(topic)]
            assert stamps == sorted(stamps), topic
            assert list(dict.fromkeys(stamps)) == expected_stamps(stamps[0], rate), topic

    def test_scan_is_that_of_the_description(self):
        self.start()
        scan = self.messages("scan")[0]
        assert len(scan.ranges) == 1081
        assert scan.header.frame_id == "robot1/laser"
        assert math.isclose(scan.angle_min, -math.radians(135), rel_tol=1e-6)
        assert math.isclose(scan.angle_max - scan.angle_min, 1080 * scan.angle_increment, rel_tol=1e-5)
        assert math.isclose(scan.scan_time, 0.025, rel_tol=1e-6)
        assert math.isclose(scan.range_max, 10.0)
        # The laser is 0.26 m ahead of base_footprint, the eastern wall at 4 m.
        assert abs(scan.ranges[540] - 3.74) < 0.06

    def test_sonar_measures_how_far_the_nearest_thing_is(self):
        self.start()
        self.advance_to(SECOND)
        messages = self.messages("sonar")
        sonar = messages[-1]
        assert sonar.header.frame_id == "robot1/sonar"
        assert sonar.radiation_type == Range.ULTRASOUND
        measured = (sonar.field_of_view, sonar.min_range, sonar.max_range)
        assert [round(value, 6) for value in measured] == [0.5, 0.05, 3.0]
        # The northern wall is at 2 m.
        assert all(abs(message.range - 2.0) < 0.005 for message in messages)
        assert len({message.range for message in messages}) > 10

    def test_bumpers_say_nothing_while_nothing_touches(self):
        self.start()
        self.advance_to(SECOND // 10)
        for bumper in BUMPERS:
            assert all(message.states == [] for message in self.messages(bumper))

    def test_car_that_drives_turns_its_wheels_and_feels_gravity(self):
        self.start(participants=("robot1", "test"))
        self.driver.drive_to(SECOND // 2, linear_x=1.0, angular_z=0.5)
        self.wait_for_all_until(SECOND // 2)
        joints = self.messages("joint_states")[-1]
        positions = dict(zip(joints.name, joints.position))
        velocities = dict(zip(joints.name, joints.velocity))
        assert len(positions) == 6
        assert positions["front_left_steering_joint"] > positions["front_right_steering_joint"] > 0.0
        assert velocities["rear_right_wheel_joint"] > velocities["rear_left_wheel_joint"] > 1.0
        odom = self.messages("odom")[-1]
        assert (odom.header.frame_id, odom.child_frame_id) == ("robot1/odom", "robot1/base_footprint")
        assert odom.pose.pose.position.x > 0.1
        assert odom.twist.covariance[0] > 0.0
        imu = self.messages("imu")[-1]
        assert imu.header.frame_id == "robot1/imu"
        assert math.isclose(imu.linear_acceleration.z, 9.8)
        assert imu.angular_velocity.z > 0.1

    def test_imu_measures_along_its_own_axes(self):
        turned = '<child link="imu"/><origin rpy="0 0 1.5707963267948966"/>'
        self.start(
            participants=("robot1", "test"),
            description=car_description(SONAR).replace('<child link="imu"/>', turned),
        )
        self.driver.drive_to(SECOND // 4, linear_x=4.0)
        self.wait_for_all_until(SECOND // 4)
        imu = self.messages("imu")[-1]
        assert abs(2.0 * math.atan2(imu.orientation.z, imu.orientation.w) - math.pi / 2) < 0.05
        assert imu.linear_acceleration.y < -5.0
        assert abs(imu.linear_acceleration.x) < 1.0
        assert math.isclose(imu.linear_acceleration.z, 9.8)

    def test_wheel_odometry_owns_the_transform_only_if_told(self):
        for odometry, expected in (("wheel", {("robot1/odom", "robot1/base_footprint")}), ("perfect", set())):
            with self.subTest(odometry=odometry):
                self.start(odometry=odometry, tf=TFMessage)
                self.advance_to(SECOND // 5)
                transforms = [t for message in self.collector.messages["/tf"] for t in message.transforms]
                assert {(t.header.frame_id, t.child_frame_id) for t in transforms} == expected
                self.doCleanups()

    def test_refused_commands_are_counted_and_never_reach_the_car(self):
        self.start(participants=("robot1", "test"), diagnostics=DiagnosticArray)
        absurd = (math.nan, math.inf, -math.inf, 1e6)
        for quarter, value in enumerate(absurd, 1):
            self.driver.drive_to(quarter * SECOND // 4, linear_x=value)
        self.wait_for_all_until(SECOND)
        assert self.collector.wait_for(lambda messages: messages["/diagnostics"])
        status = {s.name: s for s in self.collector.messages["/diagnostics"][-1].status}
        commands = status["sim2d: commands of robot1"]
        assert commands.level == 1
        assert commands.message.startswith("refused: ")
        assert {entry.key: entry.value for entry in commands.values} == {"accepted": "0", "refused": "39"}
        assert abs(self.messages("odom")[-1].twist.twist.linear.x) < 0.2
        values = {entry.key: entry.value for entry in status["sim2d: time"].values}
        assert values["mode"] == "lockstep"
        assert float(values["real_time_factor"]) > 0.0

    def test_model_states_name_world_and_cars(self):
        self.start(gazebo__model_states=ModelStates)
        self.advance_to(SECOND // 10)
        assert self.collector.wait_for(lambda messages: messages["/gazebo/model_states"])
        states = self.collector.messages["/gazebo/model_states"][-1]
        assert states.name == ["walls", "crate", "robot1"]
        assert states.pose[1].position.x == -3.0


if __name__ == "__main__":
    rospy.init_node("outputs_test")
    rostest.rosrun("f1tenth_sim2d", "sim2d_outputs", OutputsTest)
