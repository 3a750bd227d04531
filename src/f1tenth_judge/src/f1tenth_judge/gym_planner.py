"""Planners of f1tenth_gym as planners of the judge.

    Judged = adapted(FollowTheGap)  # in judged.py, for --planner judged.py:Judged

`plan(obs)` gets the dictionary that `env.step` gives for one car, and answers what `env.step` takes for it.
"""

import math
from collections.abc import Mapping
from typing import Any, Callable

import numpy as np
from f1tenth_sim2d.f1tenth_gym_names import PER_CAR

import f1tenth_sim2d
from f1tenth_judge.planner import Command, Observation

_REAR = f1tenth_sim2d.VehicleParameters().l_r  # m, from the rear axle to the centre of mass, whose pose it is


def adapted(make: Callable[[], Any], features: bool = False, speed_first: bool = False) -> type:
    """What the judge makes a planner of.

    Args:
        make: the class of the planner, which is made without arguments
        features: whether it reads `obs["agent_0"]["scan"]` of version 1.0, not the original `obs["scans"][0]`
        speed_first: whether it answers (speed, steering angle), as the example waypoint_follow does, rather
            than (steering angle, speed); m/s and rad
    """

    class Adapted:
        def __init__(self):
            self._planner = make()

        def plan(self, observation: Observation) -> Command:
            seen = features_of(observation) if features else original_of(observation)
            first, second = np.ravel(self._planner.plan(seen))
            return Command(first, second) if speed_first else Command(second, first)

    return Adapted


def features_of(observation: Observation) -> Mapping[str, Any]:
    """The features of version 1.0: SI units; nothing was hit where a range is the greatest one."""
    (x, y, yaw), (ahead, left, rate), scan = observation.pose, observation.velocity, observation.scan
    left += _REAR * rate
    numbers = {"pose_x": x + _REAR * math.cos(yaw), "pose_y": y + _REAR * math.sin(yaw), "pose_theta": yaw}
    numbers |= {"linear_vel_x": ahead, "linear_vel_y": left, "ang_vel_z": rate}
    numbers |= {"delta": observation.steering_angle, "beta": math.atan2(left, ahead)}
    numbers |= {"collision": 0.0, "lap_time": observation.time, "lap_count": 0.0}
    seen = {} if scan is None else {"scan": np.minimum(scan.ranges, np.float32(scan.range_max))}
    return {"agent_0": {**seen, **{name: np.float32(value) for name, value in numbers.items()}}}


def original_of(observation: Observation) -> Mapping[str, Any]:
    """The original observation: a row for each car, of which there is one."""
    features = features_of(observation)["agent_0"]
    rows = {plural: np.array([features[name]]) for name, plural in PER_CAR.items() if name in features}
    return {"ego_idx": 0, **rows}
