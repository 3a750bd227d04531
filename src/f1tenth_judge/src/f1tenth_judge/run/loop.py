"""The loop of a run without ROS: a period is simulated, its drivers handle it, until the run is decided."""

import time
from collections.abc import Mapping
from typing import Callable, Optional

from f1tenth_judge.errors import writing
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.observations import Failure
from f1tenth_judge.record.pace import Pace
from f1tenth_judge.record.row import COLUMNS
from f1tenth_judge.run.driver import Driver
from f1tenth_judge.run.own_record import OwnRecord
from f1tenth_judge.run.so_far import SoFar
from f1tenth_judge.run.stage import PERIOD, Stage
from f1tenth_judge.stop_request import StopRequest

Progress = Callable[
    [Optional[float], float], None
]  # simulated (s, None before the first period), wall time (s)


class Loop:
    """Simulates a plan with its drivers."""

    def __init__(self, plan: Plan, stage: Stage, stop: StopRequest, progress: Progress):
        self._plan = plan
        self._stage = stage
        self._stop = stop
        self._progress = progress
        self._began = time.monotonic()
        self.pace = Pace()
        self._so_far = SoFar(plan)
        self.record = OwnRecord(plan.record_file)

    def run(self, drivers: Mapping[str, Driver]) -> Optional[Failure]:
        """Return when the run is decided; with a failure if the set-up broke.

        Raises:
            MismatchError: a driver cannot go by simulated time.
            ScenarioError: the record cannot be written.
        """
        with writing(self._plan.record_file), self.record:
            self.record.write([COLUMNS])
            for driver in drivers.values():
                driver.begin()
            return self._drive(drivers)

    def _drive(self, drivers: Mapping[str, Driver]) -> Optional[Failure]:
        due = time.monotonic()
        while True:
            self._stage.advance()
            self._take()
            if self._so_far.is_cut_short() or self._so_far.is_race_over():
                return None
            if not self._plan.scenario.lockstep:
                due = max(due + PERIOD / self._plan.scenario.real_time_factor, time.monotonic() - PERIOD)
                time.sleep(max(0.0, due - time.monotonic()))
            for driver in drivers.values():
                driver.act(self._stage)
            if failure := self._failure(drivers):
                return failure

    def _take(self) -> None:
        """Write down the period that was simulated."""
        rows = self._stage.rows()
        self.record.write(rows)
        for row in rows:
            values = dict(zip(COLUMNS, row))
            place = [values[name] for name in ("x", "y", "yaw")]
            self._so_far.take(self._stage.time, values["car"], place, bool(values["contacts"]))
        elapsed = time.monotonic() - self._began
        self.pace.note(self._stage.time, elapsed)
        self._progress(self._stage.time, elapsed)

    def _failure(self, drivers: Mapping[str, Driver]) -> Optional[Failure]:
        if self._stop.signal:
            return Failure("runner", f"was told to stop by {self._stop.signal.name}")
        limit, now = self._plan.scenario.limits.wall, self._stage.time
        if time.monotonic() - self._began > limit:
            reason = f"not decided after {limit:g} s of wall time (limits.wall), {now:.3f} s simulated"
            return Failure("runner", reason)
        finishes = self._so_far.finishes()
        found = (each.failure(now, finishes.get(car) is not None) for car, each in drivers.items())
        return next(filter(None, found), None)
