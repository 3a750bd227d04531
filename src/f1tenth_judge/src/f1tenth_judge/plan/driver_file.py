"""A driver's launch file: which arguments it takes, and how it takes part in lockstep."""

import dataclasses
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.scenario.car import Car
from f1tenth_judge.scenario.driver import Driver

# Its value, separated by blanks, names nodes that take part in lockstep; for others a proxy driver does so.
_PARTICIPANTS = "participants"
# A driver with this argument waits for the 0 on /time_to_start; with the other it is told when that is.
_COUNTDOWN, _START = "time_to_start", "start_at"
# Keys of a car that only its driver can use.
_DRIVER_KEYS = ("line", "speed_max", "acceleration_max", "commands")


@dataclasses.dataclass(frozen=True)
class DriverFile:
    """What is known of a driver before it is started."""

    path: Path  # of a launch file; the folder in which a command is started
    arguments: frozenset[str]  # that may be given
    required: frozenset[str]  # that must be given
    participants: Optional[str] = None  # of lockstep, with $(arg car_name) in it

    @property
    def folder(self) -> Path:
        """Where the driver is."""
        return self.path if self.path.is_dir() else self.path.parent

    @property
    def needs_countdown(self) -> bool:
        """Whether the driver waits for the start signal."""
        return _COUNTDOWN in self.arguments

    @property
    def obeys_start(self) -> bool:
        """Whether the driver stands still until the start."""
        return self.needs_countdown or _START in self.arguments

    def participants_of(self, car: str) -> Optional[list[str]]:
        """Names as in docs/lockstep.md, for a car of this name; None when the file names none."""
        if self.participants is None:
            return None
        return re.sub(r"\$\(arg car_name\)", car, self.participants).split()


def find_driver(car: Car, beside: Path) -> DriverFile:
    """Find the driver of a car, its path from `beside`, and check what the scenario gives it.

    Raises:
        ScenarioError: there is no such file, or it does not take what it is given.
    """
    file = driver_file(car.driver, beside)
    known = ", ".join(sorted(file.arguments)) or "none"
    for name in car.driver.arguments:
        if car.driver.launch and name not in file.arguments:
            raise ScenarioError(f"{car.name}: {file.path} has no argument '{name}'; it has: {known}")
    for key in _DRIVER_KEYS:
        if getattr(car, key) and key not in file.arguments:
            raise ScenarioError(f"{car.name}: '{key}' is nothing that the driver '{car.driver.name}' takes")
    return file


def driver_file(driver: Driver, beside: Path) -> DriverFile:
    """What is known of a driver, its path from `beside`: nothing of a command; a class is told everything.

    Raises:
        ScenarioError: there is no such launch file, or file of a class.
    """
    if driver.ros2:
        return DriverFile(beside, frozenset(), frozenset())
    if driver.python:
        file = lookup.file_at(driver.python.rpartition(":")[0], beside)
        return DriverFile(file, frozenset(_DRIVER_KEYS), frozenset())
    return read_driver_file(lookup.file_at(driver.launch, beside))


def read_driver_file(path: Path) -> DriverFile:
    """Read what a launch file says of its arguments.

    Raises:
        ScenarioError: it cannot be read, or is no launch file.
    """
    try:
        root = ElementTree.parse(path).getroot()
    except (OSError, ElementTree.ParseError) as error:
        raise ScenarioError(f"{path}: not a launch file: {error}") from error
    if root.tag != "launch":
        raise ScenarioError(f"{path}: not a launch file: it begins with <{root.tag}>, must be <launch>")
    declared = {tag.get("name", ""): tag.attrib for tag in root.findall("arg")}
    open_ones = {name: attributes for name, attributes in declared.items() if "value" not in attributes}
    return DriverFile(
        path,
        frozenset(open_ones),
        frozenset(name for name, attributes in open_ones.items() if "default" not in attributes),
        declared.get(_PARTICIPANTS, {}).get("value", "").strip() or None,
    )
