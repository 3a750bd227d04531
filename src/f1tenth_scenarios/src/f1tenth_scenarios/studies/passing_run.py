"""Laps past a slower car, as a scenario."""

import dataclasses
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.places import GAZEBO_PACKAGE, package_path
from f1tenth_scenarios.record.record import CarTrack, read_record
from f1tenth_scenarios.scenario.course import Course, read_course
from f1tenth_scenarios.studies.race_pace.laps import run

# A car that drives no faster than this is clearly slower, and must be passed; m/s.
CLEARLY_SLOWER = 1.5

_LAP_TIMEOUT = 60.0  # s, simulated
_WALL_TIMEOUT = 1800.0  # s
_SPACING = 0.1  # m, between the places on a course that are told apart
_START = 2.5  # m, of the other car before the one that races


@dataclasses.dataclass(frozen=True)
class Run:
    """What came of some laps."""

    speed: float  # m/s, of the other car
    success: bool
    reason: str
    lap_times: tuple[float, ...]  # s
    passes: int  # how often the car that races got past the other
    clearance: float  # m, least, of the car that races
    contacts: int

    def problem(self) -> str:
        """Why it is not good enough; empty when it is."""
        if not self.success:
            return self.reason
        if self.contacts:
            return f"{self.contacts} contacts, must be none"
        if self.speed <= CLEARLY_SLOWER and not self.passes:
            return "the slower car was not passed"
        return ""


def drive(circuit: str, speed: float, laps: int, folder: Path) -> Run:
    """Drive laps in lockstep behind and past a car that keeps to the middle of the road.

    Raises:
        ScenarioError: the run came to no result, or the folder cannot be written.
    """
    name = f"passing_{circuit}_{speed:g}"
    result = run(name, describe(circuit, speed, laps), folder)
    tracks = read_record(folder / name / "trajectory.csv").tracks
    course = read_course(package_path(GAZEBO_PACKAGE) / "circuits" / f"{circuit}.yaml")
    if not {"robot1", "robot2"} <= tracks.keys():
        raise ScenarioError(f"{name}: trajectory.csv does not tell of both cars")
    return Run(
        speed=speed,
        success=result["verdict"] == "success",
        reason=result["reason"],
        lap_times=tuple(result["cars"]["robot1"]["lap_times"]),
        passes=count_passes(course, tracks["robot1"], tracks["robot2"]),
        clearance=float(tracks["robot1"].clearance.min()),
        contacts=len(result["contacts"]),
    )


def describe(circuit: str, speed: float, laps: int) -> dict:
    """The scenario of some laps."""
    return {
        "description": f"{laps} laps of {circuit} past a car that drives {speed:g} m/s.",
        "world": circuit,
        "cars": [
            {"name": "robot1", "goals": circuit},
            {
                "name": "robot2",
                "start": {"x": _START, "y": 0.0},
                "driver": "pursuit",
                "line": circuit,
                "speed_max": speed,
            },
        ],
        "laps": laps,
        "limits": {"timeout": _LAP_TIMEOUT * laps, "wall": _WALL_TIMEOUT},
        "expected": "success",
        "seed": 1,
    }


def count_passes(course: Course, behind: CarTrack, ahead: CarTrack) -> int:
    """How often the car that starts behind gets past the one ahead, the second and further laps included."""
    periods = min(len(behind.x), len(ahead.x))
    total = _lengths(course)[-1]
    own = _progress(course, behind.x[:periods], behind.y[:periods])
    lead = own - _progress(course, ahead.x[:periods], ahead.y[:periods])
    # The course may be described in the other direction.
    lead *= 1.0 if own[-1] >= own[0] else -1.0
    # At the start the one ahead may be on either side of where the course begins.
    lead -= total * np.ceil(lead[0] / total)
    return int(np.floor(lead.max() / total)) + 1


def _progress(course: Course, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Way along the course, m, that goes on from lap to lap."""
    lengths = _lengths(course)
    places = np.arange(0.0, lengths[-1], _SPACING)
    line_x = np.interp(places, lengths, np.append(course.x, course.x[0]))
    line_y = np.interp(places, lengths, np.append(course.y, course.y[0]))
    nearest = [int(np.argmin(np.hypot(line_x - px, line_y - py))) for px, py in zip(x, y)]
    return np.unwrap(places[nearest], period=lengths[-1])


def _lengths(course: Course) -> np.ndarray:
    """Of the course up to each vertex, and once around, m."""
    steps: Sequence[float] = np.hypot(np.roll(course.x, -1) - course.x, np.roll(course.y, -1) - course.y)
    return np.concatenate([[0.0], np.cumsum(steps)])
