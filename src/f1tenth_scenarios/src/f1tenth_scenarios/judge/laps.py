"""When a race began, and how long its laps took."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Optional

from f1tenth_scenarios.judge.false_start import race_start
from f1tenth_scenarios.judge.goal_passes import GoalPasses
from f1tenth_scenarios.judge.judge import Judgement
from f1tenth_scenarios.judge.start_line import LapCounter
from f1tenth_scenarios.record.observations import RaceUpdate
from f1tenth_scenarios.record.record import CarTrack
from f1tenth_scenarios.scenario.scenario import Scenario, StartLine


def lap_times(
    scenario: Scenario, judgement: Judgement, updates: Sequence[RaceUpdate]
) -> dict[str, list[float]]:
    """Times of the laps that each car completed up to the deciding stamp, s.

    With a start line a lap ends where the car crosses it. Without, a lap is from the start, or the last goal
    of the lap before, to its own last goal, by race_mgr.
    """
    known = [update for update in updates if update.stamp <= judgement.decision.stamp]
    start = race_start(known)
    if scenario.start_line:
        return {
            track.car: _by_line(scenario.start_line, track, start or 0.0)
            for track in judgement.record.tracks.values()
        }
    return {car.name: _by_goals(scenario.laps, car.name, judgement.passes, known) for car in scenario.cars}


def _by_line(line: StartLine, track: CarTrack, start: float) -> list[float]:
    counter = LapCounter(line, start)
    for time, x, y in zip(track.time, track.x, track.y):
        counter.update(float(time), float(x), float(y))
    return counter.lap_times


def _by_goals(
    laps: int, car: str, passes: Mapping[str, GoalPasses], updates: Iterable[RaceUpdate]
) -> list[float]:
    own = [update for update in updates if update.car == car]
    start = race_start(own)
    if car not in passes or start is None:
        return []
    per_lap = passes[car].wanted // laps
    ends = [_reached(own, per_lap * (lap + 1)) for lap in range(laps)]
    marks = [start, *(end for end in ends if end is not None)]
    return [later - earlier for earlier, later in zip(marks, marks[1:])]


def _reached(updates, count) -> Optional[float]:
    return next((update.stamp for update in updates if update.goals_reached >= count), None)
