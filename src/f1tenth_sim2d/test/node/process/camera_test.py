#!/usr/bin/env python3
"""The node publishes what cameras see, while somebody subscribes."""

import unittest

import numpy as np
import rospy
import rostest
from sensor_msgs import point_cloud2
from sensor_msgs.msg import CameraInfo, CompressedImage, Image, PointCloud2
from sim2d_process import LONG, Sim2d, car_description

CAMERA = """
<gazebo reference="chassis">
  <sensor name="eyes" type="depth">
    <update_rate>20</update_rate>
    <camera>
      <pose>0.5 0 0.1 0 0 0</pose>
      <horizontal_fov>1.2</horizontal_fov>
      <image><width>64</width><height>48</height><format>R8G8B8</format></image>
      <clip><near>0.05</near><far>20</far></clip>
    </camera>
    <plugin name="eyes_plugin" filename="libgazebo_ros_openni_kinect.so">
      <cameraName>eyes</cameraName>
      <frameName>eyes_optical_frame</frameName>
      <pointCloudCutoffMax>20</pointCloudCutoffMax>
      <Cx>31.0</Cx>
      <distortionK1>-0.1</distortionK1>
      <distortionK2>0.02</distortionK2>
      <distortionT1>0.001</distortionT1>
      <distortionT2>0.002</distortionT2>
      <distortionK3>0.003</distortionK3>
    </plugin>
  </sensor>
</gazebo>
"""
TOPICS = {
    "image_raw": Image,
    "image_raw/compressed": CompressedImage,
    "camera_info": CameraInfo,
    "depth/image_raw": Image,
    "depth/camera_info": CameraInfo,
    "points": PointCloud2,
}


class CameraTest(unittest.TestCase):
    def setUp(self):
        sim2d = Sim2d(car_description(CAMERA))
        self.addCleanup(sim2d.kill)
        self.seen = {}
        for topic, kind in TOPICS.items():
            subscriber = rospy.Subscriber(
                f"/robot1/eyes/{topic}", kind, lambda message, topic=topic: self.note(topic, message)
            )
            self.addCleanup(subscriber.unregister)
        for topic, kind in TOPICS.items():
            rospy.wait_for_message(f"/robot1/eyes/{topic}", kind, LONG)

    def note(self, topic, message):
        self.seen.setdefault(message.header.stamp.to_nsec(), {})[topic] = message

    def one(self):
        """All messages of one time."""
        whole = [messages for messages in self.seen.values() if len(messages) == len(TOPICS)]
        assert whole, "one time at which all topics have a message"
        return whole[0]

    def test_all_topics_of_one_picture_agree(self):
        seen = self.one()
        image, info, depth = seen["image_raw"], seen["camera_info"], seen["depth/image_raw"]
        assert (image.width, image.height, image.encoding, image.step) == (64, 48, "rgb8", 192)
        assert {message.header.frame_id for message in seen.values()} == {"robot1/eyes_optical_frame"}
        assert (info.width, info.height, info.K[2], info.K[5]) == (64, 48, 31.0, 23.5)
        assert info.D == (-0.1, 0.02, 0.001, 0.002, 0.003)
        assert abs(info.K[0] - 32 / np.tan(0.6)) < 1e-6
        depths = np.frombuffer(depth.data, np.float32).reshape(48, 64)
        assert seen["image_raw/compressed"].data[:2] == b"\xff\xd8"
        points = np.array(list(point_cloud2.read_points(seen["points"], ("x", "y", "z")))).reshape(48, 64, 3)
        there = np.isfinite(points[..., 2])
        np.testing.assert_array_equal(points[there, 2].astype(np.float32), depths[there])
        assert (seen["points"].width, seen["points"].height) == (64, 48)

    def test_pictures_come_at_their_rate(self):
        stamps = sorted(self.seen)
        assert all(stamp % 50000000 == 0 for stamp in stamps), stamps


if __name__ == "__main__":
    rospy.init_node("camera_test")
    rostest.rosrun("f1tenth_sim2d", "camera", CameraTest)
