"""Planners that drive slowly and tell what they hear; the argument names one."""

import sys
import zlib

from dds_node import LATCHED, SENSOR_DATA, Node
from f1tenth_judge.drivers.ros2.messages.basic import Clock, Header
from f1tenth_judge.drivers.ros2.messages.drawing import (
    ColorRGBA,
    Float32,
    Marker,
    MarkerArray,
    Path,
    PoseStamped,
)
from f1tenth_judge.drivers.ros2.messages.driving import AckermannDrive, AckermannDriveStamped
from f1tenth_judge.drivers.ros2.messages.geometry import Pose, TFMessage, Twist, Vector3
from f1tenth_judge.drivers.ros2.messages.navigation import OccupancyGrid, Odometry
from f1tenth_judge.drivers.ros2.messages.sensing import CameraInfo, Image, Imu, LaserScan


def slow_node():
    node = Node()
    publish = node.publisher("drive", AckermannDriveStamped)
    command = AckermannDriveStamped(drive=AckermannDrive(speed=0.5))
    node.subscribe("scan", LaserScan, lambda scan: publish(command))
    return node


def tells_both():
    """Per stamp, where its own car is and where the other one is: y, m."""
    node, own = slow_node(), {}

    def note(odometry):
        own[odometry.header.stamp.to_sec()] = odometry.pose.pose.position.y

    def tell(odometry):
        stamp = odometry.header.stamp.to_sec()
        print(stamp, own[stamp], odometry.pose.pose.position.y, flush=True)

    node.subscribe("ego_racecar/odom", Odometry, note)
    node.subscribe("opp_racecar/odom", Odometry, tell)
    node.spin()


def tells_what_it_hears():
    """In the order in which it comes, and when it was sensed (s); drives by velocities."""
    node = Node()
    publish = node.publisher("cmd_vel", Twist)

    def hear(topic, kind, when=lambda message: message.header.stamp):
        node.subscribe(topic, kind, lambda message: print(when(message).to_sec(), topic, flush=True))

    hear("imu", Imu)
    hear("odom", Odometry)
    hear("ego_racecar/odom", Odometry)
    hear("scan", LaserScan)
    hear("clock", Clock, lambda message: message.clock)
    node.subscribe("scan", LaserScan, lambda scan: publish(Twist(linear=Vector3(0.5))))
    node.spin()


def tells_where_all_is():
    node, told = slow_node(), set()

    def tell(*words):
        if words not in told:
            told.add(words)
            print(*words, flush=True)

    def tell_frames(message):
        for each in message.transforms:
            tell(each.header.frame_id, each.child_frame_id)

    def tell_map(grid):
        tell("map", grid.info.width, grid.info.height, sum(grid.data))

    node.subscribe("map", OccupancyGrid, tell_map, LATCHED)
    node.subscribe("tf_static", TFMessage, tell_frames, LATCHED)
    node.subscribe("tf", TFMessage, tell_frames)
    node.spin()


def tells_pictures():
    """Per picture of the right eye: stamp, size, and a sum over all of it."""
    node = slow_node()

    def tell(image):
        words = image.encoding, image.width, image.height, image.step, image.header.frame_id
        print(image.header.stamp.to_sec(), *words, zlib.crc32(bytes(image.data)), flush=True)

    def tell_info(info):
        numbers = (round(each, 3) for each in (*info.k[:3], *info.p[:4]))
        print(info.header.stamp.to_sec(), "info", *numbers, flush=True)

    node.subscribe("stereo_camera/right/image_raw", Image, tell)
    node.subscribe("stereo_camera/right/depth/image_raw", Image, tell)
    node.subscribe("stereo_camera/right/camera_info", CameraInfo, tell_info)
    node.spin()


def hears_pictures_best_effort():
    node = slow_node()
    node.subscribe("stereo_camera/left/image_raw", Image, lambda image: None, SENSOR_DATA)
    node.spin()


def draws():
    """A path in the map, latched and only once; then a point ahead of the car, and a number."""
    node = slow_node()
    path = Path(Header(frame_id="map"), [PoseStamped(pose=Pose.planar(x, 1.0, 0.0)) for x in (0.0, 2.0)])
    lead = node.publisher("way", Path, LATCHED)
    lead(path)
    mark, tell = node.publisher("debug/target", MarkerArray), node.publisher("debug/beams", Float32)
    target = Marker(
        Header(frame_id="ego_racecar/laser"), type=2, scale=Vector3(0.2), color=ColorRGBA(r=1.0, a=1.0)
    )

    def show(scan):
        mark(MarkerArray([target]))
        tell(Float32(len(scan.ranges)))

    node.subscribe("scan", LaserScan, show)
    node.spin()


if __name__ == "__main__":
    globals()[sys.argv[1]]()
