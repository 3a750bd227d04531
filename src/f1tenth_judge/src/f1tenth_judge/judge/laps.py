"""When a race began, and how long its laps took."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Optional

from f1tenth_judge.judge.false_start import moves_of, race_start
from f1tenth_judge.judge.goal_passes import GoalPasses
from f1tenth_judge.judge.judge import Judgement
from f1tenth_judge.judge.start_line import times_of_laps
from f1tenth_judge.plan.task import Task
from f1tenth_judge.record.observations import RaceUpdate
from f1tenth_judge.scenario.scenario import Scenario


def start_of_race(
    tasks: Mapping[str, Task], judgement: Judgement, updates: Sequence[RaceUpdate]
) -> Optional[float]:
    """When the race began, s: with the start signal, else when the first car that has a task moved."""
    start = race_start([update for update in updates if update.stamp <= judgement.decision.stamp])
    if start is not None:
        return start
    moves = moves_of(judgement.record).stamps
    return min(
        (moves[car] for car, task in tasks.items() if not task.is_empty and car in moves), default=None
    )


def lap_times(
    scenario: Scenario, tasks: Mapping[str, Task], judgement: Judgement, updates: Sequence[RaceUpdate]
) -> dict[str, list[float]]:
    """Times of the laps that each car completed up to the deciding stamp, s.

    With a start line a lap ends where the car crosses it. Without, a lap is from the start, or the last goal
    of the lap before, to its own last goal, by race_mgr or else by the record. The first lap of a car that
    waits for no start signal begins when it moves.
    """
    known = [update for update in updates if update.stamp <= judgement.decision.stamp]
    signal, moves = race_start(known), moves_of(judgement.record).stamps
    found = {}
    for car, task in tasks.items():
        line = task.line or scenario.start_line
        start = moves.get(car, 0.0) if signal is None or (task.laps and not task.obeys_start) else signal
        if line:
            track = judgement.record.tracks.get(car)
            found[car] = times_of_laps(line, track, start, task.gates) if track else []
        else:
            found[car] = _by_goals(scenario.laps, car, judgement.passes, known, start)
    return found


def _by_goals(
    laps: int, car: str, passes: Mapping[str, GoalPasses], updates: Iterable[RaceUpdate], start: float
) -> list[float]:
    if car not in passes:
        return []
    own = [update for update in updates if update.car == car]
    per_lap = passes[car].wanted // laps
    counts = [per_lap * (lap + 1) for lap in range(laps)]
    ends = (
        [_said(own, count) for count in counts] if own else [_shown(passes[car], count) for count in counts]
    )
    begin = race_start(own) if own else start
    if begin is None:
        return []
    marks = [begin, *(end for end in ends if end is not None)]
    return [later - earlier for earlier, later in zip(marks, marks[1:])]


def _said(updates, count) -> Optional[float]:
    return next((update.stamp for update in updates if update.goals_reached >= count), None)


def _shown(passes: GoalPasses, count: int) -> Optional[float]:
    return passes.times[count - 1] if count <= len(passes.times) else None
