"""What is known of a run while it goes on, and whether that decides it."""

from collections.abc import Mapping, Sequence
from typing import Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.judge.false_start import FirstMoves, find_false_start
from f1tenth_judge.judge.judge import first_collision, is_decided
from f1tenth_judge.judge.progress import TaskProgress
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.observations import RaceUpdate
from f1tenth_judge.record.record import read_record


class SoFar:
    """Follows the rows of a record: cheap enough to be asked many times a second."""

    def __init__(self, plan: Plan):
        """The whole record of the plan is read after new contacts only."""
        self._plan = plan
        self._progress = {car: TaskProgress(task, plan.scenario.criteria) for car, task in plan.tasks.items()}
        self._touches_judged = 0
        self._moves = FirstMoves()
        self.time: Optional[float] = None  # s, of the last period
        self.touches = 0  # rows with a contact

    def take(self, time: float, car: str, place: Sequence[float], touches: bool) -> None:
        """The next row: `place` is x, y (m) and yaw (rad)."""
        self.time = time
        self.touches += touches
        self._moves.take(time, car, *place[:2])
        if car in self._progress:
            self._progress[car].take(time, *place)

    def finishes(self) -> Mapping[str, Optional[float]]:
        """When each car was done with its task, s; None for those that are not."""
        return {car: progress.finish for car, progress in self._progress.items()}

    def is_cut_short(self, updates: Sequence[RaceUpdate] = ()) -> bool:
        """Whether a collision, a false start or the timeout has ended it; `updates`: what cars have said."""
        plan, time = self._plan, self.time
        return (
            self._has_collided()
            or find_false_start(plan.scenario, plan.tasks, self._moves, updates) is not None
            or (time is not None and time >= plan.scenario.limits.timeout)
        )

    def is_race_over(self, updates: Sequence[RaceUpdate] = ()) -> bool:
        """Whether every task is done, or a car gave up."""
        return is_decided(self._plan.tasks, updates, self.finishes())

    def _has_collided(self) -> bool:
        """Whether a car has touched something, and not lightly."""
        if self.touches == self._touches_judged:
            return False
        self._touches_judged = self.touches
        scenario, record_file = self._plan.scenario, self._plan.record_file
        if scenario.criteria.light_touch == 0:
            return True
        try:
            return first_collision(scenario, read_record(record_file)) is not None
        except ScenarioError:
            return True  # somebody has damaged it, which is told when the run has ended
