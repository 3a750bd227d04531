#!/usr/bin/env python3
"""A triggered camera looks when it is asked, not at a rate."""

import unittest

import rospy
import rostest
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Image
from sim2d_process import Collector, Sim2d, car_description, wait_for_subscriber
from std_msgs.msg import Empty

CAMERA = """
<gazebo reference="chassis">
  <sensor name="pair" type="multicamera">
    <update_rate>20</update_rate>
    <camera name="left"><image><width>32</width><height>24</height></image></camera>
    <camera name="right"><image><width>32</width><height>24</height></image></camera>
    <plugin name="pair_plugin" filename="libgazebo_ros_triggered_multicamera.so">
      <cameraName>pair</cameraName>
      <frameName>chassis</frameName>
      <triggerTopicName>shoot</triggerTopicName>
    </plugin>
  </sensor>
</gazebo>
"""


class TriggeredCameraTest(unittest.TestCase):
    def test_each_message_gives_one_picture_of_each_eye(self):
        sim2d = Sim2d(car_description(CAMERA))
        self.addCleanup(sim2d.kill)
        eyes = {"robot1__pair__left__image_raw": Image, "robot1__pair__right__image_raw": Image}
        collector = Collector(**eyes)
        clock = Collector(clock=Clock)
        for each in (collector, clock):
            self.addCleanup(each.close)
            each.wait_until_connected()
        trigger = rospy.Publisher("/robot1/pair/left/shoot", Empty, queue_size=1)
        wait_for_subscriber(trigger)
        for count in (1, 2, 3):
            trigger.publish()
            assert collector.wait_for(lambda seen, n=count: {len(each) for each in seen.values()} == {n})
        left, right = ([each.header.stamp for each in heard] for heard in collector.messages.values())
        assert left == right
        assert left == sorted(set(left))
        # Time has gone on for many of its periods, without more pictures.
        later = left[-1] + rospy.Duration(1)
        assert clock.wait_for(lambda seen: seen["/clock"] and seen["/clock"][-1].clock > later)
        assert {len(each) for each in collector.messages.values()} == {3}


if __name__ == "__main__":
    rospy.init_node("triggered_camera_test")
    rostest.rosrun("f1tenth_sim2d", "triggered_camera", TriggeredCameraTest)
