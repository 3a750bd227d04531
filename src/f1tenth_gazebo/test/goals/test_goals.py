"""Goals must lie on the road in driving order, where a car can reach and pass them."""

import math

import pytest
import shipped
from f1tenth_gazebo.goals.goals_file import goals_text, lap_goals
from f1tenth_judge.places.centreline import centreline
from f1tenth_judge.places.circuit import Pose
from f1tenth_judge.places.lap import Lap
from shapely.geometry import Point

CLEARANCE = 0.3


def place_on_lap(lap, goal):
    """Distance driven from the start line to a goal, m."""
    steps = int(lap.length / 0.02)
    places = [i * lap.length / steps for i in range(steps)]
    return min(places, key=lambda s: math.hypot(lap.pose(s).x - goal[0], lap.pose(s).y - goal[1]))


@pytest.mark.parametrize("name", shipped.NAMES)
class TestGoals:
    def test_are_in_driving_order_and_a_few_metres_apart(self, name):
        lap = shipped.lap(name)
        places = [place_on_lap(lap, goal) for goal in shipped.goals(name)]
        places[-1] += lap.length
        gaps = [b - a for a, b in zip([0.0, *places], places)]
        assert min(gaps) >= 4.9
        assert max(gaps) <= 8.1

    def test_last_one_is_a_little_past_the_start_line(self, name):
        assert shipped.goals(name)[-1] == pytest.approx((1.0, 0.0, 0.0))

    def test_have_clearance(self, name):
        for x, y, _ in shipped.goals(name):
            assert shipped.solid(name).distance(Point(x, y)) >= CLEARANCE

    def test_face_the_driving_direction(self, name):
        lap = shipped.lap(name)
        for goal in shipped.goals(name):
            yaw = lap.pose(place_on_lap(lap, goal)).yaw
            assert abs(math.remainder(goal[2] - yaw, 2 * math.pi)) < 0.25


def test_goals_prefer_straights():
    lap = shipped.lap("circuit5")
    goals = lap_goals(centreline(shipped.circuit("circuit5")))
    on_straight = [lap.straightness(place_on_lap(lap, (g.x, g.y))) > -0.05 for g in goals]
    assert sum(on_straight) > len(goals) / 2


def test_lap_knows_how_far_bends_are():
    lap = shipped.lap("circuit1")
    assert lap.straightness(0.0) == pytest.approx(5.2, abs=0.3)
    assert lap.straightness(lap.length / 4) < 0


def test_middle_of_a_hairpin_is_no_straight():
    lap = shipped.lap("circuit3")
    apex = place_on_lap(lap, (12.0, 1.5))
    assert lap.straightness(apex) == pytest.approx(-2.2, abs=0.2)


def test_pose_repeats_after_a_lap():
    lap = Lap(centreline(shipped.circuit("circuit2")))
    assert lap.pose(lap.length + 2.0).x == pytest.approx(lap.pose(2.0).x)


def test_goals_file_has_frame_and_one_goal_a_line():
    text = goals_text([Pose(1, -2, 0.5)], "circuit1")
    assert text == "frame_id: map\n# One lap of circuit1: x (m) y (m) yaw (rad)\n1.000 -2.000 0.5000\n"
