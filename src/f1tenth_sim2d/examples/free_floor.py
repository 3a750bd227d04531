#!/usr/bin/env python3
"""Drive by the camera alone: towards where the floor is free the farthest.

free_floor.py [PLACE] [SECONDS]
"""

import sys

import gymnasium
import numpy as np
from f1tenth_sim2d.environments import register
from f1tenth_sim2d.environments.car import Lidar, load_cars

EYE = load_cars(["robot1"], Lidar(2, 1.0, 1.0))[0].cameras["stereo_camera"][0]
COLUMNS = 16  # pixels that are looked at together
SIDE = 0.22  # m, that the middle of the car keeps from what is not floor
LOOK_AHEAD = 1.2  # m
WHEELBASE = 0.33  # m


def free_floor(depth):
    """Directions (rad, to the left) and how far the floor reaches there (m), for blocks of columns."""
    rows = np.arange(int(EYE.middle_y) + 3, EYE.height)
    floor = EYE.pose[2] * EYE.focal_y / (rows - EYE.middle_y)  # m, depth at which a row sees the floor
    is_floor = np.abs(depth[rows] / floor[:, None] - 1.0) < 0.03
    is_free = is_floor.reshape(len(rows), -1, COLUMNS).all(axis=2)
    reach = np.where(is_free.any(axis=0), floor[is_free.argmax(axis=0)], 0.0)
    columns = np.arange(len(reach)) * COLUMNS + (COLUMNS - 1) / 2
    directions = np.arctan((EYE.middle_x - columns) / EYE.focal_x)
    return directions, reach / np.cos(directions)


def drive(depth):
    """(steering angle, rad, speed, m/s) for a picture."""
    directions, reach = free_floor(depth)
    # What stands beside a direction, nearer than its own end, must leave room for the car.
    apart = np.abs(directions[:, None] - directions)
    in_the_way = np.sin(np.minimum(apart, np.pi / 2)) * reach < SIDE
    clear = np.where(in_the_way, np.maximum(reach, 0.0), np.inf).min(axis=1)
    best = np.argmax(clear - 0.1 * np.abs(directions))
    target = directions[best]
    steering = np.arctan(2.0 * WHEELBASE * np.sin(target) / LOOK_AHEAD)
    return steering, np.clip(0.6 * clear[best], 0.8, 2.5)


def main():
    """Drive in a place; say how far it went and whether anything was touched."""
    place, seconds = (sys.argv[1:] + ["circuit1", "60"][len(sys.argv) - 1 :])[:2]
    register()
    env = gymnasium.make(
        "F1Tenth-v0", place=place, observation=("depth",), normalized=False, laps=1, max_time=float(seconds)
    )
    observation, info = env.reset(seed=1)
    finished = late = False
    while not (finished or late):
        steering, speed = drive(observation["depth"])
        action = np.array([steering, speed], np.float32)
        observation, _, finished, late, info = env.step(action)
    print(f"{info['time']:.1f} s, laps {info['laps'][0]:.0f}, contact {info['contact'][0]:.0f}")
    return 0 if info["laps"][0] >= 1 else 1


if __name__ == "__main__":
    sys.exit(main())
