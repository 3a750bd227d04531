"""Follow the gap in the ways in which people write it; the argument names one."""

import os
import subprocess
import sys

import numpy as np
from dds_node import SENSOR_DATA, Node
from f1tenth_judge.drivers.ros2.messages.driving import AckermannDrive, AckermannDriveStamped
from f1tenth_judge.drivers.ros2.messages.sensing import LaserScan

BUBBLE = 0.35  # m, kept clear around the nearest obstacle
SIGHT = 4.0  # m


def command_for(scan):
    angles = scan.angle_min + scan.angle_increment * np.arange(len(scan.ranges))
    ahead = np.abs(angles) < 1.2
    angles, ranges = angles[ahead], np.clip(np.array(scan.ranges)[ahead], 0.0, SIGHT)
    ranges = np.convolve(ranges, np.ones(9) / 9, "same")
    nearest = int(np.argmin(ranges))
    ranges[np.abs(angles - angles[nearest]) < np.arctan2(BUBBLE, ranges[nearest])] = 0.0
    angle = float(np.average(angles, weights=ranges**3 + 1e-6))
    drive = AckermannDrive(steering_angle=angle, speed=2.0 if abs(angle) < 0.15 else 1.2)
    return AckermannDriveStamped(scan.header, drive)


def by_subscription():
    node = Node()
    publish = node.publisher("drive", AckermannDriveStamped)
    node.subscribe("scan", LaserScan, lambda scan: publish(command_for(scan)), SENSOR_DATA)
    node.spin()


def by_timer():
    """At 20 Hz, with the newest scan."""
    node, newest = Node(), []
    publish = node.publisher("drive", AckermannDriveStamped)
    node.subscribe("scan", LaserScan, lambda scan: newest.__setitem__(slice(None), [scan]))

    def drive():
        print(node.now, flush=True)
        for scan in newest:
            publish(command_for(scan))

    node.timer(0.05, drive)
    node.spin()


def by_three_nodes():
    """Each a process: one clips the scan, one steers, one passes commands on."""
    roles = [subprocess.Popen([sys.executable, __file__, role]) for role in ("clips", "steers")]
    node = Node()
    publish = node.publisher("drive", AckermannDriveStamped)
    node.subscribe("nav", AckermannDriveStamped, publish)
    node.spin()
    os.waitpid(roles[0].pid, 0)


def clips():
    node = Node()
    publish = node.publisher("clipped", LaserScan)

    def clip(scan):
        scan.ranges = [min(each, SIGHT) for each in scan.ranges]
        publish(scan)

    node.subscribe("scan", LaserScan, clip)
    node.spin()


def steers():
    node = Node()
    publish = node.publisher("nav", AckermannDriveStamped)
    node.subscribe("clipped", LaserScan, lambda scan: publish(command_for(scan)))
    node.spin()


if __name__ == "__main__":
    globals()[sys.argv[1]]()
