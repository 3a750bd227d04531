"""The goals of a car as far as they are known: of its race, then those sent to its planner one by one."""

import math

from geometry_msgs.msg import PoseStamped

_SAME_PLACE = 1e-3  # m
_SAME_HEADING = 1e-3  # as a difference of quaternions' components


class KnownGoals:
    """PoseStamped in the order in which they became known; a goal that is sent again is the same one."""

    def __init__(self):
        self.poses = []
        self.problems = {}  # by number, from 1: why the planner gave up
        self._sent = {}  # numbers by the action's goal ids

    def take_race(self, goals):
        """A geometry_msgs/PoseArray with all goals of a race replaces what was known."""
        self.poses = [PoseStamped(header=goals.header, pose=pose) for pose in goals.poses]
        self.problems, self._sent = {}, {}

    def take_sent(self, goal, goal_id=""):
        """A PoseStamped was sent to the planner under an id; return whether the markers have changed."""
        number = next((place for place, known in enumerate(self.poses, 1) if _same(goal, known)), None)
        if number is None:
            self.poses.append(goal)
        self._sent[goal_id] = number or len(self.poses)
        # It may be reached this time.
        forgotten = self.problems.pop(number, None)
        return number is None or forgotten is not None

    def take_failure(self, goal_id, reason):
        """The planner gave up a goal; return whether it is a known one."""
        number = self._sent.get(goal_id)
        if number is not None:
            self.problems[number] = reason
        return number is not None


def _same(one, other):
    a, b = one.pose, other.pose
    turns = [(q.x, q.y, q.z, q.w) for q in (a.orientation, b.orientation)]
    return (
        one.header.frame_id == other.header.frame_id
        and math.dist((a.position.x, a.position.y), (b.position.x, b.position.y)) < _SAME_PLACE
        and math.dist(*turns) < _SAME_HEADING
    )
