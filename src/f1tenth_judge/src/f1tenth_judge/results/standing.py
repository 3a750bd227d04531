"""Who drove, and who won."""

import dataclasses
from collections.abc import Mapping
from typing import Any, Optional

from f1tenth_judge.scenario.car import Car


@dataclasses.dataclass(frozen=True)
class Winner:
    """The first of a race, and the one behind it."""

    car: str
    second: str
    ahead: Optional[float]  # s, between the two; nothing where the second did not finish


def winner_of(finishes: Mapping[str, Optional[float]]) -> Optional[Winner]:
    """The winner, by when each car was done with its task (s); nothing without a race, or in a tie."""
    done = sorted((stamp, car) for car, stamp in finishes.items() if stamp is not None)
    behind = [*done[1:], *((None, car) for car, stamp in finishes.items() if stamp is None)]
    if not done or not behind or behind[0][0] == done[0][0]:
        return None
    (first, car), (stamp, second) = done[0], behind[0]
    return Winner(car, second, None if stamp is None else round(stamp - first, 9))


def who(car: Car) -> dict[str, str]:
    """The planner of a car, what kind of driver that is, and which car it drives."""
    return {
        "planner": car.driver.name,
        "driver": car.driver.kind,
        "description": car.description or "the F1/10 car",
    }


def name_of(car: Car) -> str:
    """A car with its planner, as a line says it: without the folders of files."""
    return f"{car.name} ({car.driver.short_name})"


def planner_text(result: Mapping[str, Any], car: str) -> str:
    """Who drove a car, as result.json says it: its planner without the folders, its kind and its commit."""
    about = result["cars"][car]
    commit = result["versions"]["driver_commits"].get(car)
    return f"{about['planner'].rpartition('/')[2]} ({about['driver']}{f', {commit}' if commit else ''})"
