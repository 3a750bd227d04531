"""What a planner that is a Python class is asked, and what it answers.

    from f1tenth_judge.planner import Command, Observation

    class MyPlanner:
        def plan(self, observation: Observation) -> Command:
            return Command(speed=1.0, steering_angle=0.0)

Units are SI; axes as in REP 103: x ahead, y to the left, angles counter-clockwise, rad.
"""

import dataclasses
from collections.abc import Mapping
from typing import Any, Callable, NamedTuple, Optional, Protocol

import numpy as np


class Command(NamedTuple):
    """What the car is to do from now on."""

    speed: float  # m/s
    steering_angle: float  # rad, to the left


@dataclasses.dataclass(frozen=True)
class Scan:
    """What the lidar measures at the end of a period."""

    ranges: np.ndarray  # (n,) float32, m; +inf where nothing is hit
    angle_min: float  # rad, of the first range
    angle_increment: float  # rad, between two
    range_min: float  # m
    range_max: float  # m

    @property
    def angles(self) -> np.ndarray:
        """(n,), rad, of each range in the frame of the lidar."""
        return self.angle_min + self.angle_increment * np.arange(len(self.ranges))


class Eye(NamedTuple):
    """A pinhole of a camera, of which a stereo camera has two. The middle of the first pixel is (0, 0)."""

    camera: str  # the name of the camera
    name: str  # in the camera
    width: int  # pixels
    height: int  # pixels
    focal_x: float  # pixels
    focal_y: float  # pixels
    middle_x: float  # pixels, where the axis is
    middle_y: float  # pixels
    pose: tuple[float, float, float, float]  # x, y, z (m), yaw (rad) in `base_footprint`; it looks along x


class Picture(NamedTuple):
    """What an eye sees at the end of a period."""

    colour: np.ndarray  # (height, width, 3) uint8: red, green, blue
    depth: np.ndarray  # (height, width) float32, m along the axis; +inf where nothing is


def _blind(camera: str, eye: str) -> Picture:
    raise LookupError("this observation is without cameras")


@dataclasses.dataclass(frozen=True)
class Observation:
    """What a car has sensed in a control period (25 ms). Frames: `map`, and the car's `base_footprint`."""

    time: float  # s, simulated, at the end of the period
    scan: Optional[Scan]  # None if the car has no lidar
    pose: tuple[float, float, float]  # x, y (m), yaw (rad) in `map`
    velocity: tuple[float, float, float]  # ahead, to the left (m/s), yaw rate (rad/s)
    steering_angle: float  # rad, to the left: where the front wheels are
    imu: np.ndarray  # (n, 3): acceleration ahead and to the left (m/s^2), yaw rate (rad/s); oldest first
    draw: Callable[[str, str], Picture] = _blind  # what look() asks, of camera and eye

    @property
    def camera(self) -> np.ndarray:
        """Colours of the first eye of the first camera, see Picture."""
        return self.look().colour

    @property
    def depth(self) -> np.ndarray:
        """Depths of the first eye of the first camera, see Picture."""
        return self.look().depth

    def look(self, camera: str = "", eye: str = "") -> Picture:
        """What an eye sees; drawn when it is first asked for, within plan(). Empty: the first one.

        Raises:
            LookupError: the car has no such eye, or plan() has returned.
        """
        return self.draw(camera, eye)


class Planner(Protocol):
    """A planner is made without arguments, in a process of its own, and asked once per period.

    What it prints goes to a log. If it raises, ends, or takes longer than the scenario allows
    (`limits.answer`, wall time), the verdict is `error`, and the reason says so.

    If it has an attribute `notes`, a dictionary, the report shows what is in there after each plan(): numbers
    as charts, points (x, y) and lines of them, m in `map`, on the map.
    """

    def reset(self, info: Mapping[str, Any]) -> None:
        """Get ready; optional. May take `limits.load` of wall time.

        Args:
            info: what a driver's launch file is told (docs/extending.md), by the same names: `car_name`,
                `laps`, `line`, `road`, `map_file`, `speed_max`, `seed`, …, and the scenario's `arguments`;
                besides `eyes`, a list of what the car's cameras are made of, see Eye
        """

    def plan(self, observation: Observation) -> Command:
        """What to do from now on; a speed and a steering angle in a tuple will do."""
