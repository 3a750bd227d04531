"""Laps driven by the planner, as a scenario."""

import dataclasses
import json
import subprocess
from pathlib import Path

import yaml

from f1tenth_scenarios.errors import ScenarioError

_LAP_TIMEOUT = 60.0  # s, simulated
_WALL_TIMEOUT = 3600.0  # s
_SEED = 1


@dataclasses.dataclass(frozen=True)
class Laps:
    """What came of a run."""

    circuit: str
    success: bool
    reason: str
    flying: tuple[float, ...]  # s, without the lap from the standing start
    clearance: float  # m, least of all laps
    contacts: int


def drive(circuit: str, count: int, folder: Path) -> Laps:
    """Drive a lap from the standing start and then flying laps, with perfect odometry in lockstep.

    Args:
        circuit: of f1tenth_gazebo
        count: of flying laps
        folder: for the scenario file and its results

    Raises:
        ScenarioError: the run came to no result, or the folder cannot be written.
    """
    return read_laps(circuit, run(f"race_pace_{circuit}", describe(circuit, count), folder))


def run(name: str, description: dict, folder: Path) -> dict:
    """Run a scenario that is in no file yet.

    Args:
        name: of the scenario
        description: what its file is to say
        folder: for the scenario file and its results

    Returns:
        the content of its result.json

    Raises:
        ScenarioError: the run came to no result, or the folder cannot be written.
    """
    scenario = folder / f"{name}.yaml"
    result = folder / name / "result.json"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        result.unlink(missing_ok=True)
        scenario.write_text(yaml.safe_dump(description, sort_keys=False), encoding="utf-8")
    except OSError as error:
        raise ScenarioError(f"{scenario}: cannot be written: {error.strerror}") from error
    command = ["rosrun", "f1tenth_scenarios", "scenario", "run", str(scenario), "--results", str(folder)]
    code = subprocess.run(command, check=False).returncode
    if not result.is_file():
        raise ScenarioError(f"{name}: no result; `{' '.join(command)}` ended with exit code {code}")
    return json.loads(result.read_text(encoding="utf-8"))


def describe(circuit: str, count: int) -> dict:
    """The scenario of a standing and some flying laps."""
    return {
        "description": f"A lap from the standing start and {count} flying laps of {circuit}.",
        "world": circuit,
        "cars": [{"name": "robot1", "goals": circuit}],
        "laps": count + 1,
        "limits": {"timeout": _LAP_TIMEOUT * (count + 1), "wall": _WALL_TIMEOUT},
        "expected": "success",
        "seed": _SEED,
    }


def read_laps(circuit: str, result: dict) -> Laps:
    """The laps of a scenario's result.json."""
    return Laps(
        circuit=circuit,
        success=result["verdict"] == "success",
        reason=result["reason"],
        flying=tuple(result["cars"]["robot1"]["lap_times"][1:]),
        clearance=result["minimum_clearance"] or 0.0,
        contacts=len(result["contacts"]),
    )
