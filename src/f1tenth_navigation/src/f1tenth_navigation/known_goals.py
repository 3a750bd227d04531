"""The goals of a car as far as they are known: of its race, then those sent to its planner one by one."""

import math

from geometry_msgs.msg import PoseStamped

_SAME_PLACE = 1e-3  # m
_SAME_HEADING = 1e-3  # as a difference of quaternions' components


class KnownGoals:
    """PoseStamped in the order in which they became known; a goal that is sent again is the same one."""

    def __init__(self):
        self.poses = []

    def take_race(self, goals):
        """A geometry_msgs/PoseArray with all goals of a race replaces what was known."""
        self.poses = [PoseStamped(header=goals.header, pose=pose) for pose in goals.poses]

    def take_sent(self, goal):
        """A PoseStamped was sent to the planner; return whether it was not known."""
        if any(_same(goal, known) for known in self.poses):
            return False
        self.poses.append(goal)
        return True


def _same(one, other):
    a, b = one.pose, other.pose
    turns = [(q.x, q.y, q.z, q.w) for q in (a.orientation, b.orientation)]
    return (
        one.header.frame_id == other.header.frame_id
        and math.dist((a.position.x, a.position.y), (b.position.x, b.position.y)) < _SAME_PLACE
        and math.dist(*turns) < _SAME_HEADING
    )
