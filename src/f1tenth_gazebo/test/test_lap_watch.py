"""A lap must be noticed once, at its end, also when odometry has drifted."""

import math

import pytest
from f1tenth_gazebo.driving.lap_watch import LapWatch


def circle(laps, radius=4.0, growth=0.0, step=0.05):
    """Poses of odometry around a circle that starts at the origin towards +x and drifts outwards."""
    count = int(laps * math.tau * radius / step)
    for i in range(count):
        angle = i * step / radius
        r = radius + growth * i / count
        yield r * math.sin(angle), radius - r * math.cos(angle), angle


def passes(poses):
    watch = LapWatch()
    return [watch.way for pose in poses if watch.passes_start(*pose)]


def test_lap_is_complete_at_the_start():
    assert passes(circle(1.5)) == pytest.approx([math.tau * 4.0], abs=0.1)


def test_start_is_not_passed_before_the_lap_is_over():
    assert passes(circle(0.95)) == []


def test_odometry_may_drift():
    assert len(passes(circle(1.5, growth=3.0))) == 1


def test_way_in_the_other_direction_does_not_count():
    there_and_back = [(x, 0.0, 0.0) for x in range(20)] + [(x, 1.0, math.pi) for x in range(20, -5, -1)]
    assert passes(there_and_back) == []


def test_a_small_loop_is_no_lap():
    assert passes(circle(1.5, radius=1.0)) == []
