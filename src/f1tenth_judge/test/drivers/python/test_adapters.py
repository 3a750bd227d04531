"""Planners of f1tenth_gym and learned policies are raced as the classes that the judge knows."""

import json
from pathlib import Path

import numpy as np
import pytest
from f1tenth_judge.drivers.python.policies import Sb3Policy, seen
from f1tenth_judge.drivers.starting import start_drivers
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.gym_planner import features_of, original_of
from f1tenth_judge.plan.named_planner import named_planner
from f1tenth_judge.plan.race import Race, plan_race
from f1tenth_judge.planner import Observation, Scan
from f1tenth_judge.run.execute import execute
from f1tenth_judge.stop_request import StopRequest

HERE = Path(__file__).parent
POLICY = HERE.parents[3] / "f1tenth_sim2d" / "examples" / "circuit1.onnx"
SCAN = Scan(np.full(1081, np.inf, np.float32), -2.356, 0.00436, 0.06, 10.0)
OBSERVATION = Observation(1.5, SCAN, (1.0, 2.0, np.pi / 2), (3.0, 0.1, 0.5), 0.2, np.zeros((5, 3)))


@pytest.fixture
def race(tmp_path):
    """Races a planner around circuit1, and gives what is in result.json."""

    def run(name, arguments=None, timeout=40):
        planner = named_planner(name, HERE, arguments=arguments or {})
        plan = plan_race(Race("circuit1", 1, [planner]), tmp_path, [f"limits.timeout={timeout}"])
        execute(plan, start_drivers, StopRequest())
        return json.loads((tmp_path / "result.json").read_text(encoding="utf-8"))

    return run


def test_planners_of_both_versions_of_f1tenth_gym_drive_the_same_lap(race):
    results = [race(f"gym_planners.py:{name}") for name in ("Original", "Features", "SpeedFirst")]
    assert [each["verdict"] for each in results] == ["success"] * 3
    assert len({each["trajectory_hash"] for each in results}) == 1


def test_what_f1tenth_gym_tells_of_a_car():
    features = features_of(OBSERVATION)["agent_0"]
    assert (features["pose_x"], features["pose_y"]) == pytest.approx((1.0, 2.17145))
    assert features["linear_vel_y"] == pytest.approx(0.1 + 0.17145 * 0.5)
    assert (features["delta"], features["lap_time"]) == pytest.approx((0.2, 1.5))
    assert (features["scan"] == 10.0).all()
    rows = original_of(OBSERVATION)
    assert (rows["ego_idx"], rows["scans"].shape, rows["linear_vels_x"].tolist()) == (0, (1, 1081), [3.0])


def test_a_policy_in_onnx_drives_a_lap(race):
    pytest.importorskip("onnxruntime")
    assert race(str(POLICY))["verdict"] == "success"


def test_a_policy_sees_ranges_at_even_steps_and_the_velocity():
    row = seen(OBSERVATION, 112)
    assert (row.dtype, row.shape, row[:109].tolist()) == (np.float32, (112,), [10.0] * 109)
    assert row[109:].tolist() == pytest.approx([3.0, 0.1, 0.5])
    with pytest.raises(ValueError, match="takes 1000 numbers: 997 ranges and 3 velocities"):
        seen(OBSERVATION, 1000)


def test_a_policy_of_stable_baselines3_is_loaded_and_scaled(race, tmp_path):
    library = pytest.importorskip("stable_baselines3")
    gymnasium = pytest.importorskip("gymnasium")

    class Standing(gymnasium.Env):
        observation_space = gymnasium.spaces.Box(-10.0, 10.0, (112,))
        action_space = gymnasium.spaces.Box(-1.0, 1.0, (2,))

    library.PPO("MlpPolicy", Standing(), device="cpu").save(tmp_path / "policy.zip")
    policy = Sb3Policy()
    policy.reset({"policy": str(tmp_path / "policy.zip"), "speed_min": "1", "speed_max": "3"})
    answer = policy.plan(OBSERVATION)
    assert 1.0 <= answer.speed <= 3.0
    assert abs(answer.steering_angle) <= 0.4189
    assert race(str(tmp_path / "policy.zip"), timeout=0.2)["verdict"] == "timeout"


def test_a_policy_that_is_not_there_is_named():
    with pytest.raises(ScenarioError, match="none.onnx: no such file: .*; allowed: .* POLICY.onnx, "):
        named_planner("none.onnx", HERE)
