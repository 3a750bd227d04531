#!/usr/bin/env python3
"""Visual odometry by the stereo camera of the car: a small one, on OpenCV (python3-opencv).

A node that hears `image_raw` and `camera_info` of `camera/left` and `camera/right`, and publishes on
`visual_odom` where the car has come to since the first pair of pictures.
"""

import threading

import cv2
import numpy as np
import rospy
import tf2_ros
from geometry_msgs.msg import Point, Quaternion
from nav_msgs.msg import Odometry
from sensor_msgs.msg import CameraInfo, Image
from tf.transformations import quaternion_matrix

NEAREST, FARTHEST = 0.4, 8.0  # m, of points that are used: the car sees itself, too
FEATURES = 800
LEAST = 12  # points that tell a motion: with fewer, the last one is taken to go on


class StereoOdometry:
    """Adds up how the camera has moved from one pair of pictures to the next."""

    def __init__(self, focal, middle, baseline):
        """Focal length and middle in pixels, distance of the eyes in m."""
        self._focal, self._middle, self._baseline = focal, middle, baseline
        self._matrix = np.array([[focal, 0, middle[0]], [0, focal, middle[1]], [0, 0, 1]], float)
        self._last = None
        self._turn, self._shift = np.zeros((3, 1)), np.zeros((3, 1))  # from the last pair but one to the last
        self.pose = np.eye(4)  # of the left eye where it began: z ahead, x to the right

    def take(self, left, right):
        """A pair of pictures, red, green and blue."""
        left, right = (cv2.cvtColor(each, cv2.COLOR_RGB2GRAY) for each in (left, right))
        if self._last is not None:
            pixels, points = self._last
            seen, is_seen = tracked(self._left, left, pixels)
            if is_seen.sum() >= LEAST:
                self._measure(points[is_seen], seen[is_seen])
            change = np.eye(4)
            change[:3, :3], change[:3, 3] = cv2.Rodrigues(self._turn)[0], self._shift.ravel()
            self.pose = self.pose @ np.linalg.inv(change)
        self._left, self._last = left, self._points(left, right)

    def _measure(self, points, pixels):
        """How the camera has moved, by where it sees points of the space before."""
        is_found, _, _, inliers = cv2.solvePnPRansac(
            points, pixels, self._matrix, None, reprojectionError=0.7, iterationsCount=200
        )
        if is_found and len(inliers) >= LEAST:
            # From the last motion: points on one wall have a second solution, far from it.
            agreeing = inliers.ravel()
            self._turn, self._shift = cv2.solvePnPRefineLM(
                points[agreeing], pixels[agreeing], self._matrix, None, self._turn, self._shift
            )

    def _points(self, left, right):
        """Pixels of the left picture, and where in space they are."""
        pixels = cv2.goodFeaturesToTrack(left, FEATURES, 0.001, 6).reshape(-1, 2)
        there, is_there = tracked(left, right, pixels)
        with np.errstate(divide="ignore"):
            depth = self._focal * self._baseline / (pixels - there)[:, 0]
        is_there &= (np.abs(pixels - there)[:, 1] < 0.5) & (depth > NEAREST) & (depth < FARTHEST)
        pixels, depth = pixels[is_there], depth[is_there, None]
        return pixels, np.hstack([(pixels - self._middle) * depth / self._focal, depth])


def tracked(before, after, pixels):
    """Where pixels of a picture are in another, and whether the way back leads to them."""
    options = {"winSize": (15, 15), "criteria": (3, 30, 0.003)}
    there, is_found, _ = cv2.calcOpticalFlowPyrLK(before, after, pixels, None, **options)
    back, is_back, _ = cv2.calcOpticalFlowPyrLK(after, before, there, None, **options)
    is_same = np.hypot(*(back - pixels).T) < 0.2
    return there, is_found.ravel().astype(bool) & is_back.ravel().astype(bool) & is_same


class Node:
    """From the topics of the camera to `visual_odom`."""

    def __init__(self):
        self._base = rospy.get_param("~base_frame", "base_footprint")
        self._transforms = tf2_ros.Buffer()
        self._listener = tf2_ros.TransformListener(self._transforms)
        self._odometry = None
        self._base_from_eye = None
        self._heard, self._lock = {}, threading.Lock()
        self._publisher = rospy.Publisher("visual_odom", Odometry, queue_size=10)
        for eye in ("left", "right"):
            rospy.Subscriber(f"camera/{eye}/camera_info", CameraInfo, self._hear, f"{eye} info")
            rospy.Subscriber(f"camera/{eye}/image_raw", Image, self._hear, eye, buff_size=1 << 24)

    def _hear(self, message, name):
        with self._lock:
            self._heard[name] = message
            eyes = [self._heard.get(eye) for eye in ("left", "right")]
            if len(self._heard) == 4 and eyes[0].header.stamp == eyes[1].header.stamp:
                del self._heard["left"], self._heard["right"]
                self._take(*eyes)

    def _take(self, left, right):
        if self._odometry is None and not self._begin(left.header.frame_id):
            return
        self._odometry.take(*(pixels_of(image) for image in (left, right)))
        pose = self._base_from_eye @ self._odometry.pose @ np.linalg.inv(self._base_from_eye)
        half = 0.5 * np.arctan2(pose[1, 0], pose[0, 0])
        message = Odometry(child_frame_id=self._base)
        message.header.stamp, message.header.frame_id = left.header.stamp, "visual_odom"
        message.pose.pose.position = Point(*pose[:3, 3])
        message.pose.pose.orientation = Quaternion(0.0, 0.0, np.sin(half), np.cos(half))
        self._publisher.publish(message)

    def _begin(self, frame):
        """Return whether the place of the eye is known by now."""
        if not self._transforms.can_transform(self._base, frame, rospy.Time()):
            return False
        at = self._transforms.lookup_transform(self._base, frame, rospy.Time()).transform
        self._base_from_eye = quaternion_matrix([at.rotation.x, at.rotation.y, at.rotation.z, at.rotation.w])
        self._base_from_eye[:3, 3] = at.translation.x, at.translation.y, at.translation.z
        left, right = self._heard["left info"], self._heard["right info"]
        self._odometry = StereoOdometry(left.K[0], (left.K[2], left.K[5]), -right.P[3] / right.P[0])
        return True


def pixels_of(image):
    """Rows of pixels of a sensor_msgs/Image in rgb8."""
    return np.frombuffer(image.data, np.uint8).reshape(image.height, image.width, 3)


if __name__ == "__main__":
    rospy.init_node("stereo_odometry")
    cv2.setNumThreads(1)  # one process of many: more threads than processors only wait for each other
    node = Node()
    rospy.spin()
