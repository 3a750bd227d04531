"""Pure pursuit of a raceline, as one writes it for f1tenth_gym; test_f110_gym.py changes one import."""

import gym
import numpy as np


class Planner:
    def __init__(self, raceline, wheelbase, lookahead, gain):
        table = np.loadtxt(raceline, delimiter=";")
        self.points, self.speeds = table[:, 1:3], gain * table[:, 5]
        self.wheelbase, self.lookahead = wheelbase, lookahead

    def plan(self, x, y, theta):
        position = np.array([x, y])
        nearest = int(np.argmin(np.hypot(*(self.points - position).T)))
        ahead = np.roll(self.points, -nearest, axis=0)
        goal = ahead[np.argmax(np.hypot(*(ahead - position).T) > self.lookahead)] - position
        left = np.cos(theta) * goal[1] - np.sin(theta) * goal[0]
        return self.speeds[nearest], np.arctan(2.0 * self.wheelbase * left / (goal @ goal))


def main(track, raceline):
    planner = Planner(raceline, 0.17145 + 0.15875, lookahead=1.2, gain=0.7)
    env = gym.make("f110_gym:f110-v0", map=track, map_ext=".png", num_agents=1, timestep=0.01)
    first, second = planner.points[:2]
    start = [*first, np.arctan2(*(second - first)[::-1])]
    obs, step_reward, done, info = env.reset(np.array([start]))
    laptime = 0.0
    while not done:
        speed, steer = planner.plan(obs["poses_x"][0], obs["poses_y"][0], obs["poses_theta"][0])
        obs, step_reward, done, info = env.step(np.array([[steer, speed]]))
        laptime += step_reward
    return laptime, obs
