"""How long the fastest flying lap of each circuit takes, as `scenario reference --laps` has computed it."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Optional

import yaml

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
