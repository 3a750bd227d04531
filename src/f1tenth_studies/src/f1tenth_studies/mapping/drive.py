"""The map of a drive, without ROS: simulator, driver and mapper in one process."""

import dataclasses
import math
import re
from typing import Any

import numpy as np
import yaml
from f1tenth_gazebo.driving.lap_watch import LapError, LapWatch
from f1tenth_gazebo.errors import MapError
from f1tenth_gazebo.maps.map_alignment import Alignment, aligned
from f1tenth_gazebo.maps.map_check import MapCheck, check_map
from f1tenth_gazebo.maps.occupancy import grid_of
from f1tenth_gazebo.maps.world_grid import LIDAR_HEIGHT
from f1tenth_gazebo.poses import composed
from f1tenth_scenarios.errors import ScenarioError

import f1tenth_sim2d
from f1tenth_scenarios import places
from f1tenth_studies.drives.drive import Drive, Journey
from f1tenth_studies.drives.rms import rms

_TIME_LIMIT = 1200.0  # s simulated, as in create_map.launch
_PARAMETERS = "config/slam_gmapping.yaml"
_OF_THE_NODE = "map_update_interval"


@dataclasses.dataclass(frozen=True)
class Mapped:
    """The outcome of a drive."""

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
        return rms(self.errors)

    @property
    def passed(self) -> bool:
        """Whether the lap is complete and the map good enough."""
        return self.check.passed and not self.problem

    @property
    def has_shape(self) -> bool:
        """Whether it would pass if the whole map were not turned and shifted."""
        return self.shape.passed and not self.problem


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
    journey, watch, truth, problem = Journey(drive), LapWatch(_TIME_LIMIT), [], ""
    try:
        for sample in journey.samples():
            watch.take(sample.time, *sample.truth)
            odometry = composed(sample.odometry, journey.mount)
            if slam.process(sample.ranges, *journey.geometry, odometry, sample.time):
                truth.append(composed(sample.truth, journey.mount))
            if watch.is_over:
                break
    except LapError as error:
        problem = str(error)
    errors = np.hypot(*(slam.path - np.array(truth))[:, :2].T)
    return Mapped(drive, watch.lap or math.inf, *_checks(slam, journey.world), errors, problem)


def _options(mapper: Any) -> Any:
    """The options in `create_map.launch`."""
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
    """Check of the map as it is, its alignment with the world, and check of the map so aligned."""
    cells, resolution, corner = slam.map()
    grid = grid_of(cells == 100, cells == 0, corner, resolution)
    section = world.section(LIDAR_HEIGHT)
    lies = aligned(grid, *section)
    return check_map(grid, *section), lies, check_map(grid, *lies.section_on_map(*section))
