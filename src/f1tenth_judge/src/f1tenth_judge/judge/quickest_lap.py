"""Laps that are quicker than any car could be.

Whatever line it takes, it drives no less than the shortest way through the gates, at no more than its
greatest speed, and turns no more quickly than its vehicle model lets it.
"""

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

import f1tenth_sim2d
from f1tenth_judge.judge.reversals import least_time
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.plan.task import Task
from f1tenth_judge.record.record import CarTrack, Record
from f1tenth_judge.scenario.scenario import StartLine

_PLACES = 25  # on each gate, among which the shortest way is looked for
_EXACT = 0.99  # of the length found, as places between those are left out
_ROOM = 0.5  # m/s, by which a car may be faster between two periods
_GRAVITY = 9.81  # m/s^2, of the vehicle models
# rad; single_track's tyres are linear in slip up to there, with this room for what changes within a step.
_GREATEST_SLIP, _STEP_ROOM = 0.8, 1.05


def impossible_laps(plan: Plan, record: Record, laps: Mapping[str, Sequence[float]]) -> Iterator[str]:
    """What is wrong with laps (s, by car) that nothing that drives can do, in words."""
    for car, times in laps.items():
        task = plan.tasks[car]
        if not (times and task.gates and task.line):
            continue
        track, lap = record.tracks[car], [task.line, *task.gates, task.line]
        way, vehicle = _EXACT * shortest_way(lap[:-1]), _vehicle(plan, car)
        speed = min(vehicle.v_max, float(track.speed.max())) + _ROOM
        near, turning = _distance(task.line, task.gates[0]) / 2, greatest_acceleration(vehicle)
        for number, time in enumerate(times, start=1):
            ahead = _head_start(track, task) if number == 1 else 0.0
            least = (way - ahead) / speed
            if ahead < near and not any(track.contacts):
                least = max(least, least_time(lap, speed, turning, vehicle.wheelbase, ahead))
            if time < least:
                yield (
                    f"lap {number} of {car} took {time:.3f} s, but the shortest way through the road is"
                    f" {way:.1f} m, and {least:.3f} s is the least that the speed and the tyres of its"
                    " vehicle model allow: the road, the world or the record is not what the scenario means"
                )


def greatest_acceleration(vehicle: f1tenth_sim2d.VehicleParameters) -> float:
    """What no car of this vehicle model exceeds unless it touches something, in whatever direction, m/s^2."""
    if vehicle.model == "kinematic":  # follows its wheels, however fast
        turn = vehicle.v_max * math.tan(vehicle.steering_max) / vehicle.wheelbase + vehicle.steering_rate_max
        return math.hypot(vehicle.a_max, vehicle.v_max * turn)
    if vehicle.model == "single_track":
        resting = _GRAVITY * (vehicle.C_Sf * vehicle.l_r + vehicle.C_Sr * vehicle.l_f)
        shifted = vehicle.a_max * vehicle.h * abs(vehicle.C_Sf - vehicle.C_Sr)
        aside = vehicle.mu * _GREATEST_SLIP * (resting + shifted) / vehicle.wheelbase
        return _STEP_ROOM * math.hypot(vehicle.a_max, aside)
    tire = vehicle.tire
    along = tire.p_dx1 / tire.p_dy1  # of the friction across
    return _STEP_ROOM * vehicle.mu * _GRAVITY * math.hypot(along, 1.0 + abs(tire.r_vy1))


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
    return math.hypot(track.x[0] - task.line.x, track.y[0] - task.line.y)


def _distance(one: StartLine, other: StartLine) -> float:
    return math.hypot(one.x - other.x, one.y - other.y)


def _vehicle(plan: Plan, car: str) -> f1tenth_sim2d.VehicleParameters:
    """The car's parameters, as the simulator has them."""
    vehicle, description = f1tenth_sim2d.VehicleParameters(), plan.cars[car].description
    named = next(each for each in plan.scenario.cars if each.name == car)
    changes = (description.dynamics if description else {}) | named.vehicle_changes()
    for name, value in changes.items():
        setattr(vehicle, name, value)
    return vehicle
