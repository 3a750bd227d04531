"""One drive and the map of it, without ROS: simulator, driver and mapper in one process."""

import dataclasses
import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import yaml
from f1tenth_gazebo.driving.gap_follower import GapFollower, GapFollowerOptions
from f1tenth_gazebo.driving.lap_watch import LapError, LapWatch
from f1tenth_gazebo.errors import MapError
from f1tenth_gazebo.maps.map_alignment import Alignment, aligned
from f1tenth_gazebo.maps.map_check import MapCheck, check_map
from f1tenth_gazebo.maps.occupancy import grid_of
from f1tenth_gazebo.maps.world_grid import LIDAR_HEIGHT
from f1tenth_gazebo.poses import Pose, composed
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_sim2d.environments.xacro_file import expanded

import f1tenth_sim2d
from f1tenth_scenarios import places
from f1tenth_studies.optimum.track import load_track

_STEP = 0.001  # s
_ODOMETRY_MS = 20  # between two messages of the wheels' odometry
_TIME_LIMIT = 1200.0  # s simulated, as in create_map.launch
_PARAMETERS = "config/slam_gmapping.yaml"
_OF_THE_NODE = "map_update_interval"


@dataclasses.dataclass(frozen=True)
class Drive:
    """What is driven."""

    place: str
    world: Path
    centreline: str  # as load_track reads it; the car starts where it does
    seed: int


@dataclasses.dataclass(frozen=True)
class Mapped:
    """What came of it."""

    drive: Drive
    lap: float  # m; infinite if none is complete
    check: MapCheck
    lies: Alignment  # that lays the map onto the truth
    shape: MapCheck  # with the map so laid on
    errors: np.ndarray  # (n,), distances of the mapper's poses from the true ones at its scans, m
    problem: str = ""  # why there was no lap

    @property
    def error(self) -> float:
        """Of the poses, RMS, m."""
        return math.sqrt(float((self.errors**2).mean()))

    @property
    def passed(self) -> bool:
        """Whether the lap is complete and the map good enough."""
        return self.check.passed and not self.problem

    @property
    def has_shape(self) -> bool:
        """Whether it would be, were it not for how the whole map is turned and shifted."""
        return self.shape.passed and not self.problem


@dataclasses.dataclass(frozen=True)
class _Sample:
    scan: np.ndarray  # (beams,), m
    odometry: Pose  # of the rear axle, which begins at the true pose
    truth: Pose
    time: float  # s


def map_drive(drive: Drive) -> Mapped:
    """Drive a lap and a bit of the next, and map it.

    Raises:
        ScenarioError: a file is wrong, or there is nothing to map.
    """
    mapper = _mapper()
    try:
        return _map_drive(drive, mapper.GridSlam(_options(mapper)))
    except (f1tenth_sim2d.Error, mapper.Error, MapError, OSError) as error:
        raise ScenarioError(f"{drive.place}, seed {drive.seed}: {error}") from error


def _mapper() -> Any:
    """The mapper's module, which only the workspace's stand-in has."""
    try:
        import gmapping_core
    except ImportError as error:
        raise ScenarioError(
            "gmapping is the original here, which has no Python module to map with"
        ) from error
    return gmapping_core


def _map_drive(drive: Drive, slam: Any) -> Mapped:
    world = f1tenth_sim2d.load_world(str(drive.world))
    car = f1tenth_sim2d.load_car(expanded(_car_file()), "robot1", "f1tenth.urdf.xacro")
    lidar = car.lidars[0]
    mount = lidar.pose[:2] + lidar.pose[3:]
    geometry = (lidar.angle_min, _increment(lidar), lidar.range_min, lidar.range_max)
    watch, truth, problem = LapWatch(_TIME_LIMIT), [], ""
    start = _start(drive.centreline)
    try:
        for sample in _samples(f1tenth_sim2d.Simulation(world, _STEP, drive.seed), car, start, watch):
            odometry = composed(sample.odometry, mount)
            if slam.process(sample.scan, *geometry, odometry, sample.time):
                truth.append(composed(sample.truth, mount))
    except LapError as error:
        problem = str(error)
    errors = np.hypot(*(slam.path - np.array(truth))[:, :2].T)
    return Mapped(drive, watch.lap or math.inf, *_checks(slam, world), errors, problem)


def _samples(simulation: Any, car: Any, start: Pose, watch: LapWatch) -> Iterator[_Sample]:
    """Of each scan of a drive until it is over, which the true poses tell.

    Raises:
        LapError: there will be no lap.
    """
    identifier = simulation.add_car(car, None, *start)
    lidar = car.lidars[0]
    follower = GapFollower(lidar.angle_min, _increment(lidar), lidar.beam_count, GapFollowerOptions())
    milliseconds = 0
    while not watch.is_over:
        simulation.advance_to(milliseconds / 1000)
        scan, state = simulation.scan(identifier), simulation.state(identifier)
        truth = (state.x, state.y, state.yaw)
        watch.take(simulation.time, *truth)
        odometry = _carried(simulation.wheel_odometry(identifier), milliseconds % _ODOMETRY_MS / 1000)
        yield _Sample(scan, odometry, truth, simulation.time)
        simulation.command(identifier, *follower.command(scan))
        milliseconds += round(1000 / lidar.rate_hz)


def _increment(lidar: Any) -> float:
    return (lidar.angle_max - lidar.angle_min) / (lidar.beam_count - 1)


def _start(centreline: str) -> Pose:
    (x, y), (ahead_x, ahead_y) = load_track(centreline)[:2, :2]
    return float(x), float(y), math.atan2(ahead_y - y, ahead_x - x)


def _carried(odometry: Any, age: float) -> Pose:
    """Odometry, carried on from when it was measured, some time (s) ago: tf interpolates."""
    way, turn = odometry.speed * age, odometry.yaw_rate * age
    direction = odometry.yaw + turn / 2
    return (
        odometry.x + way * math.cos(direction),
        odometry.y + way * math.sin(direction),
        odometry.yaw + turn,
    )


def _car_file() -> Path:
    return places.package_path("f1tenth_description") / "urdf" / "f1tenth.urdf.xacro"


def _options(mapper: Any) -> Any:
    """Those of `create_map.launch`."""
    path = places.package_path(places.GAZEBO_PACKAGE) / _PARAMETERS
    options = mapper.SlamOptions()
    for parameter, value in yaml.safe_load(path.read_text(encoding="utf-8")).items():
        name = re.sub("[A-Z]", lambda letter: f"_{letter[0].lower()}", parameter)  # in Python
        owners = [each for each in (options, options.motion, options.matcher) if hasattr(each, name)]
        if not owners and parameter != _OF_THE_NODE:
            raise ScenarioError(f"{path}: {parameter}: the mapper's Python module does not know it")
        for owner in owners:
            setattr(owner, name, value)
    return options


def _checks(slam: Any, world: Any) -> tuple[MapCheck, Alignment, MapCheck]:
    """Of the map as it is, and laid onto the world."""
    cells, resolution, corner = slam.map()
    grid = grid_of(cells == 100, cells == 0, corner, resolution)
    section = world.section(LIDAR_HEIGHT)
    lies = aligned(grid, *section)
    return check_map(grid, *section), lies, check_map(grid, *lies.section_on_map(*section))
