"""Racer: laps of environments without ROS."""

from pathlib import Path

import f1tenth_racer_core as core
import gymnasium
import numpy as np
import pytest
import yaml
from f1tenth_sim2d.environments import register
from test_tracks import MAPS, load_map, poses_of_goals

CONFIG = Path(__file__).resolve().parents[3] / "f1tenth_navigation" / "config" / "racer.yaml"
LIDAR_X = 0.275  # m ahead of the rear axle
PARTS = ("scan", "pose", "velocity")


def shipped_options():
    """The options of the racer as f1tenth_navigation sets them."""
    values = yaml.safe_load(CONFIG.read_text())["RacerROS"]
    names = {name for name, *_ in core.RacerOptions.table()}
    known = {name: value for name, value in values.items() if name in names}
    return core.RacerOptions(dec_lim_x=values["acc_lim_x"], **known)


def drive(racer, env, seed):
    """One episode; the last info and all speeds, m/s."""
    observation, info = env.reset(seed=seed)
    racer.reset()
    speeds = []
    finished = False
    while not finished:
        observation, _, terminated, truncated, info = env.step(np.array(racer.plan(observation), np.float32))
        speeds.append(float(observation["velocity"][0]))
        finished = terminated or truncated
    return info, speeds


@pytest.fixture(scope="module")
def circuit():
    register()
    with gymnasium.make(
        "F1Tenth-v0", place="circuit1", observation=PARTS, beams=271, normalized=False, laps=1, max_time=30
    ) as env:
        yield env


@pytest.fixture(scope="module")
def racer():
    goals = poses_of_goals("circuit1")
    return core.Racer(load_map(MAPS / "circuit1.yaml"), goals, shipped_options(), lidar_x=LIDAR_X)


def test_a_lap_of_a_circuit_is_driven_at_speed_without_a_contact(racer, circuit):
    info, speeds = drive(racer, circuit, seed=1)
    assert info["laps"][0] == 1
    assert not info["contact"][0]
    assert max(speeds) > 4.0


def test_the_same_episode_is_driven_the_same_way(racer, circuit):
    first, second = (drive(racer, circuit, seed=2) for _ in range(2))
    assert first[1] == second[1]


def test_an_observation_without_the_pose_is_refused(racer):
    with pytest.raises(core.OptionError, match="has no part 'pose'; needed: scan, pose, velocity"):
        racer.plan({"scan": np.ones(271), "velocity": np.zeros(3)})


def test_goals_are_needed():
    with pytest.raises(core.OptionError, match="goals: found 0"):
        core.Racer(load_map(MAPS / "circuit1.yaml"), np.zeros((0, 3)))
