"""A lap must be noticed once, at its end, and a drive must end in any case."""

import math

import pytest
from f1tenth_gazebo.driving import lap_watch
from f1tenth_gazebo.driving.lap_watch import LapError, LapWatch

SPEED = 1.5


def circle(laps, radius=4.0, growth=0.0, step=0.05):
    """Poses in a map around a circle that starts at the origin towards +x and drifts outwards."""
    count = int(laps * math.tau * radius / step)
    for i in range(count):
        angle = i * step / radius
        r = radius + growth * i / count
        yield r * math.sin(angle), radius - r * math.cos(angle), angle


def stadium(straight, radius=4.0, step=0.05):
    """Poses of two laps around two straights and two half circles, from the middle of a straight."""
    x, y, yaw = 0.0, 0.0, 0.0
    lap = [(0.5 * straight, 0.0), (math.pi * radius, 1.0 / radius), (straight, 0.0)]
    lap += [(math.pi * radius, 1.0 / radius), (0.5 * straight, 0.0)]
    for length, curvature in lap * 2:
        for _ in range(round(length / step)):
            yield x, y, yaw
            yaw += curvature * step
            x, y = x + step * math.cos(yaw), y + step * math.sin(yaw)


def watched(poses, time_limit=1e6):
    """A watch that has seen these poses, until the drive was over."""
    watch = LapWatch(time_limit)
    for i, pose in enumerate(poses):
        watch.take(i * 0.05 / SPEED, *pose)
        if watch.is_over:
            break
    return watch


def test_lap_is_complete_at_the_start():
    assert watched(circle(1.5)).lap == pytest.approx(math.tau * 4.0, abs=0.1)


def test_start_is_not_passed_before_the_lap_is_over():
    assert watched(circle(0.95)).lap is None


def test_map_may_have_drifted():
    assert watched(circle(1.5, growth=3.0)).lap is not None


def test_way_in_the_other_direction_does_not_count():
    there_and_back = [(x, 0.0, 0.0) for x in range(20)] + [(x, 1.0, math.pi) for x in range(20, -5, -1)]
    assert watched(there_and_back).lap is None


def test_a_small_loop_is_no_lap():
    assert watched(circle(1.5, radius=1.0)).lap is None


def test_drive_goes_on_for_the_overlap_and_behind_a_bend():
    # 0.5 rad of a bend of 4 m are 2 m of way.
    assert watched(circle(3.0)).way == pytest.approx(math.tau * 4.0 + 2.0 + lap_watch.BEHIND_BEND, abs=0.2)
    watch = watched(stadium(50.0))
    assert watch.way - watch.lap == pytest.approx(25.0 + 2.0 + lap_watch.BEHIND_BEND, abs=0.2)


def test_drive_is_over_without_a_bend_after_a_while():
    watch = watched(stadium(300.0))
    assert watch.way - watch.lap == pytest.approx(lap_watch.MOST_OVERLAP, abs=0.1)


def test_car_that_stands_still_is_an_error():
    watch = watched([(0.05 * i, 0.0, 0.0) for i in range(100)])
    watch.take(30.0, 4.95, 0.0, 0.0)
    with pytest.raises(LapError) as raised:
        watch.take(40.0, 5.0, 0.0, 0.0)
    assert str(raised.value) == (
        "the car has stood still for 30 s, at (5.0, 0.0), 5.0 m of way from the start"
    )


def test_time_limit_is_an_error_that_says_what_is_missing():
    with pytest.raises(LapError, match=r"^no lap is complete after 10 s, at \(\S+, \S+\), 15\.0 m of way"):
        watched(circle(2.0), time_limit=10.0)
    with pytest.raises(LapError, match="^not enough was seen twice after 20 s"):
        watched(circle(2.0), time_limit=20.0)
