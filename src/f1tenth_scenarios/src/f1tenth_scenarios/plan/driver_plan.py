"""The driver of a car, ready to be started: its launch file and what is told to it."""

import dataclasses
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from f1tenth_scenarios import places
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.plan.driver_file import DriverFile, read_driver_file
from f1tenth_scenarios.scenario.car import Car
from f1tenth_scenarios.scenario.driver import Interface

# Keys of a car that only its driver can make something of.
_DRIVER_KEYS = ("line", "speed_max", "acceleration_max", "commands")
# Who has this argument waits for the 0 on /time_to_start; who has the other one is told when that is.
_COUNTDOWN, _START = "time_to_start", "start_at"


@dataclasses.dataclass(frozen=True)
class DriverPlan:
    """A driver whose file has been found and fits what the scenario says."""

    name: str  # for people
    file: DriverFile
    interface: Interface
    arguments: Mapping[str, str]  # given by the scenario

    @property
    def needs_countdown(self) -> bool:
        """Whether it waits for the start signal."""
        return self.takes(_COUNTDOWN)

    @property
    def obeys_start(self) -> bool:
        """Whether it stands still until the start."""
        return self.needs_countdown or self.takes(_START)

    def takes(self, argument: str) -> bool:
        """Whether its launch file has an argument."""
        return argument in self.file.arguments

    def needs(self, argument: str) -> bool:
        """Whether its launch file has an argument without a default."""
        return argument in self.file.required

    def filled(self, offered: Mapping[str, Any]) -> dict[str, Any]:
        """The arguments that it gets: of those offered, what it declares, and what the scenario gives it."""
        wanted = {name: value for name, value in offered.items() if name in self.file.arguments}
        return wanted | dict(self.arguments)


def plan_driver(car: Car, beside: Path) -> DriverPlan:
    """Find the driver of a car and check what the scenario gives it.

    Args:
        car: with its driver
        beside: folder from which paths count

    Raises:
        ScenarioError: there is no such file, or it does not take what it is given.
    """
    file = read_driver_file(places.launch_file(car.driver.launch, beside))
    known = ", ".join(sorted(file.arguments)) or "none"
    for name in car.driver.arguments:
        if name not in file.arguments:
            raise ScenarioError(f"{car.name}: {file.path} has no argument '{name}'; it has: {known}")
    for key in _DRIVER_KEYS:
        if getattr(car, key) and key not in file.arguments:
            raise ScenarioError(f"{car.name}: '{key}' is nothing that the driver '{car.driver.name}' takes")
    return DriverPlan(car.driver.name, file, car.driver.interface, car.driver.arguments)
