"""A follower of the road as it is written for f1tenth_gym."""

import numpy as np
from f1tenth_judge.gym_planner import adapted


def steered(ranges):
    left, right = ranges[810:950].mean(), ranges[130:270].mean()
    return float(np.clip(0.4 * (left - right), -0.4, 0.4))


class OriginalPlanner:
    def plan(self, obs):
        assert obs["collisions"][obs["ego_idx"]] == 0.0
        return np.array([[steered(obs["scans"][0]), 1.5]])


class FeaturesPlanner:
    def plan(self, obs):
        return steered(obs["agent_0"]["scan"]), 1.5


class SpeedFirstPlanner:
    def plan(self, obs):
        return 1.5, steered(obs["scans"][0])


Original = adapted(OriginalPlanner)
Features = adapted(FeaturesPlanner, features=True)
SpeedFirst = adapted(SpeedFirstPlanner, speed_first=True)
