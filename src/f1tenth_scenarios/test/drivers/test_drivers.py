"""The example driver, and the lidar that loses beams."""

import math

import numpy as np
import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.places.raceline import Raceline, read_raceline
from f1tenth_scenarios.drivers.answering import Answering
from f1tenth_scenarios.drivers.beam_dropper import drop_beams
from f1tenth_scenarios.drivers.pure_pursuit import PurePursuit, PursuitOptions

RADIUS = 5.0  # m
HEADER = "# a\n# b\n# s_m; x_m; y_m; psi_rad; kappa_radpm; vx_mps; ax_mps2\n"


def circle(speed=math.inf, count=100):
    turns = np.linspace(0, 2 * math.pi, count, endpoint=False)
    return Raceline(RADIUS * np.cos(turns), RADIUS * np.sin(turns), np.full(count, speed))


def drive(driver, seconds, x, y, yaw):
    """A car without inertia, by the kinematic single-track model; yields its places."""
    speed, period = 0.0, 0.025
    for _ in range(round(seconds / period)):
        speed, steering = driver.command(x, y, yaw, speed)
        x += period * speed * math.cos(yaw)
        y += period * speed * math.sin(yaw)
        yaw += period * speed * math.tan(steering) / 0.33
        yield x, y, speed


def test_pursuit_finds_its_line_and_stays_on_it():
    places_driven = list(drive(PurePursuit(circle(), PursuitOptions(speed_max=2.0)), 20.0, 5.5, 0.0, 1.2))
    distances = [math.hypot(x, y) - RADIUS for x, y, _ in places_driven[200:]]
    assert max(map(abs, distances)) < 0.1


def test_pursuit_drives_as_fast_as_the_line_says_up_to_its_limit():
    at = (RADIUS, 0.0, math.pi / 2, 1.0)
    assert PurePursuit(circle(1.5), PursuitOptions(speed_max=2.0)).command(*at)[0] == 1.5
    assert PurePursuit(circle(), PursuitOptions(speed_max=2.0)).command(*at)[0] == 2.0


def test_pursuit_slows_down_in_bends():
    # Fine, as the corners of a coarse one are bends of their own.
    line = circle(count=2000)
    driver = PurePursuit(line, PursuitOptions(speed_max=20.0, lateral_acceleration=5.0))
    assert driver.command(RADIUS, 0.0, math.pi / 2, 1.0)[0] == pytest.approx(
        math.sqrt(5.0 * RADIUS), rel=0.02
    )


def test_pursuit_steers_no_further_than_the_car_can():
    speed, steering = PurePursuit(circle(), PursuitOptions()).command(RADIUS, 0.0, 0.0, 0.0)
    assert abs(steering) == 0.4189
    assert speed > 0.0


def test_raceline_of_the_community_is_read(tmp_path):
    path = tmp_path / "track_raceline.csv"
    path.write_text(
        HEADER + "".join(f"{i}; {i}; {i * i}; 0; 0; {i + 1}; 0\n" for i in range(4)), encoding="utf-8"
    )
    line = read_raceline(path)
    assert line.y.tolist() == [0, 1, 4, 9]
    assert line.speed.tolist() == [1, 2, 3, 4]


def test_middle_of_a_circuit_is_a_line():
    line = read_raceline(lookup.course_file("circuit1", lookup.package_path(lookup.PACKAGE)))
    assert np.isinf(line.speed).all()


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("1; 2\n", ":1: '1; 2' must be seven numbers: s_m; x_m; "),
        ("\n1; 2; x; 4; 5; 6; 7\n", ':2: y_m is not a number: "x"'),
        ("\n1; inf; 3; 4; 5; 6; 7\n", ":2: x_m is not finite: inf"),
        (HEADER, ": 0 points, must be at least 3: s_m; "),
    ],
)
def test_what_is_no_raceline_is_refused(tmp_path, text, problem):
    path = tmp_path / "bad_raceline.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        read_raceline(path)
    assert str(caught.value).startswith(f"{path}{problem}")


def test_missing_raceline_is_named(tmp_path):
    with pytest.raises(ScenarioError, match="none_raceline.csv: cannot be read"):
        read_raceline(tmp_path / "none_raceline.csv")


def test_scan_is_answered_once_by_the_odometry_of_its_time():
    answers = []
    answering = Answering(lambda *pair: answers.append(pair), odometry_period=0.005)
    answering.take_odometry(0.02, "early")
    answering.take_scan(0.025)
    assert answers == []
    answering.take_odometry(0.025, "exact")
    answering.take_odometry(0.03, "late")
    assert answers == [(0.025, "exact")]


def test_odometry_that_came_before_its_scan_will_do():
    answers = []
    answering = Answering(lambda *pair: answers.append(pair), odometry_period=0.02)
    answering.take_odometry(0.04, "newest")
    answering.take_scan(0.05)
    assert answers == [(0.05, "newest")]


def test_share_of_the_beams_is_lost_and_the_same_ones_every_time():
    ranges = np.full(10_000, 2.0, np.float32)
    lost = drop_beams(ranges, 0.1, 1, 25_000_000)
    assert 0.08 < np.isinf(lost).mean() < 0.12
    assert (lost[np.isfinite(lost)] == 2.0).all()
    assert (drop_beams(ranges, 0.1, 1, 25_000_000) == lost).all()
    assert (drop_beams(ranges, 0.1, 1, 50_000_000) != lost).any()
    assert (drop_beams(ranges, 0.1, 2, 25_000_000) != lost).any()
