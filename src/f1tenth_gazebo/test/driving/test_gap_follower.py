"""The driver without a map must keep to the road, alone, on every circuit."""

import math

import numpy as np
import pytest
from f1tenth_gazebo.driving.gap_follower import GapFollower, GapFollowerOptions

BEAMS = 271
INCREMENT = math.radians(1.0)
FIRST = -math.radians(135.0)


def follower(**options):
    return GapFollower(FIRST, INCREMENT, BEAMS, GapFollowerOptions(**options))


def corridor(left, right, ahead=math.inf):
    """Scan between two walls, m aside, and one ahead."""
    angles = FIRST + INCREMENT * np.arange(BEAMS)
    with np.errstate(divide="ignore"):
        side = np.where(np.sin(angles) > 0.0, left, right) / np.abs(np.sin(angles))
        front = np.where(np.cos(angles) > 0.0, ahead / np.cos(angles), math.inf)
    ranges = np.minimum(side, front)
    return np.where(ranges > 10.0, math.inf, ranges).astype(np.float32)


def test_goes_straight_in_the_middle():
    speed, steering = follower(speed=1.5).command(corridor(1.0, 1.0))
    assert speed == pytest.approx(1.5)
    assert steering == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize(("left", "right", "sign"), [(1.6, 0.4, 1.0), (0.4, 1.6, -1.0)])
def test_steers_away_from_the_nearer_wall(left, right, sign):
    _, steering = follower().command(corridor(left, right))
    assert sign * steering > 0.02


def test_slows_down_for_a_wall_ahead():
    speed, _ = follower().command(corridor(0.5, 0.5, ahead=0.6))
    assert speed < 1.4


def test_stops_where_there_is_no_way():
    speed, _ = follower().command(corridor(0.5, 0.5, ahead=0.12))
    assert speed == 0.0


def test_what_is_hit_by_nothing_is_free():
    assert follower().command(np.full(BEAMS, math.inf, np.float32))[0] == pytest.approx(1.5)


@pytest.mark.parametrize("name", ["speed", "sight", "max_lateral_acceleration"])
def test_options_that_make_no_sense_are_refused(name):
    with pytest.raises(ValueError, match=f"^{name}: found -1.0, must be above 0$"):
        GapFollowerOptions(**{name: -1.0})
