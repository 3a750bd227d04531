"""Criteria of how the cars drove."""

import operator
from collections.abc import Iterator
from typing import Optional, Union

import numpy as np

from f1tenth_judge.judge.criterion import Criterion, Measured, compared
from f1tenth_judge.judge.judge import Judgement
from f1tenth_judge.record.record import CarTrack
from f1tenth_judge.scenario.scenario import Scenario

_STANDING_SPEED = 0.05  # m/s


def least_clearance(judgement: Judgement) -> Optional[float]:
    """The least clearance of any car up to the deciding stamp, m; nothing without a record."""
    return min((float(track.clearance.min()) for track in _tracks(judgement)), default=None)


def lateral(track: CarTrack) -> np.ndarray:
    """Acceleration of base_footprint to the left, m/s^2."""
    return _rate(track, track.v_y) + track.v_x * track.yaw_rate


def longitudinal(track: CarTrack) -> np.ndarray:
    """Acceleration of base_footprint along the car, m/s^2."""
    return _rate(track, track.v_x) - track.v_y * track.yaw_rate


def minimum_clearance(scenario: Scenario, judgement: Judgement, _measured: Measured) -> Criterion:
    """How close a car came to anything."""
    least = least_clearance(judgement)
    worst = None if least is None else (least,)
    return compared(scenario, "minimum_clearance", operator.ge, worst, "m", "came as close as {:.3f} m")


def lap_time(scenario: Scenario, _judgement: Judgement, measured: Measured) -> Criterion:
    """The slowest lap of any car."""
    laps = [
        (time, car, number)
        for car, times in measured.lap_times.items()
        for number, time in enumerate(times, 1)
    ]
    return _at_most(scenario, "lap_time", laps, "s", "lap {2} of {1} took {0:.3f} s", "no lap was completed")


def lateral_acceleration(scenario: Scenario, judgement: Judgement, _measured: Measured) -> Criterion:
    """The largest acceleration to the side, of base_footprint."""
    peaks = [(float(np.abs(lateral(track)).max()), track.car) for track in _tracks(judgement)]
    return _at_most(scenario, "lateral_acceleration", peaks, "m/s^2", "{1} reached {0:.2f} m/s^2")


def off_road(scenario: Scenario, judgement: Judgement, measured: Measured) -> Criterion:
    """How far base_footprint left the road, and where it was when it did so most."""
    found = measured.excursions or ()
    if not found:
        stayed = [(0.0, track.car) for track in _tracks(judgement)]
        return _at_most(scenario, "off_road", stayed, "m", "every car stayed on the road")
    left = [(each.excess, each.car, each.start, each.end, each.x, each.y) for each in found]
    where = "from {2:.3f} to {3:.3f} s, at ({4:.2f}, {5:.2f})"
    said = f"{{1}} was up to {{0:.3f}} m beyond the edge of the road, {where}"
    return _at_most(scenario, "off_road", left, "m", said)


def standstill(scenario: Scenario, judgement: Judgement, measured: Measured) -> Criterion:
    """The longest time that a car stood still after the start."""
    pauses = [(_longest_pause(track, measured.start or 0.0), track.car) for track in _tracks(judgement)]
    return _at_most(scenario, "standstill", pauses, "s", "{1} stood for {0:.3f} s")


def slows_to(scenario: Scenario, judgement: Judgement, _measured: Measured) -> Criterion:
    """How slow each car became after it had been faster than the limit."""
    limit = scenario.criteria.slows_to
    speeds = [
        (float(track.speed[np.argmax(track.speed > limit) :].min()), track.car)
        for track in _tracks(judgement)
        if (track.speed > limit).any()
    ]
    return _at_most(
        scenario, "slows_to", speeds, "m/s", "{1} slowed down to {0:.3f} m/s", "no car was faster"
    )


def _tracks(judgement) -> Iterator[CarTrack]:
    return (track for track in judgement.record.tracks.values() if len(track.time))


def _rate(track: CarTrack, values: np.ndarray) -> Union[np.ndarray, float]:
    return np.gradient(values, track.time) if len(values) > 1 else 0.0


def _longest_pause(track: CarTrack, start: float) -> float:
    """From the first to the last period of the longest run of periods at rest, s."""
    longest, begun = 0.0, None
    for time, speed in zip(track.time, track.speed):
        if time < start or speed > _STANDING_SPEED:
            begun = None
        elif begun is None:
            begun = time
        else:
            longest = max(longest, float(time - begun))
    return longest


def _at_most(scenario, name, found, *said) -> Criterion:
    """`found`: what was measured, each with what else is told of it; the greatest counts."""
    return compared(scenario, name, operator.le, max(found, default=None), *said)
