"""A car without physics in a room without a simulator.

It follows cmd_vel and publishes clock, map, scan, odom and tf. It plays the simulator's side of lockstep, so
that a test depends on nothing but simulated time; or it lets time run.
"""

import collections
import copy
import math
import threading
import time
import warnings

import numpy as np
import rospy
from geometry_msgs.msg import TransformStamped, Twist
from nav_msgs.msg import OccupancyGrid, Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Header
from tf2_msgs.msg import TFMessage

# Publishers without a queue are wanted here: what is published is out before the clock goes on.
warnings.filterwarnings("ignore", category=SyntaxWarning, message=".*queue_size.*")

PERIOD = rospy.Duration(0.025)
RESOLUTION = 0.05
BEAMS = 271
RANGE_MAX = 10.0
FUTURE = rospy.Duration(2.0)
WHEELBASE = 0.3302
MAX_CURVATURE = math.tan(0.4189) / WHEELBASE


class Room:
    """A rectangle of free floor in walls, its lower left corner at the origin; m."""

    def __init__(self, width, height):
        self.cells = np.zeros((round(height / RESOLUTION), round(width / RESOLUTION)), np.int8)
        self.cells[[0, -1], :] = 100
        self.cells[:, [0, -1]] = 100

    def add_wall(self, x_min, y_min, x_max, y_max):
        """Fill a rectangle."""
        i, j, k, m = (round(v / RESOLUTION) for v in (y_min, y_max, x_min, x_max))
        self.cells[i:j, k:m] = 100

    def is_wall(self, x, y):
        """Whether points are in a wall or outside; arrays or numbers."""
        column = np.clip((np.asarray(x) / RESOLUTION).astype(int), 0, self.cells.shape[1] - 1)
        row = np.clip((np.asarray(y) / RESOLUTION).astype(int), 0, self.cells.shape[0] - 1)
        return self.cells[row, column] == 100

    def scan(self, x, y, angles):
        """Ranges seen from a point, m, inf beyond RANGE_MAX."""
        ranges = np.arange(0.0, RANGE_MAX, RESOLUTION / 2)
        hit = self.is_wall(x + np.outer(np.cos(angles), ranges), y + np.outer(np.sin(angles), ranges))
        return np.where(hit.any(axis=1), ranges[hit.argmax(axis=1)], np.inf)

    def message(self):
        """The room as the map that a map server publishes."""
        message = OccupancyGrid()
        message.header.frame_id = "map"
        message.info.resolution = RESOLUTION
        message.info.height, message.info.width = self.cells.shape
        message.info.origin.orientation.w = 1.0
        message.data = self.cells.ravel().tolist()
        return message


class FakeRobot:
    """The car, its sensors and the clock; runs on a thread of its own from start() to stop()."""

    def __init__(self, room, participant=None):
        """Participant: whose answer time waits for; None: time runs like that of the wall clock."""
        self.real_room = room
        self.pose = (1.0, 1.0, 0.0)  # x, y (m), yaw (rad) of base_footprint
        self.speed = 0.0
        self.scan_works = True
        self.wheels_grip = True
        self.delay = 0  # periods by which sensors and tf are late
        self.transforms_delay = 0  # the same of tf alone, on top
        self.faults = {}  # "scan", "odom" or "tf" to "stopped", "frozen" or "future"
        self._held = {}  # what was published last of each without a fault
        self._sent = collections.deque(maxlen=100)  # per period: transforms, odometry, scan
        self.commands = []  # (time in s, Twist), all so far
        self.touched = False  # whether the middle of the car was ever in a wall
        self.reads_angles = False  # whether commands say the angle of its wheels
        self._participant = participant
        self._period = (
            threading.Lock()
        )  # held while a period is published or moved on: a car is put in between
        self._done = threading.Condition()
        self._done_stamp = rospy.Time(0)
        self._time = rospy.Time(0)
        self._command = Twist()
        self._running = True
        self._clock = rospy.Publisher("/clock", Clock, queue_size=None, tcp_nodelay=True)
        self._odom = rospy.Publisher("odom", Odometry, queue_size=None, tcp_nodelay=True)
        self._scan = rospy.Publisher("scan", LaserScan, queue_size=None, tcp_nodelay=True)
        self._tf = rospy.Publisher("/tf", TFMessage, queue_size=None, tcp_nodelay=True)
        self._map = rospy.Publisher("map", OccupancyGrid, queue_size=None, latch=True)
        self._map.publish(room.message())
        rospy.Subscriber("/sim2d/done", Header, self._on_done, tcp_nodelay=True)
        rospy.Subscriber("cmd_vel", Twist, self._on_command, tcp_nodelay=True)
        self._thread = threading.Thread(target=self._run, daemon=True)

    def start(self):
        """Let time run."""
        self._thread.start()

    def stop(self):
        """Let time stand still for good."""
        self._running = False
        self._thread.join()

    def put(self, x, y, yaw=0.0):
        """Stand at a pose, with everything in order."""
        with self._period:
            self.pose = (x, y, yaw)
            self.speed = 0.0
            self.scan_works = True
            self.wheels_grip = True
            self.delay = 0
            self.transforms_delay = 0
            self.faults = {}
            self._sent.clear()
            self.touched = False
            self.commands.clear()
            self._command = Twist()

    def restart_clock(self):
        """Let simulated time begin again, as Gazebo's reset_simulation does."""
        with self._period:
            self._time = rospy.Time(0)
            self._sent.clear()

    @property
    def now(self):
        """Simulated time, s."""
        return self._time.to_sec()

    def _on_done(self, message):
        with self._done:
            if message.frame_id == self._participant:
                self._done_stamp = message.stamp
                self._done.notify_all()

    def _on_command(self, message):
        self._command = message
        self.commands.append((self.now, message))

    def _run(self):
        self._time += PERIOD
        while self._running and not rospy.is_shutdown():
            with self._period:
                self._publish()
            while self._running and not self._period_over():
                self._publish_again()
            with self._period:
                self._move(PERIOD.to_sec())
                self._time += PERIOD

    def _period_over(self):
        if self._participant is None:
            time.sleep(PERIOD.to_sec())
            return True
        with self._done:
            return self._done.wait_for(lambda: self._done_stamp >= self._time, timeout=0.1)

    def _move(self, duration):
        command = self._command if self.wheels_grip else Twist()
        self.speed = command.linear.x
        curvature = command.angular.z / self.speed if self.speed != 0.0 else 0.0
        if self.reads_angles:
            curvature = math.tan(command.angular.z) / WHEELBASE
        curvature = max(-MAX_CURVATURE, min(MAX_CURVATURE, curvature))
        x, y, yaw = self.pose
        middle = yaw + 0.5 * self.speed * curvature * duration
        x += self.speed * duration * math.cos(middle)
        y += self.speed * duration * math.sin(middle)
        self.pose = (x, y, yaw + self.speed * curvature * duration)
        self.touched = self.touched or self._touches()

    def _touches(self):
        x, y, yaw = self.pose
        along, across = np.meshgrid(np.linspace(-0.125, 0.455, 15), np.linspace(-0.155, 0.155, 9))
        return self.real_room.is_wall(
            x + along * math.cos(yaw) - across * math.sin(yaw),
            y + along * math.sin(yaw) + across * math.cos(yaw),
        ).any()

    def _publish_again(self):
        """Who connects late must find a scan and tf; who thinks for long must not hear them twice."""
        if self._done_stamp.is_zero():
            self._publish()
        else:
            self._clock.publish(Clock(self._time))

    def _publish(self):
        self._sent.append((self._transforms(), self._odometry(), self._laser_scan()))
        _, odometry, scan = self._sent_before(self.delay)
        self._send("tf", self._tf, self._sent_before(self.delay + self.transforms_delay)[0])
        self._send("odom", self._odom, odometry)
        if self.scan_works:
            self._send("scan", self._scan, scan)
        self._clock.publish(Clock(self._time))

    def _send(self, name, publisher, message):
        fault = self.faults.get(name)
        if fault is None:
            self._held[name] = message
        elif fault == "frozen":
            message = self._held[name]
        elif fault == "future":
            message = copy.deepcopy(message)
            for part in message.transforms if name == "tf" else [message]:
                part.header.stamp += FUTURE
        if fault != "stopped":
            publisher.publish(message)

    def _sent_before(self, periods):
        return self._sent[-1 - min(periods, len(self._sent) - 1)]

    def _transforms(self):
        identity = TransformStamped()
        identity.header.stamp = self._time
        identity.header.frame_id = "map"
        identity.child_frame_id = "odom"
        identity.transform.rotation.w = 1.0
        base = TransformStamped()
        base.header.stamp = self._time
        base.header.frame_id = "odom"
        base.child_frame_id = "base_footprint"
        base.transform.translation.x, base.transform.translation.y, yaw = self.pose
        base.transform.rotation.z = math.sin(yaw / 2)
        base.transform.rotation.w = math.cos(yaw / 2)
        return TFMessage([identity, base])

    def _odometry(self):
        odometry = Odometry()
        odometry.header.stamp = self._time
        odometry.header.frame_id = "odom"
        odometry.child_frame_id = "base_footprint"
        odometry.twist.twist.linear.x = self.speed
        return odometry

    def _laser_scan(self):
        x, y, yaw = self.pose
        angles = np.linspace(-0.75 * math.pi, 0.75 * math.pi, BEAMS)
        scan = LaserScan()
        scan.header.stamp = self._time
        scan.header.frame_id = "base_footprint"
        scan.angle_min = angles[0]
        scan.angle_max = angles[-1]
        scan.angle_increment = angles[1] - angles[0]
        scan.range_min = 0.05
        scan.range_max = RANGE_MAX
        scan.ranges = self.real_room.scan(x, y, yaw + angles).tolist()
        return scan
