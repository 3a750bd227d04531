"""One drive: simulator and driver in one process."""

import dataclasses
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from f1tenth_gazebo.driving.gap_follower import GapFollower, GapFollowerOptions
from f1tenth_gazebo.poses import Pose
from f1tenth_sim2d.environments.xacro_file import expanded

import f1tenth_sim2d
from f1tenth_scenarios import places
from f1tenth_studies.optimum.track import load_track

_STEP = 0.001  # s
_ODOMETRY_MS = 20  # between two messages of the wheels' odometry


@dataclasses.dataclass(frozen=True)
class Drive:
    """What is driven."""

    place: str
    world: Path
    centreline: str  # as load_track reads it
    seed: int
    begin: float = 0.0  # where the car starts: part of the centreline

    @property
    def start(self) -> Pose:
        """On the centreline, headed along it.

        Raises:
            ScenarioError: the centreline cannot be read.
        """
        track = load_track(self.centreline)[:, :2]
        (x, y), (ahead_x, ahead_y) = np.roll(track, -round(self.begin * len(track)), axis=0)[:2]
        return float(x), float(y), math.atan2(ahead_y - y, ahead_x - x)


@dataclasses.dataclass(frozen=True)
class Sample:
    """What is known at a scan."""

    ranges: np.ndarray  # (beams,), m
    odometry: Pose  # of the rear axle, which begins at the true pose
    truth: Pose
    time: float  # s


class Journey:
    """A drive without an end: the car of the workspace on its way."""

    def __init__(self, drive: Drive):
        """Load the world and the car.

        Raises:
            f1tenth_sim2d.Error: the world cannot be read.
            ScenarioError: the centreline cannot be read.
        """
        self.world = f1tenth_sim2d.load_world(str(drive.world))
        self._car = f1tenth_sim2d.load_car(expanded(_car_file()), "robot1", "f1tenth.urdf.xacro")
        self._drive = drive
        lidar = self._car.lidars[0]
        self.mount = lidar.pose[:2] + lidar.pose[3:]
        """Of the lidar on the car."""
        self.geometry = (lidar.angle_min, _increment(lidar), lidar.range_min, lidar.range_max)
        """Of a scan: first angle and step (rad), least and greatest range (m)."""

    def points(self, ranges: np.ndarray) -> np.ndarray:
        """Where beams ended, (n, 2), m, in the frame of the car; without those that met nothing."""
        first, step, least, greatest = self.geometry
        x, y, yaw = self.mount
        beams = np.flatnonzero((least < ranges) & (ranges < greatest))
        angles, ranges = yaw + first + step * beams, ranges[beams]
        return np.column_stack([x + ranges * np.cos(angles), y + ranges * np.sin(angles)])

    def samples(self) -> Iterator[Sample]:
        """One sample per scan."""
        simulation = f1tenth_sim2d.Simulation(self.world, _STEP, self._drive.seed)
        identifier = simulation.add_car(self._car, None, *self._drive.start)
        lidar = self._car.lidars[0]
        follower = GapFollower(*self.geometry[:2], lidar.beam_count, GapFollowerOptions())
        milliseconds = 0
        while True:
            simulation.advance_to(milliseconds / 1000)
            scan, state = simulation.scan(identifier), simulation.state(identifier)
            age = milliseconds % _ODOMETRY_MS / 1000
            odometry = _carried(simulation.wheel_odometry(identifier), age)
            yield Sample(scan, odometry, (state.x, state.y, state.yaw), simulation.time)
            simulation.command(identifier, *follower.command(scan))
            milliseconds += round(1000 / lidar.rate_hz)


def _increment(lidar: Any) -> float:
    return (lidar.angle_max - lidar.angle_min) / (lidar.beam_count - 1)


def _carried(odometry: Any, age: float) -> Pose:
    """Odometry, extrapolated from when it was measured, some time (s) ago: tf interpolates."""
    way, turn = odometry.speed * age, odometry.yaw_rate * age
    direction = odometry.yaw + turn / 2
    return (
        odometry.x + way * math.cos(direction),
        odometry.y + way * math.sin(direction),
        odometry.yaw + turn,
    )


def _car_file() -> Path:
    return places.package_path("f1tenth_description") / "urdf" / "f1tenth.urdf.xacro"
