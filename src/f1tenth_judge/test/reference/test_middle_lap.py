"""The lap along the middle of a road."""

import dataclasses
import math

import numpy as np
import pytest
from f1tenth_judge.places.course import Course
from f1tenth_judge.reference.car_limits import GRAVITY, read_limits
from f1tenth_judge.reference.middle_lap import middle_lap


def course(x, y):
    return Course(np.array(x), np.array(y), np.ones(len(x)), np.ones(len(x)))


def test_a_circle_is_driven_at_the_limit_of_friction():
    at = np.linspace(0.0, math.tau, 200, endpoint=False)
    limits = dataclasses.replace(read_limits(), friction=0.5)
    time = math.tau * 5.0 / math.sqrt(0.5 * GRAVITY * 5.0)
    assert middle_lap(course(5.0 * np.cos(at), 5.0 * np.sin(at)), limits) == pytest.approx(time, rel=0.01)


def test_on_straights_it_speeds_up_and_brakes_as_the_car_can():
    bend = np.linspace(-math.pi / 2, math.pi / 2, 60)
    straight = np.linspace(0.0, 40.0, 80)[1:-1]
    x = [*straight, *(40.0 + 2.0 * np.cos(bend)), *straight[::-1], *(-2.0 * np.cos(bend))]
    y = [*(-2.0 + 0.0 * straight), *(2.0 * np.sin(bend)), *(2.0 + 0.0 * straight), *(-2.0 * np.sin(bend))]
    limits = dataclasses.replace(read_limits(), friction=1.0, max_acceleration=4.0, switch_speed=100.0)
    slow = math.sqrt(GRAVITY * 2.0)
    peak = math.sqrt(slow**2 + 2 * 4.0 * 20.0)
    expected = 2 * (math.pi * 2.0 / slow + 2 * (peak - slow) / 4.0)
    assert middle_lap(course(x, y), limits) == pytest.approx(expected, rel=0.05)
