"""A run that is over, as a test looks at it."""

import dataclasses
import functools
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from f1tenth_judge.record.files import PICTURE_FILE, TRAJECTORY_FILE
from f1tenth_judge.record.record import CarTrack, read_record
from f1tenth_judge.results.moment import address_of, moment_of

# Columns of a trajectory, one row per control period (25 ms), up to what decided the run.
COLUMNS = {
    "time": "s, simulated",
    "x": "m, in the frame of the map",
    "y": "m, in the frame of the map",
    "yaw": "rad, in the frame of the map",
    "v_x": "m/s, ahead",
    "v_y": "m/s, to the left",
    "speed": "m/s, of both",
    "yaw_rate": "rad/s",
    "steering_angle": "rad, to the left",
    "steering_rate": "rad/s, since the period before",
    "clearance": "m, to the nearest thing; 5 where nothing is nearer",
    "contact_speed": "m/s, of the touching points against each other; 0 without contact",
}


@dataclasses.dataclass(frozen=True)
class Run:
    """A judged run. What is said of a car is said of the first one; `of` gives the same of another."""

    folder: Path  # of the results
    result: Mapping[str, Any]  # what result.json says
    car: str

    def of(self, car: str) -> "Run":
        """The same run, as another car saw it.

        Raises:
            KeyError: there is no such car.
        """
        if car not in self.result["cars"]:
            raise KeyError(f"no car '{car}'; there are: {', '.join(self.result['cars'])}")
        return Run(self.folder, self.result, car)

    @property
    def verdict(self) -> str:
        """`success`, `collision`, `timeout`, `aborted`, `disqualified` or `error`."""
        return self.result["verdict"]

    @property
    def passed(self) -> bool:
        """Whether the verdict is the expected one and every criterion is met."""
        return self.result["passed"]

    @property
    def reason(self) -> str:
        """Why it did not pass, or else what ended it."""
        return self.result["reason"]

    @property
    def lap_times(self) -> Sequence[float]:
        """Times of the laps that the car completed, s."""
        return self.result["cars"][self.car]["lap_times"]

    @property
    def contacts(self) -> Sequence[Mapping[str, Any]]:
        """What the car touched: `start`, `end` (s), `touched` (names), `x`, `y` (m), `speed` (m/s)."""
        return [each for each in self.result["contacts"] if each["car"] == self.car]

    @property
    def interventions(self) -> Sequence[Mapping[str, Any]]:
        """What somebody did to the running simulation."""
        return self.result["interventions"]

    @property
    def picture(self) -> Path:
        """The trajectory over the map."""
        return self.folder / PICTURE_FILE

    @property
    def report(self) -> str:
        """Where the report, once it is written, shows the run; if it did not pass, what went wrong."""
        contacts = (each["start"] for each in self.result["contacts"])
        moment = 0.0 if self.passed else moment_of(contacts, self.result["times"]["finish"])
        return address_of(self.folder, self.result["scenario"], moment)

    @functools.cached_property
    def trajectory(self) -> np.ndarray:
        """What the simulator recorded of the car, a structured array with the fields of COLUMNS."""
        return as_table(read_record(self.folder / TRAJECTORY_FILE).tracks[self.car])

    def __str__(self) -> str:
        lines = {
            "verdict": self.verdict,
            "reason": self.reason,
            "picture": self.picture,
            "report": self.report,
        }
        return "\n".join(f"{name + ':':9}{value}" for name, value in lines.items())


def as_table(track: CarTrack) -> np.ndarray:
    """A track as a structured array with the fields of COLUMNS."""
    table = np.zeros(len(track.time), [(name, float) for name in COLUMNS])
    for name in COLUMNS:
        table[name] = _steering_rate(track) if name == "steering_rate" else getattr(track, name)
    return table


def _steering_rate(track: CarTrack) -> np.ndarray:
    if len(track.time) < 2:
        return np.zeros(len(track.time))
    rate = np.diff(track.steering_angle) / np.diff(track.time)
    return np.concatenate([rate[:1] * 0.0, rate])
