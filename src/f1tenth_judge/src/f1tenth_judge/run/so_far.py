"""What is known of a run while it goes on, and whether that decides it."""

from collections.abc import Mapping, Sequence
from typing import Callable, Optional

from f1tenth_judge.judge.false_start import FirstMoves, find_false_start
from f1tenth_judge.judge.judge import first_collision, is_decided
from f1tenth_judge.judge.progress import TaskProgress
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.observations import RaceUpdate
from f1tenth_judge.record.record import Record


class SoFar:
    """Follows the rows of a record."""

    def __init__(self, plan: Plan, record: Callable[[], Record]):
        """`record` gives all rows so far: it is asked for after new contacts only."""
        self._plan = plan
        self._record = record
        self._progress = {car: TaskProgress(task, plan.scenario.criteria) for car, task in plan.tasks.items()}
        self._touches = self._touches_judged = 0
        self._moves = FirstMoves()
        self.time: Optional[float] = None  # s, of the last period

    def take(self, time: float, car: str, place: Sequence[float], touches: bool) -> None:
        """The next row: `place` is x, y (m) and yaw (rad)."""
        self.time = time
        self._touches += touches
        self._moves.take(time, car, *place[:2])
        if car in self._progress:
            self._progress[car].take(time, *place)

    def finishes(self) -> Mapping[str, Optional[float]]:
        """When each car was done with its task, s; None for those that are not."""
        return {car: progress.finish for car, progress in self._progress.items()}

    def is_decided(self, updates: Sequence[RaceUpdate] = ()) -> bool:
        """Whether the run is over; `updates`: what cars have said of themselves."""
        plan, time = self._plan, self.time
        return (
            self._has_collided()
            or find_false_start(plan.scenario, plan.tasks, self._moves, updates) is not None
            or (time is not None and time >= plan.scenario.limits.timeout)
            or is_decided(plan.tasks, updates, self.finishes())
        )

    def _has_collided(self) -> bool:
        """Whether a car has touched something, and not lightly."""
        if self._touches == self._touches_judged:
            return False
        self._touches_judged = self._touches
        scenario = self._plan.scenario
        return scenario.criteria.light_touch == 0 or first_collision(scenario, self._record()) is not None
