"""The node drive_lap: takes the car around once, then saves the map."""

import math
import subprocess
import sys
import threading

import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

from f1tenth_gazebo.driving.gap_follower import GapFollower, GapFollowerOptions
from f1tenth_gazebo.driving.lap_watch import LapWatch

PATIENCE = 5.0
"""Wall time in which the odometry of a scan's time must have come, s."""
OVERLAP = 4.0
"""Way beyond the start, m: what has been seen twice closes the map."""


class OdometryAtScans:
    """Which odometry belongs to a scan does not depend on which of the two messages comes first."""

    def __init__(self):
        """Subscribe."""
        self._arrived = threading.Condition()
        self._messages = []
        rospy.Subscriber("odom", Odometry, self._on_odometry, tcp_nodelay=True)

    def _on_odometry(self, message):
        with self._arrived:
            self._messages.append(message)
            self._arrived.notify_all()

    def at(self, stamp):
        """The last odometry not after a stamp, once no later one can belong to it; or None."""
        with self._arrived:
            self._arrived.wait_for(lambda: self._is_complete(stamp), PATIENCE)
            known = [message for message in self._messages if message.header.stamp <= stamp]
            self._messages = known[-1:] + self._messages[len(known) :]
        return known[-1] if known else None

    def _is_complete(self, stamp):
        """At 50 Hz the next one is less than 20 ms away."""
        return any((stamp - message.header.stamp).to_sec() < 0.0199 for message in self._messages)


class LapDriver:
    """Answers each scan with one command; after a lap and some more it stops and is finished."""

    def __init__(self, options):
        """Subscribe and advertise."""
        self._options = options
        self._follower = None
        self._watch = LapWatch()
        self._end = math.inf
        self.finished = threading.Event()
        self.released = threading.Event()
        self._odometry = OdometryAtScans()
        self._publisher = rospy.Publisher("drive", AckermannDriveStamped, queue_size=1, tcp_nodelay=True)
        rospy.Subscriber("scan", LaserScan, self._on_scan, tcp_nodelay=True)

    def _on_scan(self, scan):
        odometry = self._odometry.at(scan.header.stamp)
        if odometry is not None and self._is_over(odometry):
            # In lockstep nothing goes on until the map is saved, so that it is the same map every time.
            self.finished.set()
            self.released.wait()
            return
        speed, steering = (0.0, 0.0) if self._watch.way > self._end else self._command(scan)
        message = AckermannDriveStamped()
        message.header.stamp = scan.header.stamp
        message.drive.speed = speed
        message.drive.steering_angle = steering
        self._publisher.publish(message)

    def _command(self, scan):
        if self._follower is None:
            self._follower = GapFollower(
                scan.angle_min, scan.angle_increment, len(scan.ranges), self._options
            )
        return self._follower.command(scan.ranges)

    def _is_over(self, odometry):
        pose, twist = odometry.pose.pose, odometry.twist.twist
        yaw = 2.0 * math.atan2(pose.orientation.z, pose.orientation.w)
        if self._watch.passes_start(pose.position.x, pose.position.y, yaw) and self._end == math.inf:
            self._end = self._watch.way + OVERLAP
            rospy.loginfo("The lap is complete after %.1f m", self._watch.way)
        return self._watch.way > self._end and abs(twist.linear.x) < 0.1


def save_map(stem):
    """Let map_saver write STEM.pgm and STEM.yaml; return its exit code."""
    return subprocess.run(
        ["rosrun", "map_server", "map_saver", "-f", stem, "map:=/map"], check=False
    ).returncode


def main():
    """Wire the driver; return the exit code."""
    rospy.init_node("drive_lap")
    names = ("speed", "max_lateral_acceleration")
    given = {name: rospy.get_param(f"~{name}") for name in names if rospy.has_param(f"~{name}")}
    try:
        driver = LapDriver(GapFollowerOptions(**given))
    except (TypeError, ValueError) as error:
        print(f"drive_lap: {error}", file=sys.stderr)
        return 2
    while not driver.finished.wait(0.1):
        if rospy.is_shutdown():
            return 1
    code = save_map(rospy.get_param("~map_file"))
    driver.released.set()
    return code
