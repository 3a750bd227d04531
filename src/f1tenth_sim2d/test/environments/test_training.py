"""The example of learning runs, and what it saves is what it has learned."""

import importlib.util
from pathlib import Path

import gymnasium
import numpy as np
import pytest

pytest.importorskip("stable_baselines3", reason="no stable-baselines3")
torch = pytest.importorskip("torch", reason="no torch")
onnxruntime = pytest.importorskip("onnxruntime", reason="no onnxruntime")

EXAMPLE = Path(__file__).parents[2] / "examples" / "train_ppo.py"


def example():
    spec = importlib.util.spec_from_file_location("train_ppo", EXAMPLE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_saved_policy_is_the_learned_one(tmp_path):
    train_ppo = example()
    driver = train_ppo.Driver(train_ppo.learn("circuit1", 4096, seed=1).policy, 0.4).eval()
    train_ppo.save(driver, str(tmp_path / "policy.onnx"))
    assert str(Path.home()).encode() not in (tmp_path / "policy.onnx").read_bytes()
    policy = onnxruntime.InferenceSession(str(tmp_path / "policy.onnx"))
    environment = gymnasium.make("F1Tenth-v0", place="circuit1", **train_ppo.DRIVING)
    observation, _ = environment.reset(seed=1)
    (action,) = policy.run(None, {"observation": observation[None]})
    learned = driver(torch.from_numpy(observation[None])).detach().numpy()
    assert action == pytest.approx(learned, abs=1e-5)
    assert (np.abs(action[0, 0]) <= 0.4) & (0.5 <= action[0, 1] <= 4.0)
