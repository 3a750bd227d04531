"""The node drive_lap: takes the car around once, then saves the map."""

import sys
import threading
from pathlib import Path

import numpy as np
import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from f1tenth_judge.places.map_file import save_map
from nav_msgs.msg import OccupancyGrid
from nav_msgs.srv import GetMap
from sensor_msgs.msg import LaserScan

from f1tenth_gazebo.driving.drive_message import drive_message
from f1tenth_gazebo.driving.gap_follower import GapFollower, GapFollowerOptions
from f1tenth_gazebo.driving.lap_inputs import LapInputs
from f1tenth_gazebo.driving.lap_watch import LapError, LapWatch
from f1tenth_gazebo.launches import end_launch
from f1tenth_gazebo.maps.occupancy import grid_of
from f1tenth_gazebo.outputs import has_name

STANDS = 0.1
"""Below this speed the car counts as standing, m/s."""
SCANS_STANDING = 40
"""Until the drive is finished: in lockstep the mapper's last map has arrived by then."""
_ALL_THAT_WAIT = 2**22
"""Bytes: rospy keeps the newest of the messages that it reads at once, so it must read all at once."""


class LapDriver:
    """Answers each scan with one command; after a lap and some more it stops and is finished."""

    def __init__(self, options, time_limit, in_lockstep):
        """Subscribe and advertise."""
        self._options = options
        self.in_lockstep = in_lockstep
        self._follower = None
        self._inputs = LapInputs()
        self._standing = 0
        self.watch = LapWatch(time_limit)
        self.problem = ""
        """Why there will be no lap."""
        self.finished = threading.Event()
        self.released = threading.Event()
        self._publisher = rospy.Publisher("drive", AckermannDriveStamped, queue_size=1, tcp_nodelay=True)
        # The newest scan only: where a machine is too busy for all, commands would get older and older.
        rospy.Subscriber(
            "scan", LaserScan, self._on_scan, queue_size=1, buff_size=_ALL_THAT_WAIT, tcp_nodelay=True
        )

    def _on_scan(self, scan):
        if self.finished.is_set() or self._is_over(scan.header.stamp):
            self.finished.set()
            if self.in_lockstep:
                # Time stands still until the map is saved, so that it is the same map every time.
                self.released.wait()
            return
        speed, steering = (0.0, 0.0) if self.watch.is_over or self.problem else self._command(scan)
        self._publisher.publish(drive_message(scan.header.stamp, speed, steering))

    def _command(self, scan):
        if self._follower is None:
            self._follower = GapFollower(
                scan.angle_min, scan.angle_increment, len(scan.ranges), self._options
            )
        return self._follower.command(scan.ranges)

    def _is_over(self, stamp):
        known = self._inputs.at(stamp)
        if known is None or self.problem:
            return bool(self.problem)
        pose, speed = known
        lap = self.watch.lap
        try:
            self.watch.take(stamp.to_sec(), *pose)
        except LapError as error:
            self.problem = str(error)
        if self.watch.lap != lap:
            rospy.loginfo("The lap is complete after %.1f m", self.watch.lap)
        self._standing = self._standing + 1 if self.watch.is_over and abs(speed) < STANDS else 0
        return bool(self.problem) or self._standing >= SCANS_STANDING


class MapKeeper:
    """Keeps the last map: when a launch is interrupted, its mapper ends as soon as all other nodes."""

    def __init__(self):
        """Subscribe."""
        self._message = None
        self._map = None
        rospy.Subscriber("/map", rospy.AnyMsg, self._keep, tcp_nodelay=True)

    def _keep(self, message):
        # As bytes: most of them are never looked at.
        self._message = message

    def wait_for_mapper(self):
        """Wait until the mapper has taken in all scans so far; without lockstep it may be seconds behind.

        It answers the second of two calls after the scans that came before the first.
        """
        ask = rospy.ServiceProxy("/dynamic_map", GetMap)
        try:
            ask()
            self._map = ask().map
        except rospy.ServiceException:
            rospy.logwarn("The mapper does not tell when it is done: its last map on /map counts")

    def save(self, stem):
        """Write STEM.pgm and STEM.yaml; return whether there was a map.

        Raises:
            OSError: if they cannot be written.
        """
        if self._message is None:
            return False
        grid = self._map or OccupancyGrid().deserialize(self._message._buff)
        cells = np.array(grid.data, dtype=np.int8).reshape(grid.info.height, grid.info.width)
        corner = grid.info.origin.position
        save_map(grid_of(cells == 100, cells == 0, (corner.x, corner.y), grid.info.resolution), stem)
        return True


def drive(driver, keeper, stem):
    """Wait for the end of the drive and save the map; return the exit code."""
    while not driver.finished.wait(0.1) and not rospy.is_shutdown():
        pass
    way = f"{driver.watch.way:.1f} m"
    # In lockstep the mapper keeps up, and stands still until the map is saved.
    if driver.finished.is_set() and not driver.in_lockstep:
        keeper.wait_for_mapper()
    try:
        what = f"{stem}.pgm and {stem}.yaml" if keeper.save(stem) else "nothing, as there is no map yet"
    except OSError as error:
        print(f"drive_lap: the map cannot be saved: {error}", file=sys.stderr)
        return 1
    if driver.finished.is_set() and not driver.problem:
        rospy.loginfo("Saved the map as %s", what)
        return 0
    reason = driver.problem or f"interrupted after {way}"
    print(f"drive_lap: {reason}. Saved of what has been mapped: {what}", file=sys.stderr, flush=True)
    return 1


def _map_stem():
    stem = str(rospy.get_param("~map_file", ""))
    if not has_name(Path(stem)):
        name = rospy.resolve_name("~map_file")
        raise ValueError(f"{name}: found '{stem}', must be a path without extension that ends with a name")
    return stem


def main():
    """Wire the driver; return the exit code."""
    rospy.init_node("drive_lap")
    names = ("speed", "max_lateral_acceleration")
    given = {name: rospy.get_param(f"~{name}") for name in names if rospy.has_param(f"~{name}")}
    try:
        stem = _map_stem()
        options, time_limit = GapFollowerOptions(**given), float(rospy.get_param("~time_limit", 1200.0))
        driver = LapDriver(options, time_limit, bool(rospy.get_param("~lockstep", False)))
    except (TypeError, ValueError) as error:
        print(f"drive_lap: {error}", file=sys.stderr)
        return 2
    ends = rospy.get_param("~ends_launch", False)
    then = "and the launch ends" if ends else ""
    rospy.loginfo(
        "Driving a lap at up to %.1f m/s; then %s.pgm and .yaml are saved %s", options.speed, stem, then
    )
    code = drive(driver, MapKeeper(), stem)
    if code == 0 and not rospy.is_shutdown() and ends:
        end_launch()
        rospy.spin()
    driver.released.set()
    return code
