"""A planner that goes wrong in the way that its argument names."""

import subprocess
import sys
import threading
import time

from dds_node import LATCHED, SENSOR_DATA, Node
from f1tenth_judge.drivers.ros2.messages.driving import AckermannDrive, AckermannDriveStamped
from f1tenth_judge.drivers.ros2.messages.geometry import PoseWithCovarianceStamped, Twist
from f1tenth_judge.drivers.ros2.messages.navigation import Odometry
from f1tenth_judge.drivers.ros2.messages.sensing import Imu, LaserScan


def command(speed=0.5):
    return AckermannDriveStamped(drive=AckermannDrive(speed=speed))


def ends_at_once():
    print("nothing to do")


def dies_at_once():
    raise ValueError("no model weights in /models")


def raises_in_callback():
    node = Node()
    node.subscribe("scan", LaserScan, lambda scan: scan.no_such_field)
    node.spin()


def is_silent():
    node = Node()
    node.publisher("drive", AckermannDriveStamped)
    node.subscribe("scan", LaserScan, lambda scan: None)
    print("waiting for a joystick", flush=True)
    node.spin()


def answers(speed, drive="drive", kind=AckermannDriveStamped, qos=None):
    node = Node()
    publish = node.publisher(drive, kind, **({"qos": qos} if qos else {}))
    node.subscribe("scan", LaserScan, lambda scan: publish(command(speed) if kind is not Twist else Twist()))
    node.spin()


def says_nan():
    answers(float("nan"))


def sends_elsewhere():
    answers(1.0, drive="nav")


def sends_twists():
    answers(1.0, kind=Twist)


def sends_best_effort():
    answers(1.0, qos=SENSOR_DATA)


def hears_latched_scans():
    node = Node()
    publish = node.publisher("drive", AckermannDriveStamped)
    node.subscribe("scan", LaserScan, lambda scan: publish(command()), LATCHED)
    node.spin()


def hears_latched_odometry():
    node = Node()
    publish = node.publisher("drive", AckermannDriveStamped)
    node.subscribe("scan", LaserScan, lambda scan: publish(command()))
    node.subscribe("odom", Odometry, lambda odometry: None, LATCHED)
    node.spin()


def hears_another_type():
    node = Node()
    publish = node.publisher("drive", AckermannDriveStamped)
    node.subscribe("scan", Imu, lambda scan: publish(command()))
    node.subscribe("lidar", LaserScan, lambda scan: publish(command()))
    node.spin()


def floods():
    node = Node()
    publish = node.publisher("drive", AckermannDriveStamped)
    node.subscribe("scan", LaserScan, lambda scan: [publish(command()) for _ in range(100)])
    node.spin()


def contradicts_itself():
    """Answers each scan twice, from one process."""
    node = Node()
    fast, slow = (node.publisher("drive", AckermannDriveStamped) for _ in range(2))
    node.subscribe("scan", LaserScan, lambda scan: (fast(command(1.0)), slow(command(0.5))))
    node.spin()


def is_of_two_minds():
    """Answers each scan from two processes."""
    subprocess.Popen([sys.executable, __file__, "sends_slowly"])
    answers(1.0)


def sends_slowly():
    answers(0.5)


def goes_by_the_wall_clock():
    node = Node()
    publish = node.publisher("drive", AckermannDriveStamped)
    node.subscribe("scan", LaserScan, lambda scan: None)

    def send():
        while True:
            publish(command())
            time.sleep(0.1)

    threading.Thread(target=send, daemon=True).start()
    node.spin()


def hangs_in_callback():
    node, scans = Node(), []
    publish = node.publisher("drive", AckermannDriveStamped)

    def answer(scan):
        scans.append(scan)
        while len(scans) > 60:
            pass
        publish(command())

    node.subscribe("scan", LaserScan, answer)
    node.spin()


def puts_itself_elsewhere():
    """As rviz's 2D Pose Estimate does, which moves the car in f1tenth_gym_ros."""
    node = Node()
    place = node.publisher("initialpose", PoseWithCovarianceStamped)
    publish = node.publisher("drive", AckermannDriveStamped)

    def answer(scan):
        place(PoseWithCovarianceStamped())
        publish(command())

    node.subscribe("scan", LaserScan, answer)
    node.spin()


if __name__ == "__main__":
    globals()[sys.argv[1]]()
