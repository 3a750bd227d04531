"""The localizer of amcl without ROS, with the parameters of the workspace."""

import math
from typing import Any, Optional

import yaml
from f1tenth_gazebo.maps.map_file import load_map
from f1tenth_gazebo.poses import Pose
from f1tenth_scenarios.errors import ScenarioError

from f1tenth_scenarios import places
from f1tenth_studies.drives.drive import Drive


def localizer_module() -> Any:
    """The module of amcl, which only the workspace's stand-in has.

    Raises:
        ScenarioError: amcl is the original.
    """
    try:
        import amcl_core
    except ImportError as error:
        raise ScenarioError("amcl is the original here, which has no Python module to look with") from error
    return amcl_core


def make_localizer(amcl: Any, drive: Drive, believed: Pose, deviations: Optional[Pose]) -> Any:
    """A localizer on the map of a drive, with its seed.

    Args:
        amcl: the module
        drive: the one whose map is used
        believed: where the car is said to be
        deviations: how sure that is, of x, y (m) and yaw (rad); default: as the parameters say

    Raises:
        MapError: the map cannot be read.
        ScenarioError: the module does not know a parameter.
    """
    grid = load_map(places.map_file(drive.world))
    options, sure = _options(amcl, drive.seed)
    corner = grid.x, grid.y
    return amcl.Localizer(grid.cells, grid.resolution, corner, options, believed, deviations or sure)


def _options(amcl: Any, seed: int) -> tuple[Any, Pose]:
    """The options in `f1tenth_navigation/config/amcl.yaml`, and its deviations of x, y (m) and yaw (rad)."""
    path = places.package_path("f1tenth_navigation") / "config" / "amcl.yaml"
    given = yaml.safe_load(path.read_text(encoding="utf-8"))
    x, y, yaw = (math.sqrt(given.pop(f"initial_cov_{axis}")) for axis in ("xx", "yy", "aa"))
    del given["save_pose_rate"]  # a parameter of the node
    options = amcl.LocalizerOptions()
    options.seed = seed
    models = {"odom": amcl.OdometryModel, "laser": amcl.LaserModel}
    parts = {"odom": options.odometry, "laser": options.laser}
    for parameter, value in given.items():
        part, _, rest = parameter.partition("_")
        owner = parts.get(part, options)
        name = (rest if part in parts else parameter).removesuffix("_type")
        if not hasattr(owner, name):
            raise ScenarioError(f"{path}: {parameter}: amcl's Python module does not know it")
        setattr(owner, name, models[part].__members__[value] if name == "model" else value)
    return options, (x, y, yaw)
