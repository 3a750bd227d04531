"""Goals for one lap: poses on the centreline, in driving order."""

from f1tenth_judge.places.lap import Lap

SPACING = 6.5
"""Desired distance from one goal to the next, m."""
MAX_SHIFT = 0.6
"""How far a goal may be moved along the lap to lie on a straight, m."""
PAST_START = 1.0
"""Distance of the last goal behind the start line, m."""
_STEP = 0.05


def lap_goals(vertices):
    """Poses of the goals for one lap, the last of them a little behind the start line."""
    lap = Lap(vertices)
    distance = lap.length + PAST_START
    count = round(distance / SPACING)
    goals = [lap.pose(_best_place(lap, i * distance / count)) for i in range(1, count)]
    return [*goals, lap.pose(PAST_START)]


def goals_text(goals, circuit_name):
    """A goals file."""
    lines = ["frame_id: map", f"# One lap of {circuit_name}: x (m) y (m) yaw (rad)"]
    lines += [f"{goal.x:.3f} {goal.y:.3f} {goal.yaw:.4f}" for goal in goals]
    return "\n".join(lines) + "\n"


def _best_place(lap, distance):
    """The straightest place near a distance; a metre from the bend is straight enough."""
    steps = round(MAX_SHIFT / _STEP)
    shifts = sorted((i * _STEP for i in range(-steps, steps + 1)), key=abs)
    return max((distance + shift for shift in shifts), key=lambda place: min(1.0, lap.straightness(place)))
