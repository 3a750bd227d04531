"""Laps that are quicker than any car could be: the shortest way through the gates at the greatest speed."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

import f1tenth_sim2d
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.plan.task import Task
from f1tenth_judge.record.record import CarTrack, Record
from f1tenth_judge.scenario.scenario import StartLine

_PLACES = 25  # on each gate, among which the shortest way is looked for
_EXACT = 0.99  # of the length found, as places between those are left out
_ROOM = 0.5  # m/s, by which a car may be faster between two periods


def impossible_laps(plan: Plan, record: Record, laps: Mapping[str, Sequence[float]]) -> Iterator[str]:
    """What is wrong with laps (s, by car) that nothing that drives can do, in words."""
    for car, times in laps.items():
        task = plan.tasks[car]
        if not (times and task.gates and task.line):
            continue
        track, way = record.tracks[car], _EXACT * shortest_way([task.line, *task.gates])
        speed = min(_greatest_speed(plan, car), float(track.speed.max())) + _ROOM
        for number, time in enumerate(times, start=1):
            least = (way - (_head_start(track, task) if number == 1 else 0.0)) / speed
            if time < least:
                yield (
                    f"lap {number} of {car} took {time:.3f} s, but the shortest way through the road is"
                    f" {way:.1f} m and takes {least:.3f} s at its greatest speed: the road, the world or the"
                    " record is not what the scenario means"
                )


def shortest_way(gates: Sequence[StartLine]) -> float:
    """Length of the shortest way from the first gate through all others, in their order, back to it, m."""
    places = [_places(gate) for gate in gates]
    steps = [_distances(a, b) for a, b in zip(places, [*places[1:], places[0]])]
    ways = steps[0]  # from each place on the first gate to each on the next one
    for step in steps[1:]:
        ways = (ways[:, :, None] + step[None, :, :]).min(axis=1)
    return float(ways.min())


def _places(gate: StartLine) -> np.ndarray:
    """Along a gate, rows of x and y, m."""
    across = np.linspace(-0.5, 0.5, _PLACES) * gate.width
    return np.column_stack([gate.x - across * np.sin(gate.yaw), gate.y + across * np.cos(gate.yaw)])


def _distances(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    return np.hypot(*(one[:, None, :] - other[None, :, :]).transpose(2, 0, 1))


def _head_start(track: CarTrack, task: Task) -> float:
    """How far from the line the first lap may begin, m."""
    assert task.line
    return float(np.hypot(track.x[0] - task.line.x, track.y[0] - task.line.y))


def _greatest_speed(plan: Plan, car: str) -> float:
    """What the car's vehicle model allows, m/s."""
    description = plan.cars[car].description
    return description.dynamics["v_max"] if description else f1tenth_sim2d.VehicleParameters().v_max
