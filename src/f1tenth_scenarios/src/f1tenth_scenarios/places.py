"""Where scenarios, worlds, maps, goals and results are."""

import functools
import os
from pathlib import Path
from typing import Optional

import rospkg

from f1tenth_scenarios.errors import ScenarioError

PACKAGE = "f1tenth_scenarios"
GAZEBO_PACKAGE = "f1tenth_gazebo"


def package_path(package: str) -> Path:
    """The folder of a ROS package.

    Raises:
        ScenarioError: it is not installed, or the workspace is not sourced.
    """
    try:
        return Path(packages().get_path(package))
    except rospkg.ResourceNotFound as error:
        raise ScenarioError(f"package {package} not found; is the workspace's setup.bash sourced?") from error


@functools.lru_cache(maxsize=1)
def packages() -> rospkg.RosPack:
    """What is known of the installed packages."""
    # It walks through all of ROS_PACKAGE_PATH when it is asked first.
    return rospkg.RosPack()


def scenario_names() -> list[str]:
    """All scenarios of this package."""
    return sorted(path.stem for path in (package_path(PACKAGE) / "scenarios").glob("*.yaml"))


def scenario_file(name: str) -> Path:
    """The file of a scenario, given its name or a path.

    Raises:
        ScenarioError: there is none; the message names those that exist.
    """
    if name.endswith(".yaml"):
        return Path(name).resolve()
    if name not in scenario_names():
        raise ScenarioError(f"no scenario '{name}'; there are: {', '.join(scenario_names())}")
    return package_path(PACKAGE) / "scenarios" / f"{name}.yaml"


def world_file(name: str, beside: Path) -> Path:
    """The file of a world; a path counts from the folder `beside`."""
    return _find(name, beside, "worlds", ".world")


def goals_file(name: str, beside: Path) -> Path:
    """A goals file; a path counts from the folder `beside`."""
    return _find(name, beside, "goals", ".txt")


def course_file(name: str, beside: Path) -> Path:
    """A circuit's YAML file, or a centreline (CSV); a path counts from the folder `beside`."""
    return _find(name, beside, "circuits", ".csv" if name.endswith(".csv") else ".yaml")


def map_file(world: Path) -> Optional[Path]:
    """The map (YAML) of a world; nothing when it has none."""
    for folder in (world.parent, world.parent.parent / "maps"):
        candidate = folder / f"{world.stem}.yaml"
        if candidate.is_file():
            return candidate
    return None


def results_root() -> Path:
    """Where all results go: $F1TENTH_RESULTS, else results in the workspace's root."""
    base = os.environ.get("F1TENTH_RESULTS")
    return (Path(base) if base else workspace_root() / "results").resolve()


def results_folder(name: str) -> Path:
    """Where a scenario's results go: the folder NAME in the results' root."""
    return results_root() / name


def workspace_root() -> Path:
    """The folder that holds the workspace's src; the working directory when this package is installed."""
    for parent in package_path(PACKAGE).parents:
        if parent.name == "src":
            return parent.parent
    return Path.cwd()


def _find(name: str, beside: Path, folder: str, suffix: str) -> Path:
    if "/" in name or name.endswith(suffix):
        path = (beside / name).resolve()
        if not path.is_file():
            raise ScenarioError(f"no such file: {path}")
        return path
    root = package_path(GAZEBO_PACKAGE) / folder
    path = root / f"{name}{suffix}"
    if not path.is_file():
        known = ", ".join(sorted(each.stem for each in root.glob(f"*{suffix}"))) or "none"
        raise ScenarioError(f"no {name}{suffix} under {root}; there are: {known}")
    return path
