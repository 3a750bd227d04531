"""Learned policies as planners: an ONNX file, or what stable-baselines3 has saved.

A policy gets a row of numbers: ranges of the lidar (m) at even steps, as many as it has room for, then the
velocity (m/s ahead, m/s to the left, rad/s). It answers the steering angle (rad) and the speed (m/s); one of
stable-baselines3 whose actions go from -1 to 1, as those of a normalized F1Tenth-v0, is scaled to
`steering_max` and to `speed_min` … `speed_max`, arguments of the planner.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from f1tenth_judge.planner import Command, Observation

_VELOCITIES = 3


class OnnxPolicy:
    """Drives by the ONNX file that the argument `policy` names."""

    def reset(self, info: Mapping[str, Any]) -> None:
        """Load it."""
        import onnxruntime

        self._session = onnxruntime.InferenceSession(info["policy"], providers=["CPUExecutionProvider"])
        (self._input,) = self._session.get_inputs()

    def plan(self, observation: Observation) -> Command:
        """What it answers."""
        row = seen(observation, self._input.shape[-1])
        steering_angle, speed = np.ravel(self._session.run(None, {self._input.name: row[None]})[0])
        return Command(speed, steering_angle)


class Sb3Policy:
    """Drives by the .zip file that the argument `policy` names; `algorithm` has saved it, PPO by default."""

    def reset(self, info: Mapping[str, Any]) -> None:
        """Load it."""
        import stable_baselines3

        self._model = getattr(stable_baselines3, info.get("algorithm", "PPO")).load(
            info["policy"], device="cpu"
        )
        steering = float(info.get("steering_max", 0.4189))
        self._low = np.array([-steering, float(info.get("speed_min", -5.0))])
        self._high = np.array([steering, float(info.get("speed_max") or 20.0)])

    def plan(self, observation: Observation) -> Command:
        """What it answers, without the noise of learning."""
        space = self._model.action_space
        answer, _ = self._model.predict(
            seen(observation, self._model.observation_space.shape[-1]), deterministic=True
        )
        if (space.low == -1.0).all() and (space.high == 1.0).all():
            answer = self._low + (answer + 1.0) / 2.0 * (self._high - self._low)
        steering_angle, speed = np.ravel(answer)
        return Command(speed, steering_angle)


def seen(observation: Observation, count: int) -> np.ndarray:
    """What a policy with room for so many numbers sees, float32.

    Raises:
        ValueError: the car has no lidar, or too few beams.
    """
    beams, scan = count - _VELOCITIES, observation.scan
    ranges = np.clip(scan.ranges, 0.0, scan.range_max) if scan else np.zeros(0)
    every = math.ceil(len(ranges) / beams) if beams > 0 else 0
    if not every or len(ranges[::every]) != beams:
        wanted = f"the policy takes {count} numbers: {beams} ranges and {_VELOCITIES} velocities"
        raise ValueError(f"{wanted}; the lidar has {len(ranges)} beams")
    return np.array([*ranges[::every], *observation.velocity], np.float32)
