"""A judged run, and what is kept of it: the content of result.json, and trajectory.csv."""

import csv
import dataclasses
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.atomic import replacing
from f1tenth_judge.judge.criterion import Criterion, Measured, Status
from f1tenth_judge.judge.driving_criteria import least_clearance
from f1tenth_judge.judge.judge import Judgement
from f1tenth_judge.plan.pins import machine
from f1tenth_judge.record.record import Record
from f1tenth_judge.record.replay import Replay
from f1tenth_judge.record.row import COLUMNS
from f1tenth_judge.results.standing import Winner, who, winner_of
from f1tenth_judge.scenario.scenario import Scenario


@dataclasses.dataclass(frozen=True)
class Result:
    """A run, judged."""

    name: str
    scenario: Scenario
    judgement: Judgement
    criteria: tuple[Criterion, ...]
    measured: Measured = Measured()
    folder: Path = Path()  # of the results
    wall_time: Optional[float] = None  # s, of everything, from the start of the command
    not_written: tuple[str, ...] = ()  # files of the results, each with the reason
    inputs: Optional[Mapping[str, Any]] = None  # what was simulated, as hashes; None if it never began
    is_repeatable: bool = True  # whether nothing happened in lockstep that depends on wall time
    note: str = ""  # why the run differed from what the scenario asks for
    published: Replay = Replay()  # what planners said on topics of their own

    @property
    def cost(self) -> Optional[float]:
        """What the run took besides simulating, wall s: starting, judging, writing, ending."""
        if self.wall_time is None:
            return None
        factor = self.measured.real_time_factor
        return self.wall_time - (self.judgement.decision.stamp / factor if factor else 0.0)

    @property
    def passed(self) -> bool:
        """Whether the verdict is the expected one and every criterion is met."""
        return all(criterion.status is not Status.FAILED for criterion in self.criteria)

    @property
    def reason(self) -> str:
        """Why the run did not pass, or else what ended it."""
        failed = [criterion for criterion in self.criteria if criterion.status is Status.FAILED]
        return failed[0].reason if failed else self.judgement.decision.reason

    def lap_times(self, car: str) -> Sequence[float]:
        """Times of the laps that the car completed, s."""
        return self.measured.lap_times.get(car, ())

    @property
    def winner(self) -> Optional[Winner]:
        """Who won a race; nothing where only one car had a task, or none was done with it."""
        return winner_of(self.measured.finishes)

    @property
    def best_lap_time(self) -> Optional[float]:
        """The fastest lap of any car, s; None if none was completed."""
        return min((time for times in self.measured.lap_times.values() for time in times), default=None)


def as_dict(result: Result, versions: Mapping[str, Any], settings: Sequence[str] = ()) -> dict[str, Any]:
    """The content of result.json."""
    decision, record = result.judgement.decision, result.judgement.record
    return {
        "scenario": result.name,
        "description": result.scenario.description,
        "world": result.scenario.world,
        "verdict": decision.verdict.value,
        "expected": result.scenario.expected.value,
        "passed": result.passed,
        "reason": result.reason,
        "culprit": _culprit(result),
        "criteria": [{**dataclasses.asdict(each), "status": each.status.value} for each in result.criteria],
        "times": {
            "start": _stamp(result.measured.start),
            "finish": _stamp(decision.stamp),
            "lap_time": _stamp(result.best_lap_time),
            "wall": _stamp(result.wall_time),
            "cost": _stamp(result.cost),
        },
        "cars": {car.name: {**who(car), **_achieved(result, car.name)} for car in result.scenario.cars},
        "winner": dataclasses.asdict(result.winner) if result.winner else None,
        "minimum_clearance": least_clearance(result.judgement),
        "off_road": [dataclasses.asdict(each) for each in result.measured.excursions or ()],
        "interventions": [each.as_json() for each in result.judgement.interventions],
        "contacts": [dataclasses.asdict(contact) for contact in result.judgement.contacts],
        "real_time_factor": result.measured.real_time_factor,
        "seed": result.scenario.seed,
        "judged": result.inputs,
        "settings": list(settings),
        "lockstep": result.scenario.lockstep,
        "repeatable": result.scenario.lockstep and result.is_repeatable,
        "machine": machine(result.scenario),
        "note": result.note,
        "trajectory_hash": record.hash_at_end(),
        "versions": dict(versions),
        "not_written": list(result.not_written),
    }


def _achieved(result: Result, car: str) -> dict[str, Any]:
    passes = result.judgement.passes.get(car)
    return {
        "lap_times": [_stamp(time) for time in result.lap_times(car)],
        "goals_passed": list(passes.times) if passes else [],
        "finish": _stamp(result.measured.finishes.get(car)),
        "channels": {
            topic: {"least": min(each.values), "greatest": max(each.values), "last": each.values[-1]}
            for topic, each in result.published.until(result.judgement.decision.stamp).channels.items()
            if each.car == car and each.values
        },
    }


def _culprit(result: Result) -> Optional[dict[str, Any]]:
    """Who broke the set-up; the log's path is relative to the folder of the results."""
    failure = result.judgement.failure
    if failure is None:
        return None
    log_file = os.path.relpath(failure.log_file, result.folder) if failure.log_file else None
    return {**dataclasses.asdict(failure), "log_file": log_file}


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
