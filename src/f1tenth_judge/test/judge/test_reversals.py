"""The least time of a way that turns back: below that of every point so accelerated, and not far below."""

import math

import numpy as np
import pytest
from f1tenth_judge.judge.reversals import least_time
from f1tenth_judge.scenario.scenario import StartLine

ACCELERATION, SPEED, STEP = 10.0, 20.0, 0.01


def gate(x, y, yaw, width=0.001):
    return StartLine(x, y, yaw, width)


def circle(radius, width=0.001):
    angles = np.linspace(0.0, math.tau, 25)
    return [gate(radius * math.cos(a), radius * math.sin(a), a + math.pi / 2, width) for a in angles]


@pytest.mark.parametrize("radius", [1.0, 5.0, 20.0])
def test_lap_of_a_circle_takes_hardly_longer_than_that(radius):
    driven = math.tau * math.sqrt(radius / ACCELERATION)
    assert 0.89 * driven < least_time(circle(radius), SPEED, ACCELERATION) < driven


def test_way_there_and_back_takes_just_that():
    there_and_back = [gate(0, 0, 0), gate(9, 0, 0), gate(0, 0, math.pi)]
    assert least_time(there_and_back, SPEED, ACCELERATION) == pytest.approx(
        2 * math.sqrt(2 * 9 / ACCELERATION)
    )
    slow = 2 * (9 / 2.0 + 2.0 / (2 * ACCELERATION))
    assert least_time(there_and_back, 2.0, ACCELERATION) == pytest.approx(slow)


def test_way_straight_on_takes_nothing():
    assert least_time([gate(x, 0.0, 0.0) for x in range(9)], SPEED, ACCELERATION) == 0.0


@pytest.mark.parametrize("changes", [{"room": 0.5}, {"before": 2.0}])
def test_room_shortens_the_way(changes):
    assert least_time(circle(5.0), SPEED, ACCELERATION, **changes) < least_time(
        circle(5.0), SPEED, ACCELERATION
    )


def test_wide_gates_shorten_the_way_to_their_inner_ends():
    wide, inner = (least_time(way, SPEED, ACCELERATION) for way in (circle(5.0, 2.0), circle(4.0)))
    assert wide == pytest.approx(inner, rel=0.02)


@pytest.mark.parametrize("seed", range(30))
def test_no_point_with_such_an_acceleration_is_quicker(seed):
    random = np.random.default_rng(seed)
    count = int(random.integers(200, 800))
    turn = np.repeat(random.uniform(0.0, math.tau, count // 40 + 1), 40)[:count]
    pushes = ACCELERATION * np.column_stack([np.cos(turn), np.sin(turn)])
    velocity, place, places = random.uniform(-8.0, 8.0, 2), np.zeros(2), []
    for push in pushes:
        wanted = velocity + push * STEP
        # A push that made it too fast is left out.
        after = wanted if np.hypot(*wanted) <= SPEED else velocity
        place = place + (velocity + after) / 2 * STEP
        velocity = after
        places.append(place)
    passed = np.sort(random.choice(count, 12, replace=False))
    gates = [gate(*places[index], random.uniform(0.0, math.tau), 0.5) for index in passed]
    assert least_time(gates, SPEED, ACCELERATION) <= (passed[-1] - passed[0]) * STEP + 1e-9
