"""Parameter files of the workspace: of the simulator's car, and of the planner."""

from pathlib import Path

import yaml
from f1tenth_scenarios.errors import ScenarioError

from f1tenth_scenarios import places


class Parameters(dict):
    """Values of a file; a missing one raises a ScenarioError."""

    def __init__(self, path: Path, values: dict):
        super().__init__(values)
        self._path = path

    def __missing__(self, name: str):
        raise ScenarioError(f"{self._path}: {name} is missing")


def read_parameters(package: str, name: str) -> Parameters:
    """The parameters in a package's folder `config`.

    Raises:
        ScenarioError: the file cannot be read.
    """
    path = places.package_path(package) / "config" / name
    try:
        return Parameters(path, yaml.safe_load(path.read_text(encoding="utf-8")))
    except OSError as error:
        raise ScenarioError(f"{path}: cannot be read: {error.strerror}") from error


def read_planner_limits() -> Parameters:
    """The limits that f1tenth_navigation gives the planner for driving the car."""
    return read_parameters("f1tenth_navigation", "teb_local_planner.yaml")
