"""What is kept of a run: result.json, trajectory.csv and trajectory.png in the scenario's results folder."""

import csv
import dataclasses
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Optional

from f1tenth_scenarios import criteria
from f1tenth_scenarios.atomic import replacing
from f1tenth_scenarios.criteria import Criterion, Status
from f1tenth_scenarios.judge import Judgement
from f1tenth_scenarios.observations import RaceState, RaceUpdate
from f1tenth_scenarios.record import COLUMNS, Record
from f1tenth_scenarios.scenario import Scenario

RESULT_FILE, TRAJECTORY_FILE, PICTURE_FILE = "result.json", "trajectory.csv", "trajectory.png"


@dataclasses.dataclass(frozen=True)
class Result:
    """A run, judged."""

    name: str
    scenario: Scenario
    judgement: Judgement
    criteria: tuple[Criterion, ...]
    updates: tuple[RaceUpdate, ...] = ()
    wall_time: Optional[float] = None  # s, of everything
    real_time_factor: Optional[float] = None

    @property
    def passed(self) -> bool:
        """Whether the verdict is the expected one and every criterion is met."""
        return all(criterion.status is not Status.FAILED for criterion in self.criteria)

    @property
    def reason(self) -> str:
        """Why the run did not pass, or else what ended it."""
        failed = [criterion for criterion in self.criteria if criterion.status is Status.FAILED]
        return failed[0].reason if failed else self.judgement.decision.reason

    def start(self, car: str) -> Optional[float]:
        """When the car's race was started, s; nothing when it never was."""
        return next(
            (update.stamp for update in self._seen(car) if update.state is not RaceState.WAITING), None
        )

    def lap_times(self, car: str) -> list[float]:
        """Times of the laps that the car completed, s.

        A lap is from the start, or the last goal of the lap before, to its own last goal, by race_mgr.
        """
        passes = self.judgement.passes.get(car)
        start = self.start(car)
        if passes is None or start is None:
            return []
        per_lap = passes.wanted // self.scenario.laps
        ends = [self._reached(car, per_lap * (lap + 1)) for lap in range(self.scenario.laps)]
        marks = [start, *(end for end in ends if end is not None)]
        return [later - earlier for earlier, later in zip(marks, marks[1:])]

    @property
    def best_lap_time(self) -> Optional[float]:
        """The fastest lap of any car, s; nothing when none was completed."""
        return min((time for car in self.scenario.cars for time in self.lap_times(car.name)), default=None)

    def _reached(self, car, count):
        return next((update.stamp for update in self._seen(car) if update.goals_reached >= count), None)

    def _seen(self, car):
        deciding = self.judgement.decision.stamp
        return [update for update in self.updates if update.car == car and update.stamp <= deciding]


def as_dict(result: Result, versions: Mapping[str, Optional[str]]) -> dict[str, Any]:
    """The content of result.json."""
    decision, record = result.judgement.decision, result.judgement.record
    laps = {car.name: result.lap_times(car.name) for car in result.scenario.cars}
    starts = [start for start in map(result.start, laps) if start is not None]
    return {
        "scenario": result.name,
        "description": result.scenario.description,
        "world": result.scenario.world,
        "verdict": decision.verdict.value,
        "expected": result.scenario.expected.value,
        "passed": result.passed,
        "reason": result.reason,
        "culprit": dataclasses.asdict(result.judgement.failure) if result.judgement.failure else None,
        "criteria": [{**dataclasses.asdict(each), "status": each.status.value} for each in result.criteria],
        "times": {
            "start": min(starts, default=None),
            "finish": _stamp(decision.stamp),
            "lap_time": _stamp(result.best_lap_time),
            "wall": _stamp(result.wall_time),
        },
        "cars": {
            car: {
                "lap_times": [_stamp(time) for time in times],
                "goals_passed": list(passed.times) if (passed := result.judgement.passes.get(car)) else [],
            }
            for car, times in laps.items()
        },
        "minimum_clearance": criteria.minimum_clearance(result.judgement),
        "contacts": [
            dataclasses.asdict(contact)
            for track in record.tracks.values()
            for contact in track.contact_list()
        ],
        "real_time_factor": result.real_time_factor,
        "seed": result.scenario.seed,
        "trajectory_hash": record.hash_at_end(),
        "versions": dict(versions),
    }


def write_json(path: Path, content: Mapping[str, Any]) -> None:
    """Write a JSON file, which replaces the old one when it is complete."""
    with replacing(path) as temporary:
        temporary.write_text(json.dumps(content, indent=2, allow_nan=False) + "\n", encoding="utf-8")


def write_trajectory(path: Path, record: Record) -> None:
    """Write the record up to the deciding stamp, in the simulator's columns."""
    rows: Sequence = sorted(
        (row for track in record.tracks.values() for row in track.rows), key=lambda row: float(row[0])
    )
    with replacing(path) as temporary, open(temporary, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(rows)


def _stamp(value: Optional[float]) -> Optional[float]:
    """Seconds without the noise of binary fractions."""
    return None if value is None else round(value, 9)
