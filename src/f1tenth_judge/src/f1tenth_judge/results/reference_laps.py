"""How long the fastest flying lap of each circuit takes, as `scenario reference --laps` has computed it."""

import contextlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple, Optional

import yaml

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places.raceline import read_raceline
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.scenario.scenario import Scenario

_HEAD = "# Fastest flying laps (s); made by: rosrun f1tenth_scenarios scenario reference --laps FILE\n"


def reference_laps_file() -> Path:
    """The file with the laps of the circuits of this workspace."""
    return Path(__file__).with_name("reference_laps.yaml")


def reference_lap(scenario: Scenario) -> Optional[float]:
    """Fastest flying lap of the circuit that a car with its usual tyres races around, s; else nothing."""
    racers = [
        car
        for car in scenario.cars
        if car.laps or (car.driver.name == "race" and car.goals in (None, scenario.world))
    ]
    around = any(car.mu is None for car in racers)
    laps = yaml.safe_load(reference_laps_file().read_text(encoding="utf-8"))
    return laps.get(scenario.world) if around else None


class Reference(NamedTuple):
    """What a lap is compared with."""

    time: float  # s
    what: str  # in words


def reference_of(plan: Plan) -> Optional[Reference]:
    """What laps of a run are compared with; nothing where nobody drives laps of a road."""
    if fastest := reference_lap(plan.scenario):
        return Reference(fastest, "fastest flying lap possible")
    if plan.place.raceline:
        with contextlib.suppress(ScenarioError):  # of a file that cannot be read
            line = read_raceline(plan.place.raceline)
            return Reference(line.lap_time, f"{plan.place.raceline.name} at its speeds")
    if not (plan.course and any(task.laps for task in plan.tasks.values())):
        return None
    # Imported late: scipy takes longer than all else that a command does before a run.
    from f1tenth_judge.reference.car_limits import read_limits
    from f1tenth_judge.reference.middle_lap import middle_lap

    return Reference(
        middle_lap(plan.course, read_limits()), "the middle of the road at the limit of friction"
    )


def quicker_than_reference(scenario: Scenario, laps: Mapping[str, Sequence[float]]) -> str:
    """That a lap (s, by car) was quicker than the reference, in words; empty if none was."""
    fastest = reference_lap(scenario)
    best = min((time for times in laps.values() for time in times), default=None)
    if fastest is None or best is None or best >= fastest:
        return ""
    reference = f"the reference of {fastest:.3f} s, whose tyres are those of friction alone"
    return f"the best lap, {best:.3f} s, is quicker than {reference}"


def reference_laps_text(laps: dict[str, float]) -> str:
    """What the file says."""
    lines = [f"{name}: {lap:.3f}\n" for name, lap in laps.items()]
    return _HEAD + "".join(lines)
