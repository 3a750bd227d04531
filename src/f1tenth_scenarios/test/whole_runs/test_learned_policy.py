"""A policy drives in the environment as it does through ROS: the same trajectory, bit for bit."""

import json
import subprocess
import sys

import gymnasium
import numpy as np
import pytest
from f1tenth_judge.places import lookup
from f1tenth_judge.record.record import read_record
from f1tenth_sim2d.environments import ENVIRONMENT, register
from patience import PATIENCE

register()
onnxruntime = pytest.importorskip("onnxruntime", reason="no onnxruntime, which runs the policy")

EXAMPLES = lookup.package_path("f1tenth_sim2d") / "examples"
SEED = 1  # of a race


def race(folder):
    """Race a lap through ROS; return its record."""
    command = [sys.executable, "-m", "f1tenth_judge", "race", "circuit1", "--laps", "1"]
    command += ["--planner", str(EXAMPLES / "policy.launch"), "--results", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=3 * PATIENCE)
    assert done.returncode == 0, done.stdout + done.stderr
    (result,) = folder.glob("*/result.json")
    assert json.loads(result.read_text(encoding="utf-8"))["verdict"] == "success"
    return read_record(result.with_name("trajectory.csv")).tracks["robot1"]


def episode(folder, periods):
    """Drive in the environment as long; return its record."""
    policy = onnxruntime.InferenceSession(str(EXAMPLES / "circuit1.onnx"))
    environment = gymnasium.make(
        ENVIRONMENT,
        place="circuit1",
        beams=1081,
        observation=("scan", "velocity"),
        normalized=False,
        record=folder,
    )
    observation, _ = environment.reset(options={"poses": [[0.0, 0.0, 0.0]], "noise_seed": SEED})
    action = np.zeros(2, np.float32)  # nobody has answered before the first scan
    for _ in range(periods):
        observation, *_ = environment.step(action)
        seen = np.concatenate([observation["scan"][::10], observation["velocity"]])
        action = policy.run(None, {"observation": seen[None]})[0][0]
    environment.close()
    return read_record(folder / "episode_0001" / "trajectory.csv").tracks["robot1"]


def test_both_drive_the_same(tmp_path):
    raced = race(tmp_path / "race")
    driven = episode(tmp_path / "episodes", len(raced.time))
    assert len(raced.time) > 200
    assert driven.rows == raced.rows
