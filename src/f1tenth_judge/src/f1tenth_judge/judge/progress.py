"""How far a car has got with its task, period by period: by where it was, whatever a planner says."""

from typing import Optional

import numpy as np

from f1tenth_judge.judge.goal_passes import GoalPasses, find_passes
from f1tenth_judge.judge.start_line import LapCounter, times_of_laps
from f1tenth_judge.plan.task import Task
from f1tenth_judge.record.record import CarTrack
from f1tenth_judge.scenario.criteria import Criteria


class TaskProgress:
    """Follows one car."""

    def __init__(self, task: Task, criteria: Criteria):
        self._task = task
        self._laps = LapCounter(task.line, 0.0, task.gates) if task.line else None
        self._goals = GoalPasses(task.goals, criteria.goal_tolerance, criteria.goal_yaw_tolerance)
        self.finish: Optional[float] = None  # s, of the period in which the task was done

    def take(self, time: float, x: float, y: float, yaw: float) -> None:
        """Where the car was in a period (s, m, rad); in order of time."""
        if self.finish is None and self._is_done_at(time, x, y, yaw):
            self.finish = time

    def _is_done_at(self, time, x, y, yaw) -> bool:
        if self._laps:
            self._laps.update(time, x, y)
            return len(self._laps.lap_times) >= self._task.laps
        self._goals.update(time, x, y, yaw)
        return bool(self._task.goals) and self._goals.complete


def how_far(track: CarTrack, task: Task, criteria: Criteria) -> str:
    """How far a car has driven and got with its task where its track ends, in words."""
    way = float(np.hypot(np.diff(track.x), np.diff(track.y)).sum())
    if task.line:
        done = f"{len(times_of_laps(task.line, track, 0.0, task.gates))} of {task.laps} laps"
    else:
        passed = find_passes(track, task.goals, criteria.goal_tolerance, criteria.goal_yaw_tolerance)
        done = f"{len(passed.times)} of {passed.wanted} goals"
    return f"{track.car} drove {way:.1f} m, {done}"


def finish_of(track: CarTrack, task: Task, criteria: Criteria) -> Optional[float]:
    """When the record shows that the task was done, s; nothing if it does not."""
    progress = TaskProgress(task, criteria)
    for place in track.places():
        progress.take(*place)
    return progress.finish
