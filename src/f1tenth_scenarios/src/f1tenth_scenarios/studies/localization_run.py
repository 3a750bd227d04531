"""Laps driven with wheel odometry and amcl, as a scenario."""

import dataclasses
import math
from pathlib import Path
from typing import Optional

from f1tenth_scenarios.studies.race_pace.laps import run

# Wanted.
GREATEST_ERROR = 0.10  # m, RMS
GREATEST_YAW_ERROR = math.radians(3.0)  # rad, RMS

_LAP_TIMEOUT = 60.0  # s, simulated
_WALL_TIMEOUT = 1800.0  # s


@dataclasses.dataclass(frozen=True)
class Run:
    """What came of some laps."""

    success: bool
    reason: str
    lap_times: tuple[float, ...]  # s
    error: float  # m, RMS; infinite if amcl said nothing
    yaw_error: float  # rad, RMS
    clearance: float  # m, least
    contacts: int

    def problem(self) -> str:
        """Why it is not good enough; empty when it is."""
        if not self.success:
            return self.reason
        if self.contacts:
            return f"{self.contacts} contacts, must be none"
        if self.error > GREATEST_ERROR:
            return f"error {self.error:.3f} m, must be at most {GREATEST_ERROR:g} m"
        if self.yaw_error > GREATEST_YAW_ERROR:
            degrees, limit = math.degrees(self.yaw_error), math.degrees(GREATEST_YAW_ERROR)
            return f"error {degrees:.2f} degrees, must be at most {limit:g} degrees"
        return ""


def drive(circuit: str, laps: int, seed: int, folder: Path) -> Run:
    """Drive laps in lockstep.

    Raises:
        ScenarioError: the run came to no result, or the folder cannot be written.
    """
    return read_run(run(f"localization_{circuit}_{seed}", describe(circuit, laps, seed), folder))


def describe(circuit: str, laps: int, seed: int) -> dict:
    """The scenario of some laps."""
    return {
        "description": f"{laps} laps of {circuit} with wheel odometry and amcl.",
        "world": circuit,
        "cars": [{"name": "robot1", "goals": circuit}],
        "localization": "amcl",
        "laps": laps,
        "limits": {"timeout": _LAP_TIMEOUT * laps, "wall": _WALL_TIMEOUT},
        "expected": "success",
        "seed": seed,
        "criteria": {"localization_error": GREATEST_ERROR, "localization_yaw_error": GREATEST_YAW_ERROR},
    }


def read_run(result: dict) -> Run:
    """The laps of a scenario's result.json."""
    actual = {each["name"]: each["actual"] for each in result["criteria"]}
    return Run(
        success=result["verdict"] == "success",
        reason=result["reason"],
        lap_times=tuple(result["cars"]["robot1"]["lap_times"]),
        error=_known(actual["localization_error"]),
        yaw_error=_known(actual["localization_yaw_error"]),
        clearance=result["minimum_clearance"] or 0.0,
        contacts=len(result["contacts"]),
    )


def _known(actual: Optional[float]) -> float:
    return math.inf if actual is None else actual
