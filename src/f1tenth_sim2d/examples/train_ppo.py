#!/usr/bin/env python3
"""Learns to drive with PPO of stable-baselines3 and saves the policy as ONNX; see docs/gym.md."""

import argparse
import time

import gymnasium
import numpy as np
import onnx
import torch
from f1tenth_sim2d.environments import register
from stable_baselines3 import PPO
from stable_baselines3.common.env_util import make_vec_env
from stable_baselines3.common.torch_layers import BaseFeaturesExtractor

SPEEDS = (0.5, 4.0)  # m/s
BEAMS, SIGHT = 109, 10.0  # each tenth of the car's 1081; m
VELOCITIES = (4.0, 1.0, 3.0)  # m/s, m/s, rad/s: about the greatest
DRIVING = {
    "observation": ("scan", "velocity"),
    "flatten": True,
    "beams": BEAMS,
    "range_max": SIGHT,
    "speeds": SPEEDS,
    "normalized": True,
}
LEARNING = {
    "start": "random",
    "vehicle": {"mu": (0.8, 1.1), "actuation_latency": (0.0, 0.04)},
    "lidar_noise": (0.0, 0.03),
    "contact_penalty": 5.0,
    "max_time": 20.0,
}


class Scaled(BaseFeaturesExtractor):
    """Observations that are all about 1."""

    def __init__(self, space):
        super().__init__(space, BEAMS + len(VELOCITIES))
        self.register_buffer("scale", torch.tensor([SIGHT] * BEAMS + list(VELOCITIES)))

    def forward(self, observations):
        """Scale them."""
        return observations / self.scale


class Driver(torch.nn.Module):
    """The learned policy: from an observation to (steering angle, rad, speed, m/s)."""

    def __init__(self, policy, steering_max):
        super().__init__()
        self.features, self.hidden = policy.features_extractor, policy.mlp_extractor.policy_net
        self.action = policy.action_net
        self.register_buffer("low", torch.tensor([-steering_max, SPEEDS[0]]))
        self.register_buffer("high", torch.tensor([steering_max, SPEEDS[1]]))

    def forward(self, observation):
        """Without the noise of learning."""
        action = self.action(self.hidden(self.features(observation))).clamp(-1.0, 1.0)
        return self.low + (action + 1.0) / 2.0 * (self.high - self.low)


def learn(place, steps, seed):
    """Return the model after so many steps of all environments together."""
    environments = make_vec_env(
        "F1Tenth-v0", n_envs=16, seed=seed, env_kwargs={"place": place, **DRIVING, **LEARNING}
    )
    model = PPO(
        "MlpPolicy",
        environments,
        n_steps=256,
        batch_size=512,
        n_epochs=10,
        gamma=0.99,
        learning_rate=3e-4,
        policy_kwargs={"features_extractor_class": Scaled, "net_arch": [64, 64]},
        seed=seed,
        device="cpu",
        verbose=1,
    )
    return model.learn(steps)


def save(driver, file):
    """Write the policy as ONNX: input observation (1, 112), output action (1, 2), both float32."""
    example = torch.zeros((1, BEAMS + len(VELOCITIES)))
    torch.onnx.export(
        driver, (example,), file, input_names=["observation"], output_names=["action"], external_data=False
    )
    model = onnx.load(file)
    for node in model.graph.node:  # which say where on this machine they were made
        node.ClearField("metadata_props")
    onnx.save(model, file)


def lap(driver, place, seed):
    """Drive a lap from the grid; return its time, s, or None after a contact."""
    environment = gymnasium.make("F1Tenth-v0", place=place, laps=1, **{**DRIVING, "normalized": False})
    observation, info = environment.reset(seed=seed)
    ended = False
    while not ended:
        with torch.no_grad():
            action = driver(torch.from_numpy(observation[None]))[0].numpy()
        observation, _, terminated, truncated, info = environment.step(action)
        ended = terminated or truncated
    return float(info["time"]) if info["laps"][0] == 1 and not info["contact"][0] else None


def main():
    """Learn, try, save."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--place", default="circuit1")
    parser.add_argument("--steps", type=int, default=400_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--output", default="policy.onnx")
    options = parser.parse_args()
    torch.set_num_threads(1)  # such small networks only wait for each other in several
    register()
    begun, used = time.monotonic(), time.process_time()
    model = learn(options.place, options.steps, options.seed)
    print(f"learned in {time.monotonic() - begun:.0f} s, {time.process_time() - used:.0f} s of processor")
    steering_max = float(
        gymnasium.make("F1Tenth-v0", place=options.place, normalized=False).action_space.high[0]
    )
    driver = Driver(model.policy, steering_max).eval()
    laps = [lap(driver, options.place, seed) for seed in range(10)]
    driven = [each for each in laps if each]
    average = f", {np.mean(driven):.2f} s on average" if driven else ""
    print(f"{len(driven)} of {len(laps)} laps without contact{average}")
    save(driver, options.output)


if __name__ == "__main__":
    main()
